"""Compiles every GLSL and HLSL shader that lumaknot emits, and validates its SPIR-V.

    compile_test.py LUMAKNOT

LUMAKNOT is the program. Needs glslangValidator and spirv-val. Exit status 0: all compiled; 1: one
did not, each named with the compiler's message; 3: the compiler is not installed.
"""

import json
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

LANGUAGES = ("glsl-330", "glsl-es-300", "glsl-450", "hlsl")
LIGHTS = {"": [], "directional": ["--light", "directional"], "spot": ["--light", "spot"],
          "three": ["--light", "point", "--light", "directional", "--light", "spot", "--gated"]}
GAMUTS = ("free", "clamp", "chroma")


def run(command):
    """Returns the output of a command if it fails, else an empty text."""
    done = subprocess.run(command, capture_output=True, text=True)
    return "" if done.returncode == 0 else (done.stdout + done.stderr).strip() or "failed"


def shaders(program):
    """The arguments of every shader of the list; lights and gamuts vary along it."""
    text = subprocess.run([program, "shader", "--list", "--json"], check=True, capture_output=True,
                          text=True).stdout
    names = {(entry["shader"], entry["rate"]) for entry in json.loads(text)}
    for index, (name, rate) in enumerate(sorted(names)):
        kind = list(LIGHTS)[index % len(LIGHTS)]
        gamut = GAMUTS[index % len(GAMUTS)]
        extra = ["--all-parameters"] if index % 2 else []
        yield [name, "--rate", rate, "--gamut", gamut, *LIGHTS[kind], *extra]


def stages(folder):
    """(command, SPIR-V file or None) for each stage below a folder."""
    for path in sorted(folder.rglob("*.*")):
        spirv = path.with_suffix(path.suffix + ".spv")
        if path.suffix in (".vert", ".frag"):
            vulkan = path.parent.name == "glsl-450"
            yield ["glslangValidator", *(["-V", "-o", spirv] if vulkan else []), path], \
                spirv if vulkan else None
        elif path.suffix == ".hlsl":
            for stage, entry in (("vert", "vertex_main"), ("frag", "fragment_main")):
                module = spirv.with_suffix(f".{stage}.spv")
                yield ["glslangValidator", "-V", "-D", "-S", stage, "-e", entry, "-o", module,
                       path], module


def defects(program, arguments):
    """The defects of one shader in all languages."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        wrong = run([program, "shader", *arguments, "--lang", ",".join(LANGUAGES), "-o", folder,
                     "--quiet"])
        if wrong:
            return [f"{' '.join(arguments)}: {wrong}"]
        checked = 0
        for command, spirv in stages(Path(folder)):
            wrong = run(command) or (spirv and run(["spirv-val", spirv]))
            checked += 1
            if wrong:
                found.append(f"{' '.join(arguments)}: {command[-1].name}: {wrong}")
    if checked != 2 * len(LANGUAGES):
        found.append(f"{' '.join(arguments)}: {checked} stages, not {2 * len(LANGUAGES)}")
    return found


def main(arguments):
    """The command line."""
    if len(arguments) != 1:
        sys.exit(__doc__)
    for tool in ("glslangValidator", "spirv-val"):
        if not shutil.which(tool):
            print(f"{tool} not found; install with apt-get install glslang-tools spirv-tools",
                  file=sys.stderr)
            return 3
    wanted = list(shaders(arguments[0]))
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda one: defects(arguments[0], one), wanted))
    for line in [line for result in results for line in result]:
        print(line)
    print(f"{len(wanted)} shaders in {len(LANGUAGES)} languages")
    return 1 if any(results) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
