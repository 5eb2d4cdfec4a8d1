"""Draws our .inc files with POV-Ray: the silhouette must be that of `lumaknot render`.

    povray_test.py LUMAKNOT

LUMAKNOT is the program. Exit status 0: all agree; 1: the differences are printed; 3: no POV-Ray.
"""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import checks  # noqa: E402  (it is next to this script)

np = checks.np

WIDTH, HEIGHT = 240, 180
EYE, FIELD_OF_VIEW = np.array([1.5, -3.0, 2.2]), 40  # looks at the origin, +Z up
KNOTS = ({"p": 2, "q": 3}, {"p": 3, "q": 7, "tube": 0.1}, {"p": 4, "q": 6, "tube": 0.08})
# One ray in about a hundred thousand slips between two of POV-Ray's triangles; these are 43,200.
MAX_DIFFERENT = 2
MIN_SHARE = 0.1  # of the picture: each knot fills more

SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1.0 }}
background {{ rgb 0 }}
#include "knot.inc"
camera {{ perspective location {eye} direction {ahead} right {right} up {up} }}
object {{ lumaknot_mesh texture {{ pigment {{ rgb 1 }} finish {{ ambient 0 emission 1 }} }} }}
"""


def vector(v):
    """A vector in POV-Ray's language."""
    return "<" + ", ".join(repr(float(x)) for x in v) + ">"


def povray_scene():
    """The same camera; explicit vectors keep POV-Ray right-handed."""
    ahead = -EYE / np.linalg.norm(EYE)
    right = np.cross(ahead, [0, 0, 1])
    right /= np.linalg.norm(right)
    height = 2 * math.tan(math.radians(FIELD_OF_VIEW) / 2)
    up = np.cross(right, ahead) * height
    return SCENE.format(eye=vector(EYE), ahead=vector(ahead), up=vector(up),
                        right=vector(right * height * WIDTH / HEIGHT))


def their_coverage(Image, program, knot, folder):
    """Draws the .inc with POV-Ray."""
    flags = [f"--{key}={value}" for key, value in knot.items()]
    checks.write_knot(program, folder / "knot.inc", *flags)
    (folder / "scene.pov").write_text(povray_scene(), encoding="ascii")
    done = subprocess.run(["povray", "+Iscene.pov", "+Opicture.png", f"+W{WIDTH}", f"+H{HEIGHT}",
                           "-A", "-D", "+FN8"], cwd=folder, capture_output=True, text=True,
                          timeout=checks.SECONDS)
    if done.returncode != 0:
        raise RuntimeError(f"povray ended with {done.returncode}: {done.stderr[-2000:]}")
    return np.asarray(Image.open(folder / "picture.png").convert("L")) > 127


def our_coverage(Image, program, knot, folder):
    """Draws the knot with lumaknot."""
    scene = {"mesh": {"knot": knot}, "texture": {"color": [1, 1, 1]},
             "camera": {"position": EYE.tolist(), "target": [0, 0, 0], "up": [0, 0, 1],
                        "fov_degrees": FIELD_OF_VIEW},
             "image": {"width": WIDTH, "height": HEIGHT, "samples": 1}}
    (folder / "scene.json").write_text(json.dumps(scene), encoding="ascii")
    checks.lumaknot(program, "render", folder / "scene.json", "-o", folder / "ours.png")
    return np.asarray(Image.open(folder / "ours.png").getchannel("A")) > 127


def compare(Image, program, knot, report):
    """Compares one knot."""
    with tempfile.TemporaryDirectory() as name:
        theirs = their_coverage(Image, program, knot, Path(name))
        ours = our_coverage(Image, program, knot, Path(name))
    different = int(np.count_nonzero(theirs != ours))
    report.check(ours.mean() > MIN_SHARE, f"{knot}: only {ours.sum()} pixels are covered")
    report.check(different <= MAX_DIFFERENT,
                 f"{knot}: {different} pixels, the first at row, column "
                 f"{np.argwhere(theirs != ours)[:5].tolist()}")
    print(f"{knot}: {theirs.sum()} pixels covered by POV-Ray, {ours.sum()} by us; "
          f"{different} differ")


def main(arguments):
    """The command line."""
    if len(arguments) != 1:
        sys.exit(__doc__)
    checks.need("povray", "povray")
    try:
        from PIL import Image
    except ImportError:
        print("PIL not found; install with scripts/install tests", file=sys.stderr)
        return 3
    report = checks.Report()
    for knot in KNOTS:
        compare(Image, arguments[0], knot, report)
    return report.status()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
