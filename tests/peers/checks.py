"""Shared by the peer tests: lumaknot's meshes, its PLY files, Blender.

A test script that Blender runs is started like any other, with Debian's Python, and starts
Blender on itself.
"""

import json
import os
import shutil
import struct
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("numpy not found; install with scripts/install tests", file=sys.stderr)
    sys.exit(3)

SECONDS = 120
PROPERTIES = ("x", "y", "z", "nx", "ny", "nz", "s", "t")


@dataclass
class Mesh:
    """Float32 arrays, one row per vertex, and the faces, all with the same number of corners."""
    positions: np.ndarray
    normals: np.ndarray
    uvs: np.ndarray
    faces: np.ndarray


def lumaknot(program, *arguments):
    """The program's JSON output."""
    command = [str(program), *map(str, arguments), "--json"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def write_knot(program, path, *flags):
    """Writes a mesh file; returns its path."""
    lumaknot(program, "mesh", *flags, "-o", path)
    return Path(path)


def read_ply(path):
    """The Mesh in a binary PLY file of lumaknot."""
    data = Path(path).read_bytes()
    head, found, body = data.partition(b"end_header\n")
    lines = head.decode("ascii").splitlines()
    names = tuple(line.split()[2] for line in lines if line.startswith("property float "))
    assert found and "format binary_little_endian 1.0" in lines and names == PROPERTIES, lines
    vertices, faces = (int(line.split()[2]) for line in lines if line.startswith("element "))
    table = np.frombuffer(body, "<f4", 8 * vertices).reshape(vertices, 8)
    corners = body[table.nbytes]
    face = np.dtype([("corners", "u1"), ("vertices", "<u4", corners)])
    rows = np.frombuffer(body, face, offset=table.nbytes)
    assert len(rows) == faces and (rows["corners"] == corners).all(), f"{path}: uneven faces"
    return Mesh(table[:, :3], table[:, 3:6], table[:, 6:], rows["vertices"])


def knot(program, folder, *flags):
    """The Mesh that the program builds."""
    return read_ply(write_knot(program, Path(folder) / "reference.ply", *flags))


def glb_tangents(path):
    """The array TANGENT of the one mesh in a .glb file: rows of four."""
    data = Path(path).read_bytes()
    length, = struct.unpack_from("<I", data, 12)
    document = json.loads(data[20:20 + length])
    primitive = document["meshes"][0]["primitives"][0]
    accessor = document["accessors"][primitive["attributes"]["TANGENT"]]
    view = document["bufferViews"][accessor["bufferView"]]
    begin = 28 + length + view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    assert accessor["componentType"] == 5126 and view.get("byteStride", 16) == 16, "not packed"
    return np.frombuffer(data, "<f4", 4 * accessor["count"], begin).reshape(-1, 4)


def peers_folder():
    """The folder of scripts/install-peers."""
    cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(os.environ.get("LUMAKNOT_PEERS") or Path(cache) / "lumaknot/peers")


def need(program, package):
    """Exits with 3 unless the program is on PATH."""
    if not shutil.which(program):
        print(f"{program} not found; install with apt-get install {package}", file=sys.stderr)
        sys.exit(3)


def run_in_blender(script, arguments):
    """Runs a script in Blender, without windows or user settings; returns its exit status."""
    need("blender", "blender")
    command = ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", script,
               "--", *arguments]
    return subprocess.run(command, timeout=SECONDS, start_new_session=True).returncode


class Report:
    """Collects differences, and prints them as they occur."""

    def __init__(self):
        self.differences = 0

    def check(self, good, text):
        """Prints a difference unless `good`."""
        if not good:
            self.differences += 1
            print(f"DIFFERS: {text}")

    def equal(self, found, expected, what):
        """Compares two values that must be the same."""
        self.check(found == expected, f"{what}: {found}, expected {expected}")

    def near(self, found, expected, tolerance, what):
        """Compares two arrays of one shape, or numbers; returns their largest difference."""
        found, expected = np.asarray(found), np.asarray(expected)
        if found.shape != expected.shape:
            self.check(False, f"{what}: {found.shape} numbers, expected {expected.shape}")
            return np.inf
        apart = np.abs(found.astype(float) - expected)
        worst = np.max(apart)
        if not worst <= tolerance:
            at = np.unravel_index(np.argmax(apart), apart.shape)
            self.check(False, f"{what}: {found[at]}, expected {expected[at]} at {at}; "
                              f"{worst:.2g} is beyond {tolerance:.2g}")
        return worst

    def status(self):
        """The exit status: 1 when anything differed."""
        return 1 if self.differences else 0
