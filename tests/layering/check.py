"""Checks the `#include "folder/..."` lines of every folder against the architecture's tables, that
OpenImageIO, which is slow to load, stays in its module, that folders stay small, and that namespaces follow them.

    check.py SOURCE_ROOT
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

ALL = ("system", "math", "models", "scene", "meshgen", "shaders", "exporters", "render", "diagnosis", "validate", "study", "cli")

# A folder, and what it may include besides itself.
ALLOWED = {
    "system": (),
    "math": (),
    "models": ("math",),
    "scene": ("system", "math", "models"),
    "meshgen": ("system", "math", "scene"),
    "shaders": ("system", "math", "models", "scene"),
    "exporters": ("system", "math", "models", "scene", "shaders"),
    "render": ("system", "math", "models", "scene", "shaders", "meshgen"),
    "diagnosis": ("system", "math", "models", "scene", "meshgen", "shaders", "render"),
    "validate": ("system", "math", "models", "scene", "meshgen", "exporters", "render", "shaders", "diagnosis"),
    "study": tuple(folder for folder in ALL if folder != "cli"),
    "cli": ALL,
    "tests": ALL,
    "bench": ALL,
}

# Within a folder: its subfolders, and which of their sisters each may include; "" is the folder
# itself, and "*" one that is not named.
SISTERS = {
    "shaders": {
        "formulas": ("graph", "spaces"),
        "graph": ("formulas",),
        "languages": ("graph",),
        "spaces": ("graph",),
    },
    "exporters": {
        "": (),
        "blender": ("", "image"),
        "gltf": ("", "image", "mesh"),
        "image": ("image/module",),
        "image/module": (),
        "mesh": ("text",),
        "obj": ("", "image", "mesh", "text"),
        "povray": ("", "image", "mesh", "text"),
        "text": (),
        "*": ("mesh", "text"),
    },
    "render": {"": (), "exact": ("",), "fast": ("",), "fast/kernels": ("fast",)},
    "diagnosis": {"": (), "*": ("",)},
    "validate": {
        "": ("compare", "renderers"),
        "compare": ("renderers",),
        "gpu": (),
        "renderers": (),
        "report": ("", "compare", "renderers"),
        "self_test": ("compare", "renderers"),
    },
    "study": {
        "measure": (),
        "bench": ("measure",),
        "budget": ("measure",),
        "chart": ("measure",),
        "paper": ("measure", "bench"),
        "plan": ("measure", "budget"),
        "stability": ("measure",),
    },
    "cli": {
        "": ("describe",),
        "commands": ("", "describe"),
        "describe": ("",),
        "main": ("",),
    },
}

# What other folders may include of a subfolder: everything, or these headers.
EVERYTHING = None
ENTRANCES = {
    "shaders/formulas": EVERYTHING,
    "shaders/graph": ("blender_nodes", "half", "shader", "uncertain"),
    "shaders/languages": ("backend", "emit", "functions"),
    "shaders/spaces": EVERYTHING,
    "exporters/blender": ("scene",),
    "exporters/gltf": ("scene",),
    "exporters/image": ("baked_texture", "file"),
    "exporters/mesh": ("file", "format"),
    "exporters/obj": ("scene",),
    "exporters/povray": ("scene",),
    "render/exact": ("pixels", "truth", "tube"),
    "render/fast": ("renderer", "sample_pattern", "simd_number"),
    "validate/compare": ("allowances", "claims", "flip", "images", "quantile", "sensitivity"),
    "validate/gpu": ("fields", "files", "mesh_file"),
    "validate/renderers": ("adapter", "entry", "blender_run", "external", "gpu_job", "job_files", "limits", "programs", "spirv"),
    "validate/report": ("forms", "page_kit"),
    "validate/self_test": ("self_test",),
    "study/bench": ("report", "scaling"),
    "study/budget": ("stages",),
    "study/chart": ("points",),
    "study/measure": ("gnuplot",),
    "study/paper": ("checkpoint", "reproduction"),
    "study/plan": ("outcome",),
    "study/stability": ("atlas_report", "regions"),
}

# Folders whose code, tests included, is in a namespace of its own within lumaknot. The others share lumaknot:
# they are the vocabulary of all.
NAMESPACES = {
    "exporters/blender": "blender",
    "exporters/gltf": "gltf",
    "exporters/obj": "obj",
    "exporters/off": "off",
    "exporters/om": "om",
    "exporters/ply": "ply",
    "exporters/povray": "povray",
    "exporters/stl": "stl",
    "render/exact": "exact",
    "render/fast": "fast",
    "diagnosis": "diagnosis",
    "validate": "validate",
    "validate/gpu": "gpu",
    "study/bench": "bench",
    "study/budget": "budget",
    "study/chart": "chart",
    "study/measure": "measure",
    "study/paper": "paper",
    "study/plan": "plan",
    "study/stability": "stability",
    "cli": "cli",
}

# What may include from every folder.
EVERYWHERE = ("tests",)

# What may include OpenImageIO.
IMAGE_FOLDERS = ("exporters/image/module", "tests")

MAX_SOURCES = 30  # per folder; a header and its source count as one

OPEN_IMAGE_IO = re.compile(r"\s*#\s*include\s*<OpenImageIO/")
NAMESPACE = re.compile(r"^namespace lumaknot(?:::(\w+))?[^{;]* \{", re.MULTILINE)
COMMON_NAMESPACES = {"embedded", "testing"}
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"/]+/[^"]+)"')


def forbidden(includer, included):
    """Why the file `includer` may not include `included`; empty if it may. Both are relative to the root."""
    folder, other = includer.parts[0], included.parts[0]
    if folder in EVERYWHERE or other not in ALLOWED:
        return ""
    here, there = ("/".join(path.parent.parts[1:]) for path in (includer, included))
    if folder != other:
        if other not in ALLOWED[folder]:
            may = ", ".join(ALLOWED[folder]) or "nothing"
            return f"{folder} must not include {other}; besides itself it may include: {may}"
        entrances = ENTRANCES.get(f"{other}/{there}", ()) if there else EVERYTHING
        if entrances is not EVERYTHING and included.stem not in entrances:
            may = ", ".join(f"{name}.h" for name in entrances) or "nothing"
            return f"other folders may only include from {other}/{there}: {may}"
        return ""
    sisters = SISTERS.get(folder)
    allowed = sisters.get(here, sisters.get("*", ())) if sisters else ()
    if sisters is None or here == there or there in allowed:
        return ""
    may = ", ".join(f"{folder}/{name}" for name in allowed) or "nothing"
    return f"{folder}/{here} must not include {folder}/{there}; besides itself it may include: {may}"


def include_violations(root):
    """Yields a line of text per include that the tables forbid."""
    for folder in ALLOWED:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".cpp", ".h"):
                continue
            name = path.relative_to(root)
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if OPEN_IMAGE_IO.match(line) and not name.as_posix().startswith(IMAGE_FOLDERS):
                    yield (f"{name}:{number}: only {' and '.join(IMAGE_FOLDERS)} may include "
                           "OpenImageIO")
                match = INCLUDE.match(line)
                why = forbidden(name, Path(match[1])) if match else ""
                if why:
                    yield f"{name}:{number}: {why}"


def singular(word):
    return word.removesuffix("s")


def folder_violations(root):
    """Yields a line of text per folder with too many files and per file named after its folder."""
    stems = defaultdict(set)
    for folder in ALLOWED:
        for path in (root / folder).rglob("*"):
            if path.suffix in (".cpp", ".h"):
                stems[path.parent.relative_to(root)].add(path.stem)
    for folder, names in sorted(stems.items()):
        if len(names) > MAX_SOURCES:
            yield f"{folder}: {len(names)} sources in one folder; more than {MAX_SOURCES} need subfolders"
        for name in sorted(names):
            if singular(folder.name) in map(singular, name.split("_")):
                yield f"{folder}/{name}: repeats the name of its folder"


def namespace_of(folder):
    """The namespace in lumaknot that the code in `folder` belongs to; empty if it shares lumaknot."""
    return next((NAMESPACES[str(f)] for f in (folder, *folder.parents) if str(f) in NAMESPACES), "")


def namespace_violations(root):
    """Yields a line of text per source that a wrong namespace of lumaknot is opened in."""
    for folder in ALLOWED:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root)
            wanted = namespace_of(Path(*name.parts[name.parts[0] == "tests":-1]))
            # Entries of a list stand in the namespace of the list.
            if path.suffix not in (".cpp", ".h") or not wanted or name.match("exporters/*/format.cpp"):
                continue
            opened = set(NAMESPACE.findall(path.read_text(encoding="utf-8"))) - COMMON_NAMESPACES
            if opened - {wanted}:
                yield f"{name}: belongs in namespace lumaknot::{wanted}"


def violations(root):
    """Yields a line of text per broken rule."""
    yield from include_violations(root)
    yield from folder_violations(root)
    yield from namespace_violations(root)


def check(violations_of, arguments, usage):
    """Prints what violations_of(root) yields for the only argument, SOURCE_ROOT; returns the exit status."""
    if len(arguments) != 1:
        sys.exit(usage)
    root = Path(arguments[0])
    missing = [folder for folder in ("scene", "render", "exporters") if not (root / folder).is_dir()]
    if missing:  # otherwise a wrong root would pass
        sys.exit(f"{root} is not the source root: it has no {missing[0]}/")
    found = list(violations_of(root))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(check(violations, sys.argv[1:], __doc__))
