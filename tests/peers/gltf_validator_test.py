"""Checks our .glb and .gltf files, meshes and whole scenes, with Khronos' validator.

    gltf_validator_test.py LUMAKNOT

LUMAKNOT is the program. Exit status 0: no errors and no warnings; 1: the messages are printed; 3:
no node or no validator.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import checks  # noqa: E402  (it is next to this script)

MESHES = {"knot": (), "tangents": ("--tangents",), "link": ("--p", 4, "--q", 6, "--tangents"),
          "three": ("--convention", "three"), "babylon": ("--convention", "babylon"),
          "small": ("--segments", 3, "--sides", 3), "large": ("--ring", 1e6, "--winding", 4e5)}
SCENES = {
    "point": {"lights": [{"point": {"position": [1, -2, 3], "quadratic": 0.2}}]},
    "directional": {"lights": [{"directional": {"direction": [0, 1, -1]}}]},
    "spot": {"lights": [{"spot": {"position": [0, -3, 3], "direction": [0, 1, -1],
                                  "inner_degrees": 10, "outer_degrees": 20}}]},
    "wide spot": {"lights": [{"spot": {"position": [0, 0, 3], "direction": [0, 0, -1],
                                       "inner_degrees": 120, "outer_degrees": 180}}]},
    "three colours": {"texture": {"color": [0.2, 0.5, 0.7]}, "lights": [
        {kind: {"color": color}} for kind, color in (
            ("point", [1, 0, 0]), ("directional", [0, 1, 0]), ("spot", [0, 0, 1]))]},
    "dark": {"lights": []},
}
SUFFIXES = (".glb", ".gltf")


def write_scene(program, folder, name, suffix):
    """Exports one of SCENES, or a built-in one."""
    source = name
    if name in SCENES:
        source = folder / f"{name}.json"
        source.write_text(json.dumps(SCENES[name]), encoding="ascii")
    path = folder / f"scene {name}{suffix}"
    checks.lumaknot(program, "export", source, "-o", path)
    return path


def files(program, folder):
    """Writes all files; yields their paths."""
    for suffix in SUFFIXES:
        for name, flags in MESHES.items():
            yield checks.write_knot(program, folder / f"{name}{suffix}", *flags)
        for name in ("figure2", *SCENES):
            yield write_scene(program, folder, name, suffix)


def main(arguments):
    """The command line."""
    if len(arguments) != 1:
        sys.exit(__doc__)
    checks.need("node", "nodejs")
    judge = Path(__file__).with_name("validate_gltf.mjs")
    with tempfile.TemporaryDirectory() as folder:
        paths = list(files(arguments[0], Path(folder)))
        environment = {**os.environ, "LUMAKNOT_PEERS": str(checks.peers_folder())}
        done = subprocess.run(["node", judge, *paths], env=environment, timeout=checks.SECONDS)
    print(f"{len(paths)} files")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
