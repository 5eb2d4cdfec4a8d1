"""Checks of an installed lumaknot."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

# Small, so that a second is enough, and with an image file, which needs the module with OpenImageIO.
SCENE = {"mesh": {"knot": {"segments": 96, "sides": 12}}, "image": {"width": 96, "height": 96}}


def run(*command, **options):
    """The standard output of a command that must succeed."""
    done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))} exited with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def check(condition, what):
    if not condition:
        sys.exit(f"failed: {what}")


def check_programs(prefix):
    """Runs the program through its link in bin: it finds its module and helper next to itself."""
    program = prefix / "bin" / "lumaknot"
    with tempfile.TemporaryDirectory() as folder:
        def lumaknot(*arguments):
            return run(program, *arguments, cwd=folder)

        Path(folder, "scene.json").write_text(json.dumps(SCENE), encoding="utf-8")
        lumaknot("mesh", "--segments", "96", "--sides", "12", "-o", "knot.glb")
        lumaknot("render", "scene.json", "-o", "knot.exr")
        check(Path(folder, "knot.exr").stat().st_size > 1000, "render writes an image")
        found = {r["renderer"]: r for r in json.loads(lumaknot("doctor", "--json"))}
        check(found["GL"]["found"], "doctor finds gl by the helper that was installed")
        lumaknot("validate", "scene.json", "--renderer", "gl", "-o", "report")  # exit code 0: agreed
        report = json.loads(Path(folder, "report", "report.json").read_text(encoding="utf-8"))
        check(report["verdict"] == "agreed", "validate agrees")


def check_files(prefix, root):
    """Checks the files next to the programs, and that nothing names its build folder."""
    share = prefix / "share"
    program = prefix / "bin" / "lumaknot"
    for shell, place in {"bash": "bash-completion/completions/lumaknot",
                         "zsh": "zsh/site-functions/_lumaknot",
                         "fish": "fish/vendor_completions.d/lumaknot.fish"}.items():
        check((share / place).read_text(encoding="utf-8") == run(program, "completion", shell),
              f"{shell}'s completion is what the program prints")
    check((share / "lumaknot/scene.schema.json").read_text(encoding="utf-8") ==
          run(program, "scene", "--schema"), "the schema is what the program prints")
    for page in ("lumaknot.1", "lumaknot-mesh.1"):
        check((share / "man/man1" / page).read_text(encoding="utf-8").startswith(".TH"),
              f"{page} is a manual page")
    check("MIT" in (share / "doc/lumaknot/copyright").read_text(encoding="utf-8"), "the licence is there")
    for folder, _, names in os.walk(prefix):
        for path in (Path(folder, name) for name in names):
            check(path.is_symlink() or os.fsencode(root) not in path.read_bytes(),
                  f"{path} holds the path of the sources, {root}")
