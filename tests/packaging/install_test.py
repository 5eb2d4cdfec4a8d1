"""Installs into a prefix, moves it, and uses the installation.

    install_test.py SOURCE_ROOT BUILD_FOLDER CONFIGURATION
"""

import sys
import tempfile
from pathlib import Path

from installed import check_files, check_programs, run


def main(root, build, configuration):
    with tempfile.TemporaryDirectory() as folder:
        prefix, moved = Path(folder, "prefix"), Path(folder, "moved")
        run("cmake", "--install", build, "--config", configuration, "--prefix", prefix)
        prefix.rename(moved)
        check_programs(moved)
        check_files(moved, root)


if __name__ == "__main__":
    main(*sys.argv[1:])
