"""FLIP as its authors' package computes it (flip-evaluator of PyPI; scripts/install-peers).

    flip.py WIDTH HEIGHT REFERENCE TEST ERRORS

Reads two images of float32 r, g, b, writes the error map as float32. LUMAKNOT_PEERS is the folder of
scripts/install-peers. Exits with 3 and the remedy where the package is missing.
"""

import os
import sys


sys.path.insert(0, os.path.join(os.environ["LUMAKNOT_PEERS"], "python"))
try:
    import flip_evaluator
    import numpy as np
except ImportError as error:
    print(f"{error}; scripts/install-peers gets it", file=sys.stderr)
    sys.exit(3)


def main(width, height, reference, test, errors):
    def image(path):
        return np.fromfile(path, "<f4").reshape(int(height), int(width), 3)

    found, _, used = flip_evaluator.evaluate(image(reference), image(test), "LDR",
                                             applyMagma=False)
    print(used["ppd"])
    np.asarray(found, "<f4").reshape(int(height), int(width), -1)[:, :, 0].tofile(errors)


if __name__ == "__main__":
    main(*sys.argv[1:])
