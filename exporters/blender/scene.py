"""Builds the exported scene in Blender and optionally renders or saves it.

    blender -b --factory-startup --python knot.py -- --render final=final.exr

Run without arguments it only builds the scene. It replaces what is in the open
file. PARAMETERS, defined above, describes the scene; the functions that build
nodes, lumaknot_nodes.py, stand above too; the arrays and the textures lie
beside this script.
"""

import argparse
import array
import math
import os
import sys

import bpy
from mathutils import Matrix, Vector

NORMAL_ATTRIBUTE = "lumaknot_normal"


def read_array(stream, typecode, count):
    """Reads `count` little-endian 4-byte values. (Blender may come without numpy.)"""
    values = array.array(typecode)
    values.frombytes(stream.read(4 * count))
    if len(values) != count:
        raise ValueError(f"{stream.name} is too short")
    if sys.byteorder == "big":
        values.byteswap()
    return values


def read_mesh_arrays(spec):
    """Returns positions, normals, uvs and indices as flat arrays."""
    vertices, triangles = spec["vertices"], spec["triangles"]
    with open(beside_script(spec["file"]), "rb") as stream:
        positions = read_array(stream, "f", 3 * vertices)
        normals = read_array(stream, "f", 3 * vertices)
        uvs = read_array(stream, "f", 2 * vertices)
        indices = read_array(stream, "i", 3 * triangles)
        if stream.read(1):
            raise ValueError(f"{stream.name} is too long")
    if indices and not (0 <= min(indices) and max(indices) < vertices):
        raise ValueError(f"{stream.name} has an index out of range")
    return positions, normals, uvs, indices


def add_triangles(mesh, positions, indices):
    """Fills an empty mesh with vertices and smooth triangles."""
    mesh.vertices.add(len(positions) // 3)
    mesh.vertices.foreach_set("co", positions)
    mesh.loops.add(len(indices))
    mesh.loops.foreach_set("vertex_index", indices)
    count = len(indices) // 3
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", range(0, len(indices), 3))
    if not bpy.types.MeshPolygon.bl_rna.properties["loop_total"].is_readonly:
        mesh.polygons.foreach_set("loop_total", [3] * count)
    mesh.polygons.foreach_set("use_smooth", [True] * count)
    mesh.update(calc_edges=True)


def add_uvs(mesh, uvs, indices):
    """Blender keeps texture coordinates per triangle corner."""
    corners = array.array("f")
    for index in indices:
        corners.extend(uvs[2 * index:2 * index + 2])
    mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", corners)


def add_normals(mesh, normals):
    """Stores the normals twice: exactly for our shots, and for other materials.

    Blender's own custom normals have 16 bits and reach a shader renormalised and
    turned to the viewer, so the shots read a plain attribute instead.
    """
    attribute = mesh.attributes.new(NORMAL_ATTRIBUTE, "FLOAT_VECTOR", "POINT")
    attribute.data.foreach_set("vector", normals)
    if bpy.app.version < (4, 1):
        mesh.use_auto_smooth = True
    mesh.normals_split_custom_set_from_vertices(list(zip(*[iter(normals)] * 3)))


def add_mesh_object(spec):
    """Creates the knot, with one empty material slot."""
    positions, normals, uvs, indices = read_mesh_arrays(spec)
    mesh = bpy.data.meshes.new("knot")
    add_triangles(mesh, positions, indices)
    add_uvs(mesh, uvs, indices)
    add_normals(mesh, normals)
    mesh.materials.append(None)
    knot = bpy.data.objects.new("knot", mesh)
    bpy.context.scene.collection.objects.link(knot)
    return knot


def depth_range(spec, mesh):
    """Clip distances that just hold the mesh: a depth buffer is finest that way."""
    position, back = Vector(spec["position"]), Vector(spec["back"])
    depths = [(position - vertex.co).dot(back) for vertex in mesh.vertices]
    near = max(spec["near_depth"], min(depths) * 0.99)
    return near, max(max(depths) * 1.01, near * 2)


def add_camera(spec, mesh):
    """Places the camera; its columns are right, up and back."""
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle_y = math.radians(spec["fov_y_degrees"])
    data.clip_start, data.clip_end = depth_range(spec, mesh)
    camera = bpy.data.objects.new("camera", data)
    columns = [spec["right"], spec["up"], spec["back"], spec["position"]]
    camera.matrix_world = Matrix([list(row) for row in zip(*columns)]).to_4x4()
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def load_image(name):
    """Loads a texture as plain numbers, once."""
    image = bpy.data.images.load(beside_script(name), check_existing=True)
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "NONE"
    image.use_half_precision = False
    if not all(image.size):
        raise ValueError(f"{image.filepath} is not an image")
    return image


def vector_math(tree, operation, *operands):
    """Adds a Vector Math node and returns its output."""
    names = ("Vector", "Vector_001", "Vector_002")
    node = add_node(tree, "ShaderNodeVectorMath", dict(zip(names, operands)), operation)
    return socket(node.outputs, "Vector")


def image_colour(tree, image, interpolation, uv):
    """Samples the image at `uv`."""
    node = add_node(tree, "ShaderNodeTexImage", {"Vector": uv})
    node.image = image
    node.interpolation = interpolation
    node.extension = "REPEAT"
    return socket(node.outputs, "Color")


def bilinear_colour(tree, image, uv):
    """Blends four texels. Eevee's own linear filter always takes mipmaps."""
    size = (*image.size, 1)
    place = vector_math(tree, "MULTIPLY_ADD", uv, size, (-0.5, -0.5, 0))
    corner = vector_math(tree, "FLOOR", place)
    weight = add_node(tree, "ShaderNodeSeparateXYZ",
                      {"Vector": vector_math(tree, "SUBTRACT", place, corner)}).outputs

    def texel(right, up):
        centre = vector_math(tree, "ADD", corner, (right + 0.5, up + 0.5, 0))
        return image_colour(tree, image, "Closest", vector_math(tree, "DIVIDE", centre, size))

    def blend(start, end, amount):
        difference = vector_math(tree, "SUBTRACT", end, start)
        return vector_math(tree, "MULTIPLY_ADD", difference, amount, start)

    below, above = (blend(texel(0, up), texel(1, up), weight["X"]) for up in (0, 1))
    return blend(below, above, weight["Y"])


def texture_colour(tree, spec, by_texels):
    """Output socket with the colour of a texture, or of the surface as a whole."""
    if "file" not in spec:
        return constant_output(tree, {"vector": spec["color"]})
    image = load_image(spec["file"])
    node = tree.nodes.new("ShaderNodeUVMap")
    node.uv_map = "UVMap"
    if by_texels:
        return bilinear_colour(tree, image, node.outputs[0])
    return image_colour(tree, image, "Linear", node.outputs[0])


def input_output(tree, name, shot, by_texels):
    """Output socket of one of the shot's inputs."""
    if name in ("texture", "texture_axes"):
        return texture_colour(tree, shot[name], by_texels)
    if name == "position":
        return socket(tree.nodes.new("ShaderNodeNewGeometry").outputs, "Position")
    if name != "normal":
        raise ValueError(f"unknown input {name}")
    node = tree.nodes.new("ShaderNodeAttribute")
    node.attribute_name = NORMAL_ATTRIBUTE
    return socket(node.outputs, "Vector")


def shot_output(tree, shot, by_texels):
    """Output socket with the shot's colour, of nodes or of one OSL script, or None."""
    def read_input(name):
        return input_output(tree, name, shot, by_texels)

    build = script_output if "osl" in shot else recipe_output
    return build(tree, shot, read_input)


def add_material(shot, by_texels):
    """Creates the material that emits the shot's colour; None when its shader is bad."""
    material = bpy.data.materials.new(shot["name"])
    material.use_fake_user = True
    if not material.node_tree:
        material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = shot_output(tree, shot, by_texels)
    if not output:
        return None
    emission = add_node(tree, "ShaderNodeEmission", {"Color": output})
    add_node(tree, "ShaderNodeOutputMaterial", {"Surface": emission.outputs[0]})
    lay_out(tree)
    return material


def set_known(settings, **values):
    """Sets those options that this version of Blender still has."""
    for name, value in values.items():
        if hasattr(settings, name):
            setattr(settings, name, value)


def set_output(scene, size):
    """Makes renders plain linear numbers, with coverage as alpha."""
    render = scene.render
    render.resolution_x, render.resolution_y = size["width"], size["height"]
    render.resolution_percentage = 100
    render.pixel_aspect_x = render.pixel_aspect_y = 1
    render.film_transparent = True
    render.dither_intensity = 0
    render.use_compositing = render.use_sequencer = render.use_file_extension = False
    image = render.image_settings
    image.file_format, image.color_mode = "OPEN_EXR", "RGBA"
    image.color_depth, image.exr_codec = "32", "ZIP"
    scene.display_settings.display_device = "sRGB"
    view = scene.view_settings
    view.view_transform, view.look, view.exposure, view.gamma = "Raw", "None", 0, 1


def check_denoiser():
    """Ends the program unless Cycles can denoise: Debian builds it without."""
    if not getattr(__import__("_cycles"), "with_openimagedenoise", False):
        raise SystemExit("this Blender is built without OpenImageDenoise")


def set_cycles(scene, samples=0, seed=0, denoise=False):
    """`samples` random rays per pixel through the filter that Blender sets; with 0 of
    them one ray through the centre of each pixel, and nothing else.

    Cycles gives its box filter the width of a pixel whatever filter_width says, and
    its table of filter offsets is off by 1/2048 of the width: half a thousandth of a
    pixel, enough to change coverage. Blackman-Harris obeys filter_width.
    """
    set_known(scene.cycles, device="CPU", samples=samples or 1, seed=seed,
              use_adaptive_sampling=False, use_denoising=denoise,
              pixel_filter_type="BLACKMAN_HARRIS", filter_width=1.5 if samples else 0.01,
              max_bounces=0, diffuse_bounces=0, glossy_bounces=0, volume_bounces=0,
              transmission_bounces=0, transparent_max_bounces=0, use_light_tree=False,
              sample_clamp_direct=0, sample_clamp_indirect=0)
    if denoise:
        check_denoiser()
        scene.cycles.denoiser = "OPENIMAGEDENOISE"


def set_eevee(scene):
    """One sample at the centre of each pixel, without effects."""
    set_known(scene.eevee, taa_render_samples=1, use_bloom=False, use_gtao=False,
              use_ssr=False, use_soft_shadows=False, use_raytracing=False)
    # Eevee rebuilds its unused light probes for every render: half of the time.
    set_known(scene.eevee, gi_cubemap_resolution="128", gi_visibility_resolution="8")
    scene.render.filter_size = 0


def engine_name(engine):
    """Blender's name for the engine."""
    if engine == "cycles":
        return "CYCLES"
    return "BLENDER_EEVEE_NEXT" if (4, 2) <= bpy.app.version < (5, 0) else "BLENDER_EEVEE"


def empty_scene():
    """Removes what the open file holds and makes the world black."""
    bpy.data.batch_remove([*bpy.data.objects, *bpy.data.materials, *bpy.data.worlds])
    bpy.data.orphans_purge(do_recursive=True)
    world = bpy.data.worlds.new("black")
    world.color = (0, 0, 0)
    if world.node_tree:
        world.node_tree.nodes.clear()
    bpy.context.scene.world = world


def build_scene(arguments):
    """Builds everything; returns the knot and the shots' materials."""
    empty_scene()
    knot = add_mesh_object(PARAMETERS["mesh"])
    add_camera(PARAMETERS["camera"], knot.data)
    scene = bpy.context.scene
    set_output(scene, PARAMETERS["image"])
    set_cycles(scene, arguments.samples, arguments.seed, arguments.denoise)
    set_eevee(scene)
    scene.render.engine = engine_name(arguments.engine)
    shots = PARAMETERS["shots"]
    scene.cycles.shading_system = any("osl" in shot for shot in shots)
    return knot, [add_material(shot, arguments.engine == "eevee") for shot in shots]


def render_shot(knot, material, path):
    """Renders the knot with the shot's material."""
    knot.data.materials[0] = material
    bpy.context.scene.render.filepath = os.path.abspath(path)
    bpy.ops.render.render(write_still=True)


def parse_arguments():
    """Reads the arguments after Blender's own, which end with --."""
    own = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    names = [shot["name"] for shot in PARAMETERS["shots"]]

    def render(text):
        name, _, path = text.partition("=")
        if name not in names or not path:
            raise argparse.ArgumentTypeError(f"{text!r}: expected one of {names}, =FILE")
        return names.index(name), path

    parser = argparse.ArgumentParser(prog=os.path.basename(__file__))
    parser.add_argument("--engine", choices=("cycles", "eevee"), default="cycles")
    parser.add_argument("--samples", type=int, default=0, metavar="N",
                        help="Cycles: random samples per pixel (0: one in its centre)")
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of the random samples")
    parser.add_argument("--denoise", action="store_true", help="Cycles: with OpenImageDenoise")
    parser.add_argument("--render", type=render, action="append", default=[],
                        metavar="SHOT=FILE.exr")
    parser.add_argument("--save", metavar="FILE.blend")
    return parser.parse_args(own)


def main():
    """Builds the scene, then renders and saves what was asked for."""
    arguments = parse_arguments()
    knot, materials = build_scene(arguments)
    for index, path in arguments.render:
        if materials[index]:
            render_shot(knot, materials[index], path)
    knot.data.materials[0] = materials[-1]
    if arguments.save:
        bpy.ops.file.pack_all()
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(arguments.save))
    print(f"Blender {bpy.app.version_string}")


if __name__ == "__main__":
    main()
