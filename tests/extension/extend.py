"""Copies the sources of lumaknot and adds a toy of each kind, as docs/CONTRIBUTING.md says: one new file, and
its registration in the list of its kind.

    extend.py SOURCE_ROOT COPY
"""

import os
import re
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).parent

# A toy's file, the file it becomes, and the list it is registered in.
TOYS = (
    ("toy_model.h", "models/toy.h", "models/list.h"),
    ("toy_language.cpp", "shaders/languages/toy.cpp", "shaders/languages/list.h"),
    ("toy_format.cpp", "exporters/toy/format.cpp", "exporters/mesh/list.h"),
    ("toy_renderer.cpp", "validate/renderers/toy.cpp", "validate/renderers/list.h"),
)


def registered(text):
    """The list `text` with Toy as its last entry; headers among its includes."""
    if '#include "models/' in text:
        text = re.sub(r'((?:#include "models/\w+\.h"\n)+)', r'\1#include "models/toy.h"\n', text, count=1)
    entry = re.search(r"#define LUMAKNOT_\w+\((\w+)\)", text)[1]
    return text.rstrip() + f" {entry}(Toy)\n"


def not_sources(names):
    """Of the names in the root: hidden ones, those of the tests and of what builds and runs leave there."""
    return [name for name in names if name.startswith(".") or name in ("build", "report", "tests")]


def extend(root, copy):
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(root, copy, ignore=lambda folder, names: not_sources(names) if Path(folder) == root else ())
    for toy, place, entries in TOYS:
        (copy / place).parent.mkdir(exist_ok=True)
        shutil.copy2(HERE / toy, copy / place)
        path = copy / entries
        before = path.stat()
        path.write_text(registered(path.read_text(encoding="utf-8")), encoding="utf-8")
        # As old as it was, so that a build of an earlier copy compiles only what has changed.
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))


if __name__ == "__main__":
    extend(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve())
