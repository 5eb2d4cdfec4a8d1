"""Packs a .deb and uses its contents. Its dependencies are on this machine, which built it.

    package_test.py SOURCE_ROOT BUILD_FOLDER CONFIGURATION
"""

import sys
import tempfile
from pathlib import Path

from installed import check, check_files, check_programs, run


def main(root, build, configuration):
    with tempfile.TemporaryDirectory() as folder:
        run("cpack", "-C", configuration, "--config", Path(build, "CPackConfig.cmake"), "-B", folder)
        (package,) = Path(folder).glob("lumaknot_*.deb")
        depends = run("dpkg-deb", "-f", package, "Depends")
        for library in ("libc6", "libopenimageio", "libopenmesh", "libtbb", "libfmt"):
            check(library in depends, f"{library} is a dependency; got {depends}")
        unpacked = Path(folder, "unpacked")
        run("dpkg-deb", "-x", package, unpacked)
        check_programs(unpacked / "usr")
        check_files(unpacked / "usr", root)


if __name__ == "__main__":
    main(*sys.argv[1:])
