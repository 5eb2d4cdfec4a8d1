"""Reads our mesh files with meshio: the same float32 numbers in every corner, to the bit.

    meshio_test.py LUMAKNOT

LUMAKNOT is the program. Exit status 0: all agree; 1: the differences are printed; 3: no meshio.
"""

import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import checks  # noqa: E402  (it is next to this script)

np = checks.np

KNOTS = {"(2,3)": ("--segments", 120, "--sides", 16),
         "(4,6)": ("--p", 4, "--q", 6, "--segments", 50, "--sides", 7, "--tube", 0.05),
         "small": ("--ring", 1e-5, "--winding", 4e-6, "--tube", 1e-6, "--segments", 60,
                   "--sides", 5)}
# Suffix, flags of the format, whether positions are unique. meshio merges those of .stl.
FORMATS = ((".obj", (), True), (".obj", ("--quads",), True), (".ply", (), False),
           (".ply", ("--quads",), False), (".ply", ("--ascii",), False),
           (".ply", ("--ascii", "--quads"), False), (".stl", (), True),
           (".stl", ("--ascii",), True), (".off", (), True))


def sewn(positions):
    """The number of distinct positions."""
    return len(np.unique(positions, axis=0))


def check_values(read, ours, what, report):
    """PLY's normals and texture coordinates, which meshio stores by name."""
    for index, name in enumerate(("nx", "ny", "nz")):
        report.near(read.point_data[name], ours.normals[:, index], 0, f"{what}: {name}")
    for index, name in enumerate(("s", "t")):
        report.near(read.point_data[name], ours.uvs[:, index], 0, f"{what}: {name}")


def readable(path):
    """The file, or a copy that meshio can read if it can't read the file.

    It gives each position of an .obj file the texture coordinate and normal of the same number,
    and refuses files that have more of them, as files with seams do. It never reads their indices,
    so the copy only lacks what meshio can't store.
    """
    if path.suffix != ".obj":
        return path
    lines = path.read_text(encoding="ascii").splitlines(keepends=True)
    copy = path.with_name("bare.obj")
    copy.write_text("".join(line for line in lines if not line.startswith(("vt ", "vn "))),
                    encoding="ascii")
    return copy


def compare(meshio, program, folder, name, suffix, flags, once, report):
    """Compares one file."""
    what = " ".join([name, suffix, *flags])
    quads = ["--quads"] if "--quads" in flags else []
    ours = checks.knot(program, folder, *KNOTS[name], *quads)
    path = checks.write_knot(program, folder / f"knot{suffix}", *KNOTS[name], *flags)
    read = meshio.read(readable(path))
    kind = "quad" if quads else "triangle"
    report.equal([block.type for block in read.cells], [kind], f"{what}: kinds of faces")
    expected = sewn(ours.positions) if once else len(ours.positions)
    report.equal(len(read.points), expected, f"{what}: vertices")
    report.near(read.points.astype(np.float32)[read.cells[0].data], ours.positions[ours.faces], 0,
                f"{what}: corners")
    if suffix == ".ply":
        check_values(read, ours, what, report)
    print(f"{what}: {len(read.points)} vertices, {len(read.cells[0].data)} {kind}s")


def main(arguments):
    """The command line."""
    if len(arguments) != 1:
        sys.exit(__doc__)
    try:
        import meshio
    except ImportError:
        print("meshio not found; install with scripts/install tests", file=sys.stderr)
        return 3
    report = checks.Report()
    with tempfile.TemporaryDirectory() as folder:
        for name in KNOTS:
            for suffix, flags, once in FORMATS:
                compare(meshio, arguments[0], Path(folder), name, suffix, flags, once, report)
    return report.status()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
