"""Checks the `#include "folder/..."` lines of every folder against the architecture's table, and that
OpenImageIO, which is slow to load, stays in the module made for it.

    check.py SOURCE_ROOT
"""

import re
import sys
from pathlib import Path

ALL = ("scene", "meshgen", "shaders", "exporters", "render", "validate", "study", "cli")

# A folder, and what it may include besides itself.
ALLOWED = {
    "scene": (),
    "meshgen": ("scene",),
    "shaders": ("scene",),
    "exporters": ("scene", "shaders"),
    "render": ("scene", "shaders", "meshgen"),
    "validate": ("scene", "exporters", "render", "shaders"),
    "study": tuple(folder for folder in ALL if folder != "cli"),
    "cli": ALL,
    "tests": ALL,
    "bench": ALL,
}

# Who may include OpenImageIO.
IMAGE_FOLDERS = ("exporters/images", "tests")

OPEN_IMAGE_IO = re.compile(r"\s*#\s*include\s*<OpenImageIO/")
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"/]+)/')


def violations(root):
    """Yields one line of text for each include that the table forbids."""
    for folder, allowed in ALLOWED.items():
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".cpp", ".h"):
                continue
            name = path.relative_to(root)
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if OPEN_IMAGE_IO.match(line) and not name.as_posix().startswith(IMAGE_FOLDERS):
                    yield (f"{name}:{number}: only {' and '.join(IMAGE_FOLDERS)} may include "
                           "OpenImageIO")
                match = INCLUDE.match(line)
                if not match or match[1] not in ALLOWED:
                    continue
                if match[1] != folder and match[1] not in allowed:
                    may = ", ".join(allowed) or "nothing"
                    yield (f"{name}:{number}: {folder} must not include "
                           f"{match[1]}; besides itself it may include: {may}")


def check(violations_of, arguments, usage):
    """Prints what violations_of(root) yields for the one argument, SOURCE_ROOT; returns the exit status."""
    if len(arguments) != 1:
        sys.exit(usage)
    root = Path(arguments[0])
    missing = [folder for folder in ("scene", "render", "exporters") if not (root / folder).is_dir()]
    if missing:  # a wrong root would pass, having nothing to check
        sys.exit(f"{root} is not the source root: it has no {missing[0]}/")
    found = list(violations_of(root))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(check(violations, sys.argv[1:], __doc__))
