"""Checks that every source file is formatted by clang-format.

    check_format.py CLANG_FORMAT SOURCE_ROOT
"""

import subprocess
import sys
from pathlib import Path

from check import ALLOWED


def sources(root):
    return [path for folder in ALLOWED for path in sorted((root / folder).rglob("*"))
            if path.suffix in (".cpp", ".h")]


def is_formatted(clang_format, path):
    done = subprocess.run([clang_format, "--style=file", "--dry-run", "-Werror", str(path)],
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return done.returncode == 0


def main(arguments):
    if len(arguments) != 2:
        sys.exit(__doc__)
    clang_format, root = arguments[0], Path(arguments[1])
    files = sources(root)
    if not files:  # otherwise a wrong root would pass
        sys.exit(f"{root} is not the source root: it has no sources")
    offenders = [path for path in files if not is_formatted(clang_format, path)]
    for path in offenders:
        print(f"{path.relative_to(root)}:1: not formatted; run {Path(clang_format).name} -i on it")
    return 1 if offenders else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
