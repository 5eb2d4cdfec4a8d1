"""Checks an effect as FX Composer would read it, and compiles its passes' entry points.

    check_fx.py FILE.fx

Prints the instruction slots of each entry point, then a line for each defect. Exit status 0: no
defect; 1: a defect; 2: Wine failed; 3: no defect seen, but the compiler is not installed.

Annotations and semantics: Bjorke, "Using SAS with CgFX and FX file formats", NVIDIA 2008. Names
and values are case-insensitive there.
"""

import re
import sys
from collections import Counter
from pathlib import Path

import compile_fx
import d3d9_slots
import fx_file

MATRICES = {prefix + suffix for prefix in (
    "world", "view", "projection", "worldview", "viewprojection", "worldviewprojection")
    for suffix in ("", "inverse", "transpose", "inversetranspose")}
SEMANTICS = MATRICES | {
    "cameraposition", "position", "direction", "diffuse", "specular", "ambient", "emissive",
    "opacity", "specularpower", "constantattenuation", "linearattenuation",
    "quadraticattenuation", "falloffangle", "falloffexponent", "normal"}
OF_A_LIGHT = {"position", "direction"}  # these name an object and a space
LIGHT = re.compile(r"(point|spot|directional)light\d+", re.IGNORECASE)
SPACES = {"world", "view", "object"}
WIDGETS = {"none", "slider", "color", "numeric"}
TEXTS = {"uiname", "uiwidget", "object", "space", "resourcename", "resourcetype", "script"}
NUMBERS = {"uimin", "uimax", "uistep"}
TEXTURES = {"texture", "texture1d", "texture2d", "texture3d", "texturecube"}
SHAPES = {"1d", "2d", "3d", "cube"}
BOOLEANS = {"true", "false"}
STATES = {  # the render states of Direct3D 9 that an effect of ours may set
    "zenable": BOOLEANS, "zwriteenable": BOOLEANS, "alphablendenable": BOOLEANS,
    "cullmode": {"none", "cw", "ccw"},
    "zfunc": {"never", "less", "equal", "lessequal", "greater", "notequal", "greaterequal",
              "always"}}
PROFILES = {"VertexShader": ("vs_2_0", "vs_3_0"), "PixelShader": ("ps_2_0", "ps_3_0")}


def annotation_defects(item):
    """Annotations of a wrong kind, duplicate, or empty."""
    counts = Counter(a.name.lower() for a in item.annotations)
    for name in (name for name, times in counts.items() if times > 1):
        yield f"{name} is given twice"
    for annotation in item.annotations:
        name = annotation.name.lower()
        if name in TEXTS and annotation.type != "string":
            yield f"{annotation.name} must be a string, is {annotation.type}"
        elif name in TEXTS and not annotation.value:
            yield f"{annotation.name} is empty"
        if name in NUMBERS and not (annotation.type in ("float", "int")
                                    and isinstance(annotation.value, float)):
            yield f"{annotation.name} must be one number"


def widget_defects(parameter):
    """Whether a parameter shows up, under a name, with a control that can hold its value."""
    widget = str(parameter.value("UIWidget", "")).lower()
    if widget and widget not in WIDGETS:
        yield f"UIWidget {parameter.value('UIWidget')} is none of {', '.join(sorted(WIDGETS))}"
    if widget != "none" and not parameter.value("UIName"):
        yield 'no UIName; only a parameter with UIWidget = "None" needs none'
    if widget == "color" and parameter.type not in ("float3", "float4"):
        yield f"a color is float3 or float4, not {parameter.type}"
    if widget == "slider":
        for name in ("UIMin", "UIMax", "UIStep"):
            if parameter.value(name) is None:
                yield f"a slider without {name}"
    if widget != "none" and parameter.type.lower() not in TEXTURES \
            and not parameter.initial:
        yield "no default value"


def range_defects(parameter):
    """Whether the default value lies in the range."""
    low, high, step = (parameter.value(name) for name in ("UIMin", "UIMax", "UIStep"))
    if any(not isinstance(number, (float, type(None))) for number in (low, high, step)):
        return  # annotation_defects reports it
    if low is not None and high is not None and low >= high:
        yield f"UIMin {low:g} is not below UIMax {high:g}"
        return
    if step is not None and (step <= 0 or (None not in (low, high) and step > high - low)):
        yield f"UIStep {step:g} does not fit between UIMin and UIMax"
    for number in fx_file.numbers_in(parameter.initial):
        if low is not None and number < low or high is not None and number > high:
            yield f"default {number:g} is outside UIMin {low:g} to UIMax {high:g}"


def semantic_defects(parameter):
    """Whether the application knows what to bind, and from where."""
    semantic = parameter.semantic.lower()
    if semantic and semantic not in SEMANTICS:
        yield f"unknown semantic {parameter.semantic}"
    if semantic in MATRICES and parameter.type != "float4x4":
        yield f"{parameter.semantic} is float4x4, not {parameter.type}"
    if semantic in OF_A_LIGHT and not parameter.value("Object"):
        yield f"{parameter.semantic} without Object: whose?"
    if semantic in OF_A_LIGHT and not parameter.value("Space"):
        yield f"{parameter.semantic} without Space"
    if parameter.value("Object") and not LIGHT.fullmatch(str(parameter.value("Object"))):
        yield f"Object {parameter.value('Object')} is not a light such as PointLight0"
    if parameter.value("Space") and str(parameter.value("Space")).lower() not in SPACES:
        yield f"Space {parameter.value('Space')} is none of {', '.join(sorted(SPACES))}"


def texture_defects(parameter):
    """Whether a texture says what to load."""
    if not parameter.value("ResourceName"):
        yield "a texture without ResourceName"
    if str(parameter.value("ResourceType", "")).lower() not in SHAPES:
        yield f"ResourceType must be one of {', '.join(sorted(SHAPES))}"


def sampler_defects(parameter, textures):
    """Whether a sampler reads a texture of this effect, in the spelling that both sides read."""
    text = " ".join(parameter.initial)
    match = re.search(r"\bTexture = (\S) (\w+) \S ;", text)
    if not match:
        yield "no Texture = (name); in its sampler_state"
    elif match[2] not in textures:
        yield f"Texture {match[2]} is not a texture of this effect"
    elif match[1] != "(":
        yield f"Texture = <{match[2]}> should be ({match[2]}): Wine's compiler reads no <>"


def parameter_defects(effect):
    """Yields (name, defect) over all parameters."""
    textures = {p.name for p in effect.parameters if p.type.lower() in TEXTURES}
    for parameter in effect.parameters:
        checks = [annotation_defects, widget_defects, range_defects, semantic_defects]
        if parameter.name in textures:
            checks.append(texture_defects)
        if parameter.type.lower().startswith("sampler"):
            checks = [lambda p: sampler_defects(p, textures)]
        for check in checks:
            for defect in check(parameter):
                yield parameter.name, defect
    names = Counter(p.value("UIName") for p in effect.parameters if p.value("UIName"))
    for name in (name for name, times in names.items() if times > 1):
        yield "UIName", f'"{name}" names two parameters'


def script_value(item, verb):
    """The names after `verb=` in the Script annotation of a technique or pass."""
    scripts = [str(a.value) for a in item.annotations if a.name.lower() == "script"]
    return re.findall(rf"\b{verb}=(\w+);", scripts[0], re.IGNORECASE) if scripts else None


def pass_defects(one):
    """Shaders, their profiles, and the render states of a pass."""
    chosen = {kind: entry_of(one, kind) for kind in PROFILES}
    for kind, entry in chosen.items():
        if not entry:
            yield f"no {kind} = compile PROFILE Name();"
        elif entry[1] not in PROFILES[kind]:
            yield f"{kind} profile {entry[1]} is none of {', '.join(PROFILES[kind])}"
    models = {entry[1][3] for entry in chosen.values() if entry}
    if models == {"2", "3"}:
        yield "shader model 3 runs only with shader model 3: one profile is 2_0, the other 3_0"
    for name, words in one.states.items():
        value = "".join(words).lower()
        if name not in PROFILES and value not in STATES.get(name.lower(), ()):
            yield f"state {name} = {''.join(words)} is unknown"
    if script_value(one, "Draw") not in (None, ["geometry"]):
        yield 'Script of a pass must be "Draw=geometry;"'


def technique_defects(effect):
    """Yields (name, defect) over techniques and passes."""
    if not effect.techniques:
        yield "effect", "no technique"
    for technique in effect.techniques:
        names = [one.name for one in technique.passes]
        if not names:
            yield technique.name, "no pass"
        if script_value(technique, "Pass") not in (None, names):
            yield technique.name, f"Script must run the passes {', '.join(names)}"
        for one in technique.passes:
            for defect in pass_defects(one):
                yield f"{technique.name}.{one.name}", defect


def entry_of(one, kind):
    """(entry, profile) of a pass's VertexShader or PixelShader, or None."""
    words = one.states.get(kind, [])
    fits = len(words) == 5 and words[0] == "compile" and words[3:] == ["(", ")"]
    return (words[2], words[1]) if fits else None


def entries(effect):
    """Every (entry, profile) that a pass compiles, each once, in order."""
    found = [entry_of(one, kind) for technique in effect.techniques for one in technique.passes
             for kind in PROFILES]
    return list(dict.fromkeys(entry for entry in found if entry))


def compile_defects(path, wanted):
    """Compiles the entries, prints their slots, and yields (entry, defect)."""
    results = compile_fx.compile_entries([(path, *entry) for entry in wanted])
    for (name, profile), result in zip(wanted, results):
        said = [line for line in result.messages.splitlines() if line]
        for line in said[:-1] if len(said) > 1 and not result.ok else said:  # the last repeats
            yield f"{name} as {profile}", line
        if result.ok:
            slots = result.slots
            print(f"{name} as {profile}: {slots.total} slots, "
                  f"{slots.without_copies} without copies")
            if d3d9_slots.over_the_limit(slots, profile):
                yield f"{name} as {profile}", d3d9_slots.over_the_limit(slots, profile)


def main(arguments):
    """The command line."""
    if len(arguments) != 1:
        sys.exit(__doc__)
    path = Path(arguments[0])
    try:
        effect = fx_file.read_effect(path.read_text(encoding="utf-8"))
        defects = [*parameter_defects(effect), *technique_defects(effect)]
        reason = compile_fx.why_not_installed(compile_fx.trixie_folder())
        if not reason:
            defects += compile_defects(path, entries(effect))
    except fx_file.FxError as error:
        defects, reason = [("effect", str(error))], ""
    except compile_fx.WineFailed as failure:
        print(failure, file=sys.stderr)
        return 2
    for name, defect in defects:
        print(f"{path.name}: {name}: {defect}")
    if reason:
        print(f"nothing compiled: {reason}", file=sys.stderr)
    return 1 if defects else 3 if reason else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
