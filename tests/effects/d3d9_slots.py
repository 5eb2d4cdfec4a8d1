"""Counts the instruction slots of Direct3D 9 shader assembly.

Slots and limits: the instruction and register tables of vs_2_0, vs_3_0, ps_2_0 and ps_3_0 in
Microsoft's Direct3D 9 shader assembly reference.
"""

import re
from dataclasses import dataclass

# Instructions that take other than one slot.
COMMON = {
    "crs": 2, "lrp": 2, "dp2add": 2, "nrm": 3, "pow": 3, "sgn": 3, "lit": 3, "sincos": 8,
    "m3x2": 2, "m3x3": 3, "m3x4": 4, "m4x3": 3, "m4x4": 4, "dsx": 2, "dsy": 2,
    "if": 3, "ifc": 3, "break_": 3, "breakc": 3, "breakp": 3, "loop": 3, "endloop": 2,
    "rep": 3, "endrep": 2, "call": 2, "callnz": 3, "label": 0,
}
MODEL_3 = {"texkill": 2, "texldb": 6, "texldp": 3, "texldl": 2, "texldd": 3}
CUBE_3 = {"texld": 4, "texldp": 4, "texldl": 5}  # fetches from a cube map
TEXTURE = {"texkill", "texld", "texldb", "texldp", "texldl", "texldd"}
DECLARATIONS = {"dcl", "def", "defi", "defb"}

SAMPLER = re.compile(r"\bs\d+")


@dataclass
class Slots:
    """Instruction slots of a shader."""
    arithmetic: int = 0  # flow control included
    texture: int = 0
    copies: int = 0  # the part of arithmetic that is plain mov

    @property
    def total(self):
        """All slots."""
        return self.arithmetic + self.texture

    @property
    def without_copies(self):
        """All slots except plain copies, which Wine's compiler leaves in and an optimiser removes."""
        return self.total - self.copies


def instructions(disassembly):
    """Yields (mnemonic, the rest of the line), without declarations and comments."""
    lines = [line.split("//")[0].strip() for line in disassembly.splitlines()]
    lines = [line for line in lines if line]
    if not lines or not re.fullmatch(r"[vp]s_[23]_\w+", lines[0]):
        raise ValueError("no shader assembly: it starts with neither vs_ nor ps_")
    for line in lines[1:]:
        mnemonic, _, rest = line.partition(" ")
        if mnemonic.split("_")[0] not in DECLARATIONS:
            yield mnemonic, rest


def slots_of(mnemonic, rest, model, cubes):
    """The slots of one instruction; model: 2 or 3; cubes: the samplers of cube maps."""
    name = "break_" if mnemonic.startswith("break_") else mnemonic.split("_")[0]
    sampler = SAMPLER.search(rest)
    if model == 3 and name in CUBE_3 and sampler and sampler[0] in cubes:
        return CUBE_3[name]
    if model == 3 and name in MODEL_3:
        return MODEL_3[name]
    return COMMON.get(name, 1)


def count(disassembly):
    """The Slots of a shader."""
    slots = Slots()
    cubes = set(re.findall(r"^\s*dcl_cube\w*\s+(s\d+)", disassembly, re.MULTILINE))
    for mnemonic, rest in instructions(disassembly):
        model = int(disassembly.strip()[3])
        needed = slots_of(mnemonic, rest, model, cubes)
        if mnemonic.split("_")[0] in TEXTURE:
            slots.texture += needed
        else:
            slots.arithmetic += needed
            slots.copies += needed if mnemonic == "mov" else 0
    return slots


def over_the_limit(slots, profile):
    """What in a shader certainly requires an optimiser or a higher profile; empty if nothing does.

    Copies are left out: they are the compiler's, not the effect's.
    """
    arithmetic = slots.arithmetic - slots.copies
    if profile == "ps_2_0":
        if arithmetic > 64:
            return f"{arithmetic} arithmetic slots without copies, ps_2_0 has 64"
        return f"{slots.texture} texture slots, ps_2_0 has 32" if slots.texture > 32 else ""
    limit = 256 if profile == "vs_2_0" else 512
    over = slots.without_copies > limit
    return f"{slots.without_copies} slots without copies, {profile} has {limit}" if over else ""
