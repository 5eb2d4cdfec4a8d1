"""OSL scripts as shader nodes, in a Blender built with OSL; stands above scene.py.

Blender compiles NAME.osl to NAME.oso beside it.
"""

import glob
import os
import sys

import bpy
import _cycles


def find_oslquery():
    """bpy 5.0 brings the module oslquery, which compiling OSL needs, but not on its path."""
    python = os.path.join(bpy.utils.resource_path("LOCAL"), "python", "lib")
    sys.path += glob.glob(os.path.join(python, "python3*", "site-packages"))


def pack_images():
    """Takes the textures' files into Blender.

    With OSL, Cycles leaves the files to OpenImageIO, which always takes mipmaps;
    packed images it samples itself, as with nodes.
    """
    for image in bpy.data.images:
        if image.source == "FILE" and not image.packed_file:
            image.pack()


def script_output(tree, shot, read_input):
    """Adds the shot's OSL script; `read_input` gives the output socket of an input.

    Returns None when it does not compile; the compiler has then printed why.
    """
    inputs = {identifier: read_input(name) for name, identifier in shot["inputs"].items()}
    pack_images()
    node = tree.nodes.new("ShaderNodeScript")
    node.mode = "EXTERNAL"
    node.filepath = beside_script(shot["osl"])
    if not node.outputs:
        return None
    for identifier, output in inputs.items():
        tree.links.new(output, socket(node.inputs, identifier))
    return node.outputs[0]


if not _cycles.with_osl:
    raise SystemExit("this Blender is built without OSL")
find_oslquery()
