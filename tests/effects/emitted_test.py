"""Checks every effect that lumaknot emits, and compiles its entry points if Wine's compiler is installed.

    emitted_test.py LUMAKNOT

LUMAKNOT is the program. Exit status 0: all passed; 1: a defect; 2: lumaknot or Wine failed; 3: no
defect seen, but the compiler is not installed.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import check_fx
import compile_fx
import d3d9_slots
import fx_file

# Beyond the list: several lights of all kinds, every number a parameter, the gamut rule.
SPECIAL = {
    "three-lights": ["yiq-phong", "--light", "point", "--light", "directional", "--light", "spot",
                     "--gamut", "chroma", "--gated"],
    "all-parameters": ["rgb-cook-torrance", "--all-parameters"],
}


def emissions(program):
    """The arguments of each effect, by the name of its file."""
    text = subprocess.run([program, "shader", "--list", "--json"], check=True, capture_output=True,
                          text=True).stdout
    listed = {f"{entry['shader']}-{entry['rate']}": [entry["shader"], "--rate", entry["rate"]]
              for entry in json.loads(text) if "fx" in entry["languages"]}
    return listed | SPECIAL


def emit(program, name, arguments, folder):
    """Writes one effect and returns its path."""
    subprocess.run([program, "shader", *arguments, "--lang", "fx", "--name", name, "-o", folder,
                    "--quiet"], check=True)
    return Path(folder) / f"{name}.fx"


def annotation_defects(path):
    """The defects found without a compiler."""
    effect = fx_file.read_effect(path.read_text(encoding="utf-8"))
    return [f"{path.name}: {name}: {defect}"
            for name, defect in [*check_fx.parameter_defects(effect),
                                 *check_fx.technique_defects(effect)]]


def compile_defects(paths):
    """What the compiler and the limits of shader models 2 and 3 refuse."""
    requests = [(path, entry, profile) for path in paths
                for entry, profile in check_fx.entries(
                    fx_file.read_effect(path.read_text(encoding="utf-8")))]
    defects = []
    for (path, entry, profile), result in zip(requests, compile_fx.compile_entries(requests)):
        where = f"{path.name}: {entry} as {profile}"
        if not result.ok:
            defects.append(f"{where}: {result.messages}")
            continue
        too_many = d3d9_slots.over_the_limit(d3d9_slots.count(result.disassembly), profile)
        if too_many:
            defects.append(f"{where}: {too_many}")
    print(f"{len(requests)} entry points compiled")
    return defects


def main(arguments):
    """The command line."""
    if len(arguments) != 1:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        paths = [emit(arguments[0], name, extra, folder)
                 for name, extra in emissions(arguments[0]).items()]
        defects = [defect for path in paths for defect in annotation_defects(path)]
        reason = compile_fx.why_not_installed(compile_fx.trixie_folder())
        if not reason:
            defects += compile_defects(paths)
    print(f"{len(paths)} effects read")
    for defect in defects:
        print(defect)
    if reason:
        print(f"nothing compiled: {reason}", file=sys.stderr)
    return 1 if defects else 3 if reason else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (subprocess.CalledProcessError, compile_fx.WineFailed) as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
