"""Reads our mesh files with Blender's own importers and compares everything that they read.

    blender_import_test.py LUMAKNOT

LUMAKNOT is the program. Exit status 0: all agree; 1: the differences are printed; 3: no Blender.
"""

import sys
import tempfile
from dataclasses import dataclass
from math import gcd
from pathlib import Path
from typing import Callable

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import checks  # noqa: E402  (it is next to this script)

np = checks.np
# Blender 3.4's glTF importer says np.bool, which Debian 12's numpy 1.24 no longer has.
if "bool" not in vars(np):
    np.bool = bool

MERGE = 1e-6  # scene units: a seam's vertices are the same, others are a thousand times as far
# The rotation from glTF's +Y up is a float32 quaternion: a step or two of coordinates below 2.
TURNED = 5e-7
# Blender keeps a custom normal as two angles of 16 bits from the normal that it computes itself:
# half a step of pi / 32767 = 1e-4 each. A smooth face's own normal may equal ours, and then the
# arc cosine of a float32 one step below 1 is an angle of sqrt(2 * 2^-24) = 3.5e-4.
NORMAL = 1e-4
SMOOTH_NORMAL = NORMAL + 3.5e-4
# Texture coordinates of glTF are 1 - v twice, in float32 numbers below 2.
FLIPPED = 3e-7
# Of the volume: positions are float32, 6e-8 of their size of about ten tubes, and so are the sums.
VOLUME = 1e-6
# Blender's tangents are normal to its normals, and are weighted by angles seen along these.
TANGENT = 2 * SMOOTH_NORMAL


@dataclass
class Knot:
    """Flags of a mesh and the resulting counts."""
    p: int
    q: int
    segments: int
    sides: int
    repeat: int
    quads: bool = False
    tangents: bool = False

    def arguments(self):
        """For `lumaknot mesh`, without the flags below."""
        return ("--p", self.p, "--q", self.q, "--segments", self.segments, "--sides", self.sides,
                "--tube", 0.125, "--repeat-u", self.repeat)

    def flags(self):
        """The flags that not every format supports."""
        return ["--quads"] * self.quads + ["--tangents"] * self.tangents

    @property
    def pieces(self):
        """The number of its components."""
        return gcd(self.p, self.q)

    @property
    def sewn(self):
        """The number of its vertices without the seams' duplicates."""
        return self.pieces * self.segments * self.sides

    def __str__(self):
        return f"({self.p},{self.q}) {self.segments} x {self.sides}" + " quads" * self.quads \
            + " tangents" * self.tangents


KNOTS = (Knot(2, 3, 96, 16, 1), Knot(4, 6, 64, 9, 12))
QUADS = Knot(3, 2, 80, 12, 3, quads=True)
TANGENTS = Knot(2, 3, 96, 16, 2, tangents=True)


@dataclass
class Importer:
    """One of Blender's importers, and what its format supports."""
    name: str
    suffix: str
    read: Callable
    sewn: bool = False  # whether positions are unique
    uvs: bool = True
    normals: float = SMOOTH_NORMAL  # tolerance; 0 if absent
    quads: bool = False
    turned: bool = False  # whether the object has a rotation


def importers():
    """All that read our formats; some of Blender 3 are in Python. That of .obj ended with 4.0."""
    import bpy
    built_in = dir(bpy.ops.wm)
    # Faces of .obj files are flat in Blender 3.4 and smooth, like the other formats', in 4.3,
    # without auto smooth: 7.5e-5 and 3.1e-4.
    flat = bpy.app.version < (4, 1)
    yield Importer(".obj", ".obj", lambda path: bpy.ops.wm.obj_import(
        filepath=path, forward_axis="Y", up_axis="Z"), sewn=True,
        normals=NORMAL if flat else SMOOTH_NORMAL, quads=True)
    if bpy.app.version < (4, 0):
        yield Importer(".obj in Python", ".obj", lambda path: bpy.ops.import_scene.obj(
            filepath=path, axis_forward="Y", axis_up="Z"), sewn=True, quads=True)
    if "ply_import" in built_in:
        yield Importer(".ply", ".ply", lambda path: bpy.ops.wm.ply_import(filepath=path),
                       quads=True)
    else:
        yield Importer(".ply", ".ply", lambda path: bpy.ops.import_mesh.ply(filepath=path),
                       normals=0, quads=True)
    read_stl = bpy.ops.wm.stl_import if "stl_import" in built_in else bpy.ops.import_mesh.stl
    yield Importer(".stl", ".stl", lambda path: read_stl(filepath=path),
                   sewn=True, uvs=False, normals=0)
    for suffix in (".glb", ".gltf"):
        yield Importer(suffix, suffix, lambda path: bpy.ops.import_scene.gltf(filepath=path),
                       turned=True)


def imported(importer, path):
    """The one mesh object of the file, read into an empty scene."""
    import bpy
    for other in list(bpy.data.objects):
        bpy.data.objects.remove(other)
    importer.read(str(path))
    objects = [each for each in bpy.data.objects if each.type == "MESH"]
    assert len(objects) == 1, f"{importer.name}: {len(objects)} meshes"
    return objects[0]


def column(collection, name, width):
    """An attribute of each element of a mesh's collection, one row each."""
    values = np.empty(width * len(collection), np.float32)
    collection.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def loop_normals(mesh):
    """The normals of its faces' corners, one row each."""
    import bpy
    if bpy.app.version >= (4, 1):
        return column(mesh.corner_normals, "vector", 3)
    mesh.calc_normals_split()
    return column(mesh.loops, "normal", 3)


@dataclass
class Corners:
    """Attributes of each corner of each face: faces x corners x components."""
    positions: np.ndarray
    normals: np.ndarray = None
    uvs: np.ndarray = None
    tangents: np.ndarray = None  # the fourth is the sign

    def turned(self, steps):
        """Each face rotated by `steps` corners."""
        columns = (np.arange(self.positions.shape[1]) + steps[:, None]) % self.positions.shape[1]
        rows = np.arange(len(steps))[:, None]
        return Corners(*(None if each is None else each[rows, columns] for each in (
            self.positions, self.normals, self.uvs, self.tangents)))


def our_corners(mesh, tangents=None):
    """The corners of a checks.Mesh."""
    return Corners(mesh.positions[mesh.faces], mesh.normals[mesh.faces], mesh.uvs[mesh.faces],
                   None if tangents is None else tangents[mesh.faces])


def blender_corners(thing, importer, tangents):
    """The corners of an imported object, in the world's coordinates."""
    mesh = thing.data
    sizes = {face.loop_total for face in mesh.polygons}
    assert len(sizes) == 1, f"faces of {sizes} corners"
    shape = (len(mesh.polygons), sizes.pop(), -1)
    turn = np.array(thing.matrix_world, np.float32)[:3, :3]
    vertices = [loop.vertex_index for loop in mesh.loops]
    corners = Corners((column(mesh.vertices, "co", 3)[vertices] @ turn.T).reshape(shape))
    if importer.uvs:
        corners.uvs = column(mesh.uv_layers[0].data, "uv", 2).reshape(shape)
    if importer.normals:
        corners.normals = (loop_normals(mesh) @ turn.T).reshape(shape)
    if tangents:
        mesh.calc_tangents(uvmap=mesh.uv_layers[0].name)
        along = column(mesh.loops, "tangent", 3) @ turn.T
        sign = column(mesh.loops, "bitangent_sign", 1)
        corners.tangents = np.column_stack([along, sign]).reshape(shape)
    return corners


def aligned(theirs, ours):
    """`theirs` with each face starting where its positions are nearest to ours."""
    count = ours.positions.shape[1]
    apart = [np.abs(np.roll(theirs.positions, -step, axis=1) - ours.positions).max(axis=(1, 2))
             for step in range(count)]
    return theirs.turned(np.argmin(apart, axis=0))


def check_corners(importer, knot, theirs, ours, report):
    """Compares attribute by attribute; returns the largest differences as text."""
    what = f"{importer.name}: {knot}"
    if theirs.positions.shape != ours.positions.shape:
        report.equal(theirs.positions.shape, ours.positions.shape, f"{what}: faces and corners")
        return "none compared"
    theirs = aligned(theirs, ours)
    told = []

    def near(name, tolerance, found, expected):
        worst = report.near(found, expected, tolerance, f"{what}: {name}")
        told.append(f"{name} {worst:.1e}")

    near("positions", TURNED if importer.turned else 0, theirs.positions, ours.positions)
    if importer.uvs:
        near("uvs", FLIPPED if importer.turned else 0, theirs.uvs, ours.uvs)
        low, high = theirs.uvs.min(axis=(0, 1)), theirs.uvs.max(axis=(0, 1))
        near("uv range", FLIPPED, [*low, *high], [0, 0, knot.repeat, 1])
    if importer.normals:
        near("normals", importer.normals, theirs.normals, ours.normals)
    if ours.tangents is not None:
        near("tangents", TANGENT, theirs.tangents[..., :3], ours.tangents[..., :3])
        near("signs", 0, theirs.tangents[..., 3], ours.tangents[..., 3])
    return ", ".join(told)


def euler_characteristics(surface):
    """V - E + F of each connected piece of a bmesh."""
    pieces, seen = [], set()
    for start in surface.verts:
        if start in seen:
            continue
        vertices, waiting = {start}, [start]
        while waiting:
            edges = waiting.pop().link_edges
            new = {vertex for edge in edges for vertex in edge.verts} - vertices
            vertices |= new
            waiting.extend(new)
        seen |= vertices
        edges = {edge for vertex in vertices for edge in vertex.link_edges}
        faces = {face for vertex in vertices for face in vertex.link_faces}
        pieces.append(len(vertices) - len(edges) + len(faces))
    return pieces


def check_surface(importer, knot, thing, volume, report):
    """Closed, manifold, tori, outward and of our volume, once equal positions are merged."""
    import bmesh
    what = f"{importer.name}: {knot}"

    def none(things, name):
        report.equal(sum(things), 0, f"{what}: {name}")

    surface = bmesh.new()
    surface.from_mesh(thing.data)
    surface.transform(thing.matrix_world)
    bmesh.ops.remove_doubles(surface, verts=surface.verts, dist=MERGE)
    report.equal(len(surface.verts), knot.sewn, f"{what}: merged vertices")
    none((edge.is_boundary for edge in surface.edges), "boundary edges")
    none((not edge.is_manifold for edge in surface.edges), "edges that are not manifold")
    none((not vertex.is_manifold for vertex in surface.verts), "vertices that are not manifold")
    none((not edge.is_contiguous for edge in surface.edges), "edges where the winding changes")
    report.equal(euler_characteristics(surface), [0] * knot.pieces, f"{what}: V - E + F")
    # Quads are not flat: cut where ours are, from the first corner to the third.
    bmesh.ops.triangulate(surface, faces=surface.faces, quad_method="FIXED")
    found = surface.calc_volume(signed=True)  # positive when outward
    surface.free()
    report.near(found, volume, VOLUME * volume, f"{what}: volume")
    return f"volume {abs(found / volume - 1):.1e}"


def reference(importer, knot, program, folder):
    """Our own corners, with tangents from a .glb file, and the file's number of vertices."""
    quads = ["--quads"] * knot.quads
    mesh = checks.knot(program, folder, *knot.arguments(), *quads)
    count = knot.sewn if importer.sewn else len(mesh.positions)
    if not knot.tangents:
        return our_corners(mesh), count
    path = checks.write_knot(program, folder / "tangents.glb", *knot.arguments(), "--tangents")
    return our_corners(mesh, checks.glb_tangents(path)), count


def compare(importer, knot, program, folder, report):
    """One file through one importer."""
    what = f"{importer.name}: {knot}"
    path = checks.write_knot(program, folder / f"knot{importer.suffix}", *knot.arguments(),
                            *knot.flags())
    volume = checks.lumaknot(program, "mesh", *knot.arguments(), "--measure")["volume"]
    ours, vertices = reference(importer, knot, program, folder)
    thing = imported(importer, path)
    report.equal(len(thing.data.vertices), vertices, f"{what}: vertices")
    if importer.normals:
        report.equal(thing.data.has_custom_normals, True, f"{what}: has normals")
    theirs = blender_corners(thing, importer, knot.tangents)
    corners = check_corners(importer, knot, theirs, ours, report)
    solid = check_surface(importer, knot, thing, volume, report)
    print(f"{what}: {vertices} vertices, {len(ours.positions)} faces; largest differences: "
          f"{corners}, {solid}")


def main(program):
    """Runs inside Blender."""
    report = checks.Report()
    with tempfile.TemporaryDirectory() as folder:
        for importer in importers():
            knots = [*KNOTS, *([QUADS] if importer.quads else []),
                     *([TANGENTS] if importer.turned else [])]
            for knot in knots:
                compare(importer, knot, program, Path(folder), report)
    return report.status()


if __name__ == "__main__":
    if "bpy" in sys.modules:
        sys.exit(main(sys.argv[sys.argv.index("--") + 1]))
    sys.exit(checks.run_in_blender(__file__, sys.argv[1:]))
