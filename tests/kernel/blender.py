"""Runs shaders in Cycles on rows of numbers, one pixel per row.

    blender -b --factory-startup --python blender.py -- JOB.json
    python blender.py -- JOB.json        (a Python that has bpy)

JOB.json: {"shaders": [SHADER, ...]}. Each SHADER has the keys below; those that all
share may be given next to "shaders". Paths are relative to JOB.json.

  "count"   rows
  "names"   [{"name": "shininess", "type": "float" | "vector"}, ...]
  "inputs"  file of float32: for each name in turn, `count` x 4, a vector in the first
            three, a float in the first
  "recipe"  file of Blender nodes, or "osl", a shader in Open Shading Language
  "output"  file to write: float32, `count` x 3

A shader in OSL needs a Blender built with OSL, such as the bpy of PyPI.
"""

import array
import glob
import json
import os
import shutil
import sys
import tempfile

import bpy
import _cycles

TESTS = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(TESTS, "..", "..", "exporters", "blender"))
sys.dont_write_bytecode = True
import scene as blender_scene  # noqa: E402
import lumaknot_nodes  # noqa: E402

WIDTH = 64  # pixels
MIN_HEIGHT = 4  # Blender's own limit
VALUE_SOCKET = {"float": "Fac", "vector": "Vector"}  # of the Attribute node


def grid(columns, rows):
    """A mesh of unit squares in the xy plane, row by row from the origin."""
    mesh = bpy.data.meshes.new("grid")
    vertices = [(x, y, 0) for y in range(rows + 1) for x in range(columns + 1)]
    step = columns + 1
    corners = [y * step + x for y in range(rows) for x in range(columns)]
    mesh.from_pydata(vertices, [], [(c, c + 1, c + 1 + step, c + step) for c in corners])
    return mesh


def add_camera(columns, rows):
    """Looks down on the grid, one pixel per square."""
    data = bpy.data.cameras.new("camera")
    data.type, data.sensor_fit, data.ortho_scale = "ORTHO", "HORIZONTAL", columns
    camera = bpy.data.objects.new("camera", data)
    camera.location = (columns / 2, rows / 2, 1)
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def read_floats(path, count):
    """Reads exactly `count` float32."""
    values = array.array("f")
    with open(path, "rb") as stream:
        values.frombytes(stream.read())
    if len(values) != count:
        raise ValueError(f"{path}: {len(values)} numbers, expected {count}")
    return values


def attribute_name(index):
    """Name of an input's attribute; Blender keeps names like position for itself."""
    return f"input_{index}"


def add_attributes(mesh, shader):
    """Gives each square its row of every input. Attributes of faces are not interpolated."""
    count, names = shader["count"], shader["names"]
    values = read_floats(shader["inputs"], 4 * count * len(names))
    for index, spec in enumerate(names):
        block = values[4 * count * index:4 * count * (index + 1)]
        is_vector = spec["type"] == "vector"
        width = 3 if is_vector else 1
        padded = array.array("f", bytes(4 * width * len(mesh.polygons)))
        for component in range(width):
            padded[component:width * count:width] = block[component::4]
        attribute = mesh.attributes.new(attribute_name(index),
                                        "FLOAT_VECTOR" if is_vector else "FLOAT", "FACE")
        attribute.data.foreach_set("vector" if is_vector else "value", padded)


def group_node(tree, path):
    """The recipe's node group as a node."""
    node = tree.nodes.new("ShaderNodeGroup")
    node.node_tree = lumaknot_nodes.load(path)
    return node


def find_oslquery():
    """bpy 5.0 brings the module oslquery, which compiling OSL needs, but not on its path."""
    python = os.path.join(bpy.utils.resource_path("LOCAL"), "python", "lib")
    sys.path += glob.glob(os.path.join(python, "python3*", "site-packages"))


def script_node(tree, path, folder):
    """The OSL shader as a node. Blender writes the compiled shader next to the source."""
    if not _cycles.with_osl:
        raise ValueError("this Blender is built without OSL")
    source = shutil.copy(path, folder)
    node = tree.nodes.new("ShaderNodeScript")
    node.mode = "EXTERNAL"
    node.filepath = source
    if not node.outputs:
        raise ValueError(f"{path}: Blender did not compile it")
    return node


def input_socket(node, name):
    """The node's input of that name. A label in OSL renames the socket, not its identifier."""
    for item in node.inputs:
        if name in (item.name, item.identifier):
            return item
    raise ValueError(f"the shader has no input {name}")


def shader_material(shader, folder):
    """Emits what the shader computes of the attributes."""
    material = bpy.data.materials.new("kernel")
    if not material.node_tree:
        material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    if "osl" in shader:
        node = script_node(tree, shader["osl"], folder)
    else:
        node = group_node(tree, shader["recipe"])
    for index, spec in enumerate(shader["names"]):
        attribute = tree.nodes.new("ShaderNodeAttribute")
        attribute.attribute_name = attribute_name(index)
        source = lumaknot_nodes.socket(attribute.outputs, VALUE_SOCKET[spec["type"]])
        tree.links.new(source, input_socket(node, spec["name"]))
    emission = lumaknot_nodes.add_node(tree, "ShaderNodeEmission", {"Color": node.outputs[0]})
    lumaknot_nodes.add_node(tree, "ShaderNodeOutputMaterial", {"Surface": emission.outputs[0]})
    return material


def render(folder):
    """The picture's pixels: RGBA, from the bottom left."""
    path = os.path.join(folder, "kernel.exr")
    bpy.context.scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    pixels = array.array("f", bytes(4 * len(image.pixels)))
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels


def write_output(shader, pixels):
    """Writes the colours of the first `count` pixels."""
    count = shader["count"]
    if any(alpha != 1 for alpha in pixels[3:4 * count:4]):
        raise ValueError(f"{shader['output']}: a pixel is not covered")
    colours = array.array("f", bytes(12 * count))
    for channel in range(3):
        colours[channel::3] = pixels[channel:4 * count:4]
    with open(shader["output"], "wb") as stream:
        colours.tofile(stream)


def run_shader(shader):
    """Renders one shader of the job."""
    blender_scene.empty_scene()
    scene = bpy.context.scene
    rows = max(MIN_HEIGHT, -(-shader["count"] // WIDTH))
    blender_scene.set_output(scene, {"width": WIDTH, "height": rows})
    blender_scene.set_cycles(scene)
    scene.render.engine = "CYCLES"
    scene.cycles.shading_system = "osl" in shader
    add_camera(WIDTH, rows)
    mesh = grid(WIDTH, rows)
    add_attributes(mesh, shader)
    scene.collection.objects.link(bpy.data.objects.new("grid", mesh))
    with tempfile.TemporaryDirectory() as folder:
        mesh.materials.append(shader_material(shader, folder))
        write_output(shader, render(folder))


def read_job(path):
    """The shaders of the job, with their shared keys and full paths."""
    with open(path, encoding="utf-8") as stream:
        job = json.load(stream)
    folder = os.path.dirname(os.path.abspath(path))
    for own in job.get("shaders", [{}]):
        shader = {**job, **own}
        for key in ("inputs", "recipe", "osl", "output"):
            if key in shader:
                shader[key] = os.path.join(folder, shader[key])
        yield shader


def main():
    """Runs the job; exits with a one-line message if it is bad."""
    find_oslquery()
    try:
        for shader in read_job(sys.argv[sys.argv.index("--") + 1]):
            run_shader(shader)
    except (KeyError, OSError, ValueError) as error:
        sys.exit(f"{type(error).__name__}: {error}")


if __name__ == "__main__":
    main()
