"""Builds lumaknot's shaders as node groups in Blender 3.4 to 5.x.

    blender --python lumaknot_nodes.py -- yiq-phong.nodes.json --save groups.blend

Without files it takes every *.nodes.json beside this script. A group made before
under the same name is replaced where it is used. Each group then stands in the
Add menu of the shader editor, under Group.

Into the vector inputs go what the shader reads of the surface:
  position  Geometry, Position
  normal    an Attribute node with the mesh's normals; or Geometry, Normal, which is
            turned to the side that is seen
  texture   Image Texture, Color; the image's colour space is Non-Color
The other inputs are the shader's parameters, in world space and colours as they
are. The output goes into an Emission; set the view transform to Raw.
"""

import argparse
import glob
import json
import os
import sys

import bpy

COLUMN_WIDTH = 200
ROW_HEIGHT = 190
SOCKET_TYPES = {"float": "NodeSocketFloat", "vector": "NodeSocketVector"}
OWN_MARK = "lumaknot_shader"  # a property of the groups made here: the shader's name
BAD_ENTRY = (AttributeError, KeyError, RuntimeError, TypeError, ValueError)  # what bpy raises


def beside_script(name):
    """Path of a file next to this script, also when run from the text editor."""
    text = bpy.data.texts.get(os.path.basename(__file__))
    script = bpy.path.abspath(text.filepath) if text and text.filepath else __file__
    return os.path.join(os.path.dirname(os.path.abspath(script)), name)


def reason(error):
    """What went wrong, in one line."""
    if isinstance(error, OSError):
        return error.strerror
    return f"{error} is missing" if isinstance(error, KeyError) else " ".join(str(error).split())


def bad_entry(place, entry, error):
    """The error that names an entry of a recipe."""
    return ValueError(f"{place} {json.dumps(entry)}: {reason(error)}")


def socket(sockets, identifier):
    """Finds a node's socket by its identifier."""
    for item in sockets:
        if item.identifier == identifier:
            return item
    known = ", ".join(item.identifier for item in sockets)
    raise ValueError(f"no socket {identifier!r}; there are: {known}")


def add_node(tree, kind, inputs, operation=None):
    """Adds a node; an input is an output socket to link or a default value."""
    node = tree.nodes.new(kind)
    if operation:
        node.operation = operation
    for identifier, value in inputs.items():
        target = socket(node.inputs, identifier)
        if isinstance(value, bpy.types.NodeSocket):
            tree.links.new(value, target)
        else:
            target.default_value = value
    return node


def constant_output(tree, entry):
    """Output socket of a number or a vector."""
    if "value" in entry:
        output = tree.nodes.new("ShaderNodeValue").outputs[0]
        output.default_value = entry["value"]
        return output
    inputs = dict(zip("XYZ", entry["vector"]))
    return add_node(tree, "ShaderNodeCombineXYZ", inputs).outputs[0]


def output_at(done, index):
    """The output of an entry built before."""
    if not isinstance(index, int) or not 0 <= index < len(done):
        raise ValueError(f"there is no entry {index!r} before")
    return done[index]


def source_value(source, done):
    """What a socket reads: a number, or the output of one of the entries before."""
    return source["const"] if "const" in source else output_at(done, source["node"])


def entry_output(tree, entry, done, read_input):
    """Adds one entry of a recipe; `done` are the outputs of those before."""
    if "input" in entry:
        return read_input(entry["input"])
    if "type" in entry:
        inputs = {name: source_value(source, done) for name, source in entry["sockets"].items()}
        node = add_node(tree, entry["type"], inputs, entry.get("operation"))
        output = socket(node.outputs, entry["output"])
    else:
        output = constant_output(tree, entry)
    output.node.label = entry.get("label", "")
    return output


def recipe_output(tree, recipe, read_input):
    """Adds the recipe's nodes; `read_input` gives the output socket of an input."""
    done = []
    for index, entry in enumerate(recipe["nodes"]):
        try:
            done.append(entry_output(tree, entry, done, read_input))
        except BAD_ENTRY as error:
            raise bad_entry(f"nodes[{index}]", entry, error) from error
    try:
        return output_at(done, recipe["output"])
    except ValueError as error:
        raise ValueError(f"output: {error}") from error


def lay_out(tree):
    """Arranges the nodes, which come in dependency order, in columns by depth."""
    columns, heights = {}, {}
    for node in tree.nodes:
        sources = [link.from_node.name for item in node.inputs for link in item.links]
        column = 1 + max((columns[name] for name in sources), default=-1)
        row = heights.get(column, 0)
        columns[node.name], heights[column] = column, row + 1
        node.location = (column * COLUMN_WIDTH, -row * ROW_HEIGHT)


def add_interface(tree, name, in_out, kind, spec):
    """Adds a socket to the group, with what `spec` says of default, range and meaning."""
    description = spec.get("meaning", "")
    if hasattr(tree, "interface"):  # Blender 4.0 and later
        item = tree.interface.new_socket(name, description=description, in_out=in_out,
                                         socket_type=kind)
    else:
        item = (tree.inputs if in_out == "INPUT" else tree.outputs).new(kind, name)
        item.description = description
    for key in ("min", "max", "default"):
        if key in spec:
            setattr(item, f"{key}_value", spec[key])
    item.hide_value = "default" not in spec


def add_inputs(tree, inputs):
    """Adds the group's inputs; returns the function that finds one by its name."""
    for index, spec in enumerate(inputs):
        try:
            if spec["type"] not in SOCKET_TYPES:
                raise ValueError(f"type is none of {', '.join(SOCKET_TYPES)}")
            add_interface(tree, spec["name"], "INPUT", SOCKET_TYPES[spec["type"]], spec)
        except BAD_ENTRY as error:
            raise bad_entry(f"inputs[{index}]", spec, error) from error
    outputs = tree.nodes.new("NodeGroupInput").outputs
    found = {spec["name"]: output for spec, output in zip(inputs, outputs)}
    if len(found) < len(inputs):
        raise ValueError("two inputs have the same name")

    def read(name):
        if name not in found:
            raise ValueError(f"unknown input {name!r}; there are: {', '.join(found)}")
        return found[name]

    return read


def fill_group(tree, recipe):
    """Builds the recipe in an empty node tree."""
    output = recipe_output(tree, recipe, add_inputs(tree, recipe["inputs"]))
    add_interface(tree, recipe["output_name"], "OUTPUT", "NodeSocketColor", {})
    tree.links.new(output, tree.nodes.new("NodeGroupOutput").inputs[0])
    lay_out(tree)


def build_group(recipe):
    """Makes the recipe's node group; it takes the place of one made here before.

    Returns the bpy.types.ShaderNodeTree. A ValueError says which entry is bad.
    """
    name = recipe["name"]
    before = [group for group in bpy.data.node_groups
              if group.get(OWN_MARK) == name and not group.library]
    tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
    try:
        fill_group(tree, recipe)
    except Exception:
        bpy.data.node_groups.remove(tree)
        raise
    names = [name, *(group.name for group in before)]
    for group in before:
        group.user_remap(tree)
        bpy.data.node_groups.remove(group)
    if tree.name != name:  # as long as somebody else's group has the name
        tree.name = next((free for free in names if free not in bpy.data.node_groups), tree.name)
    tree[OWN_MARK] = name
    tree.use_fake_user = True
    return tree


def load(path):
    """Makes the node group of a recipe file. A ValueError says what is bad in it."""
    try:
        with open(path, encoding="utf-8") as stream:
            return build_group(json.load(stream))
    except (OSError, *BAD_ENTRY) as error:
        raise ValueError(f"{path}: {reason(error)}") from error


def load_all(arguments):
    """Builds the groups of the given recipe files, and saves what was asked for."""
    parser = argparse.ArgumentParser(prog=os.path.basename(__file__))
    parser.add_argument("recipes", nargs="*", metavar="RECIPE.nodes.json")
    parser.add_argument("--save", metavar="FILE.blend")
    options = parser.parse_args(arguments)
    paths = options.recipes or sorted(glob.glob(beside_script("*.nodes.json")))
    if not paths:
        raise ValueError(f"{beside_script('*.nodes.json')}: no such file")
    for path in paths:
        print(f"lumaknot: made the node group {load(path).name}")
    if options.save:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(options.save))


def run_program():
    """Runs as a script. In an open Blender, where exiting would close it, errors are raised."""
    try:
        load_all(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    except ValueError as error:
        if not bpy.app.background:
            raise
        sys.exit(str(error))


if __name__ == "__main__":
    run_program()
