"""Builds the node groups of a folder's recipes twice, as a user may, and checks them.

Runs inside Blender, in a folder that `lumaknot shader --lang blender` wrote to; argument after --:
that folder. Prints one line; a defect is an exception.
"""

import glob
import json
import os
import sys

import bpy

FOLDER = sys.argv[sys.argv.index("--") + 1]
sys.path.insert(0, FOLDER)
import lumaknot_nodes  # noqa: E402  (it is in the folder)


def interface(group, direction):
    """The names and defaults of a group's inputs or outputs; None without a default."""
    if bpy.app.version < (4, 0):
        sockets = getattr(group, direction.lower() + "s")
    else:
        sockets = [item for item in group.interface.items_tree if item.in_out == direction]
    return {socket.name: getattr(socket, "default_value", None) for socket in sockets}


def plain(value):
    """A socket's default as in JSON."""
    return value if isinstance(value, float) else list(value)


def check(path):
    """Checks one recipe: the group's sockets are the recipe's, its nodes exist and are linked."""
    with open(path, encoding="utf-8") as stream:
        recipe = json.load(stream)
    first = lumaknot_nodes.load(path)
    group = lumaknot_nodes.load(path)
    assert group.name == recipe["name"], f"{first.name}, then {group.name}"
    inputs = interface(group, "INPUT")
    assert list(inputs) == [entry["name"] for entry in recipe["inputs"]], list(inputs)
    for entry in recipe["inputs"]:
        if "default" not in entry:
            continue
        expected = entry["default"] if isinstance(entry["default"], list) else [entry["default"]]
        found = plain(inputs[entry["name"]])
        found = found if isinstance(found, list) else [found]
        # Sockets hold float32.
        assert all(abs(a - b) <= 1e-6 * max(1, abs(b)) for a, b in zip(found, expected)), entry
    assert list(interface(group, "OUTPUT")) == [recipe["output_name"]]
    assert len(group.nodes) >= len([n for n in recipe["nodes"] if "type" in n])
    assert all(link.is_valid for link in group.links) and group.links


def main():
    """Checks every recipe of the folder."""
    paths = sorted(glob.glob(os.path.join(FOLDER, "*.nodes.json")))
    for path in paths:
        check(path)
    assert paths, "no recipe"
    print(f"{len(paths)} groups in Blender {bpy.app.version_string}")


main()
