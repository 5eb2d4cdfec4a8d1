"""Checks that what is compiled for some processors can't be linked in place of what runs on all: an
inline function that a kernel's file shares with others is kept once, from whichever file the linker
likes.

    isolation_test.py OBJECT...
"""

import re
import subprocess
import sys

# Data and marks of the language, no code.
HARMLESS = re.compile(r"^(DW\.ref\.|typeinfo |vtable for |guard variable )")
SHARED = re.compile(r"^[0-9a-f]* [WVu] (.*)$")


def shared_code(path):
    """The names of functions of the file that the linker may take from it or from another."""
    listing = subprocess.run(["nm", "--demangle", "--defined-only", path], check=True,
                             capture_output=True, text=True).stdout
    names = [match[1] for match in map(SHARED.match, listing.splitlines()) if match]
    return [name for name in names if not HARMLESS.match(name) and "xsimd::" not in name]


def main(paths):
    kernels = [path for path in paths if "/kernels/avx" in path]
    if not kernels:
        sys.exit("no kernel's object file was given")
    found = [(path, name) for path in kernels for name in shared_code(path)]
    for path, name in found:
        print(f"{path}: {name} is shared; make it a template over the instructions, or no inline")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
