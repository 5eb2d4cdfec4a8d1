"""Compares the centres of our rings with the curves of Blender's add-on "Torus Knot Plus".

    blender_knots_test.py LUMAKNOT

LUMAKNOT is the program. Exit status 0: all agree; 1: the differences are printed; 3: no Blender;
4: a Blender without the add-on, which it had up to 4.1 (later from its server of extensions).
"""

import sys
import tempfile
from math import gcd
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import checks  # noqa: E402  (it is next to this script)

SEGMENTS = 99  # the add-on's default resolution of 100 gives as many control points
SIDES = 8
# p, q, R, r. The last three are links of two, five and three components.
KNOTS = ((2, 3, 1.0, 0.25), (3, 2, 1.0, 0.25), (5, 7, 1.5, 0.5), (1, 4, 1.0, 0.125),
         (4, 6, 1.0, 0.25), (5, 5, 2.0, 0.5), (9, 6, 1.0, 0.375))
# Control points and vertices are float32: half a step, 1.2e-7 of 2, each, and the error of the
# ring's mean is at most that of its vertices.
TOLERANCE = 1e-6


def control_points(p, q, ring, winding):
    """The add-on's splines: one array of points each."""
    import bpy
    areas = bpy.context.window_manager.windows[0].screen.areas
    outliner = next(area for area in areas if area.type == "OUTLINER")
    # The operator needs a window of some kind, and there is none in the background.
    with bpy.context.temp_override(area=outliner):
        bpy.ops.curve.torus_knot_plus(torus_p=p, torus_q=q, torus_R=ring, torus_r=winding,
                                      torus_res=SEGMENTS + 1, multiple_links=True,
                                      outputType="BEZIER", edit_mode=False)
    curve = bpy.context.view_layer.objects.active
    assert curve.matrix_world == curve.matrix_world.Identity(4)
    return [[point.co[:] for point in spline.bezier_points] for spline in curve.data.splines]


def ring_centres(mesh):
    """The mean of each ring's vertices, component by component; seams are duplicated."""
    rings = mesh.positions.reshape(-1, SEGMENTS + 1, SIDES + 1, 3)
    return rings[:, :-1, :-1].mean(axis=2, dtype=float)


def compare(program, knot, report):
    """Compares one knot: the same number of components, and the same points in the same order."""
    p, q, ring, winding = knot
    with tempfile.TemporaryDirectory() as folder:
        ours = ring_centres(checks.knot(
            program, folder, "--convention", "blender", "--p", p, "--q", q, "--ring", ring,
            "--winding", winding, "--segments", SEGMENTS, "--sides", SIDES, "--tube", 0.01))
    theirs = control_points(*knot)
    report.equal(len(theirs), gcd(p, q), f"({p},{q}): Blender's splines")
    worst = report.near(ours, theirs, TOLERANCE, f"({p},{q})")
    print(f"({p},{q}): {len(theirs)} splines of {len(theirs[0])} points; largest difference "
          f"{worst:.1e}")


def main(program):
    """Runs inside Blender."""
    import addon_utils
    import bpy
    if bpy.app.version >= (4, 2):
        print(f"Blender {bpy.app.version_string} has no Torus Knot Plus, which ended with 4.1")
        return 4
    addon_utils.enable("add_curve_extra_objects")
    report = checks.Report()
    for knot in KNOTS:
        compare(program, knot, report)
    return report.status()


if __name__ == "__main__":
    if "bpy" in sys.modules:
        sys.exit(main(sys.argv[sys.argv.index("--") + 1]))
    sys.exit(checks.run_in_blender(__file__, sys.argv[1:]))
