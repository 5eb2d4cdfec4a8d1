"""Loads emitted recipes as node groups in every Blender that is installed.

    loader_test.py LUMAKNOT

LUMAKNOT is the program. Debian's Blender on PATH, the module bpy of `scripts/install-extras osl`, the
Blender 4 of `scripts/install-extras trixie`. Exit status 0: all well; 1: a defect; 3: no Blender.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "effects"))
import compile_fx  # noqa: E402  (how to run something in the Debian 13 folder)

SHADERS = ("rgb-phong", "yiq-table1-phong", "yiq-baked-phong", "cielab-cook-torrance",
           "atd95-oren-nayar")
SECONDS = 120


def extra_python():
    """The Python with bpy."""
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return Path(cache) / "lumaknot/osl/bin/python"


def run(command):
    """The line that blender_groups.py prints, and whether it succeeded."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS,
                          start_new_session=True)
    return done.returncode == 0, done.stdout + done.stderr


def in_trixie(folder):
    """The same in the Blender of the Debian 13 folder."""
    root = compile_fx.trixie_folder()
    work = Path(tempfile.mkdtemp(dir=root / "tmp"))
    try:
        shutil.copytree(folder, work / "shaders")
        shutil.copy(HERE / "blender_groups.py", work)
        inside = "/" + str(work.relative_to(root))
        done = compile_fx.run(root, inside, time.monotonic() + SECONDS, blender(
            "/usr/bin/blender", f"{inside}/blender_groups.py", f"{inside}/shaders"))
    finally:
        shutil.rmtree(work)
    return done.returncode == 0, done.stdout + done.stderr


def blender(program, script, folder):
    """A Blender's command line."""
    return [program, "-b", "--factory-startup", "--python-exit-code", "7", "--python", str(script),
            "--", str(folder)]


def trixie_blender():
    """Whether the Debian 13 folder and its Blender are installed."""
    folder = compile_fx.trixie_folder()
    return (folder / "usr/bin/blender").exists() and not compile_fx.why_not_installed(folder)


def loaders(folder):
    """Yields each Blender found: a name and a function that returns (success, its output)."""
    script = HERE / "blender_groups.py"
    if program := shutil.which("blender"):
        yield "blender", lambda: run(blender(program, script, folder))
    if extra_python().exists():
        yield "bpy", lambda: run([str(extra_python()), str(script), "--", str(folder)])
    if trixie_blender():
        yield "Debian 13's blender", lambda: in_trixie(folder)


def told(name, well, log):
    """Prints the result of one Blender; returns whether it succeeded."""
    lines = [line for line in log.splitlines() if " groups in Blender " in line]
    well = well and bool(lines)
    print(f"{name}: {lines[0]}" if well else f"{name} failed:\n{log}")
    return well


def main(arguments):
    """The command line."""
    if len(arguments) != 1:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        for shader in SHADERS:
            subprocess.run([arguments[0], "shader", shader, "--lang", "blender", "-o", folder,
                            "--quiet"], check=True)
        results = [(name, *load()) for name, load in loaders(folder)]
    failed = [not told(name, well, log) for name, well, log in results]
    if not results:
        print("no Blender found; install with apt-get install blender", file=sys.stderr)
        return 3
    return 1 if any(failed) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
