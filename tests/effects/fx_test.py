"""Tests the checker of effects, on Table 1 and on broken copies of it.

Exit status 0: all passed; 1: a failure; 3: passed, but the compiler's tests did not run.
"""

import contextlib
import io
import sys
import tempfile
import time
import unittest
from pathlib import Path

import check_fx
import compile_fx
import d3d9_slots
import fx_file

TABLE_1 = Path(__file__).with_name("table1.fx")
PAPERS_OWN = "SpecularPower: default 55 is outside UIMin 0 to UIMax 16"
REASON = compile_fx.why_not_installed(compile_fx.trixie_folder())


def defects_of(text):
    """The checker's output without a compiler, one line per defect."""
    effect = fx_file.read_effect(text)
    return [f"{name}: {defect}" for defect_list in (check_fx.parameter_defects(effect),
                                                    check_fx.technique_defects(effect))
            for name, defect in defect_list]


def changed(old, new):
    """Table 1 with one place changed."""
    text = TABLE_1.read_text(encoding="utf-8")
    assert text.count(old) == 1, f"{old!r} must occur in table1.fx once"
    return text.replace(old, new)


class Reader(unittest.TestCase):
    """fx_file."""

    def test_parameters_keep_type_semantic_and_annotations(self):
        effect = fx_file.read_effect(TABLE_1.read_text(encoding="utf-8"))
        self.assertEqual([p.name for p in effect.parameters],
                         ["WorldInverseTranspose", "WorldViewProjection", "World", "EyePos",
                          "LightPos", "AmbientValue", "SpecularPower", "ColorTexture",
                          "ColorSampler"])
        light = effect.parameters[4]
        self.assertEqual((light.type, light.semantic), ("float3", "Position"))
        self.assertEqual(light.value("space"), "World")
        self.assertEqual(fx_file.numbers_in(light.initial), [-0.5, 2.0, 1.25])

    def test_passes_keep_states_and_entries(self):
        effect = fx_file.read_effect(TABLE_1.read_text(encoding="utf-8"))
        self.assertEqual(check_fx.entries(effect),
                         [("PhongVertexShader", "vs_2_0"), ("LumaDiffusePS", "ps_2_0")])
        self.assertEqual(effect.techniques[0].passes[0].states["CullMode"], ["None"])

    def test_comments_and_strings_do_not_mix(self):
        effect = fx_file.read_effect('float a < string UIName = "a // b > c"; > = 1; // > "\n'
                                     '/* float b; */ float c = -2.5f;')
        self.assertEqual(effect.parameters[0].value("UIName"), "a // b > c")
        self.assertEqual(fx_file.numbers_in(effect.parameters[1].initial), [-2.5])

    def test_a_file_cut_short_is_refused(self):
        text = TABLE_1.read_text(encoding="utf-8")
        with self.assertRaises(fx_file.FxError):
            fx_file.read_effect(text[:text.rindex("}")])

    def test_constants_are_no_parameters(self):
        effect = fx_file.read_effect("static const float3x3 M = {1, 2, 3, 4, 5, 6, 7, 8, 9};")
        self.assertEqual(effect.parameters, [])


class Annotations(unittest.TestCase):
    """check_fx, each rule by a copy of Table 1 that breaks it alone."""

    def test_table_1_has_the_one_defect_of_the_paper(self):
        self.assertEqual(defects_of(TABLE_1.read_text(encoding="utf-8")), [PAPERS_OWN])

    def test_a_default_inside_the_slider_mends_it(self):
        self.assertEqual(defects_of(changed("= 55.0;", "= 5.5;")), [])

    def test_each_broken_rule_is_named(self):
        for old, new, defect in BROKEN:
            with self.subTest(defect):
                self.assertEqual(set(defects_of(changed(old, new))) - {PAPERS_OWN}, {defect})


BROKEN = [  # a place of Table 1, what replaces it, and the one defect that must be reported
    ("> = 0.1;", "> = 1.5;", "AmbientValue: default 1.5 is outside UIMin 0 to UIMax 1"),
    ("> = 0.1;", "> = -0.5;", "AmbientValue: default -0.5 is outside UIMin 0 to UIMax 1"),
    ("> = 0.1;", ">;", "AmbientValue: no default value"),
    ("float UIMax = 1.0;", "float UIMax = 0.0;", "AmbientValue: UIMin 0 is not below UIMax 0"),
    ("float UIMax = 1.0;", "", "AmbientValue: a slider without UIMax"),
    ("float UIMax = 1.0;", 'string UIMax = "1";', "AmbientValue: UIMax must be one number"),
    ("float UIStep = 0.1;", "float UIStep = 2.0;",
     "AmbientValue: UIStep 2 does not fit between UIMin and UIMax"),
    ("float UIStep = 0.1;", "float UIStep = 0.1; float UIStep = 0.1;",
     "AmbientValue: uistep is given twice"),
    ('string UIName = "Ambient Value";', "",
     'AmbientValue: no UIName; only a parameter with UIWidget = "None" needs none'),
    ('"Ambient Value"', '"Specular Power"', 'UIName: "Specular Power" names two parameters'),
    ("float AmbientValue <\n  string UIName = \"Ambient Value\";\n  string UIWidget = \"slider\"",
     "float AmbientValue <\n  string UIName = \"Ambient Value\";\n  string UIWidget = \"knob\"",
     "AmbientValue: UIWidget knob is none of color, none, numeric, slider"),
    (": CameraPosition", ": EyePlace", "EyePos: unknown semantic EyePlace"),
    ("float4x4 World :", "float3x3 World :", "World: World is float4x4, not float3x3"),
    ('string Object = "PointLight0";', "", "LightPos: Position without Object: whose?"),
    ('"PointLight0"', '"Lamp"', "LightPos: Object Lamp is not a light such as PointLight0"),
    ('string Space = "World";', "", "LightPos: Position without Space"),
    ('"World"', '"Screen"', "LightPos: Space Screen is none of object, view, world"),
    ('string ResourceName = "default_color.dds";', "",
     "ColorTexture: a texture without ResourceName"),
    ('"2D"', '"flat"', "ColorTexture: ResourceType must be one of 1d, 2d, 3d, cube"),
    ("(ColorTexture)", "(Other)", "ColorSampler: Texture Other is not a texture of this effect"),
    ("(ColorTexture)", "<ColorTexture>",
     "ColorSampler: Texture = <ColorTexture> should be (ColorTexture): "
     "Wine's compiler reads no <>"),
    ("Pass=p0;", "Pass=p1;", "PhongDiffuse: Script must run the passes p0"),
    ("compile ps_2_0 LumaDiffusePS()", "NULL",
     "PhongDiffuse.p0: no PixelShader = compile PROFILE Name();"),
    ("compile ps_2_0", "compile ps_3_0",
     "PhongDiffuse.p0: shader model 3 runs only with shader model 3: "
     "one profile is 2_0, the other 3_0"),
    ("compile vs_2_0", "compile vs_1_1",
     "PhongDiffuse.p0: VertexShader profile vs_1_1 is none of vs_2_0, vs_3_0"),
    ("CullMode = None", "CullMode = Some", "PhongDiffuse.p0: state CullMode = Some is unknown"),
]


class Slots(unittest.TestCase):
    """d3d9_slots."""

    def test_declarations_are_free_and_macros_cost_their_slots(self):
        slots = d3d9_slots.count("ps_2_0\ndcl t0.xy\ndcl_2d s0\ndef c0, 1, 2, 3, 4\n"
                                 "texld r0, t0, s0\nnrm r1.xyz, r0\nmov_sat r1, r1\nmov oC0, r1\n")
        self.assertEqual((slots.arithmetic, slots.texture, slots.copies), (5, 1, 1))

    def test_fetches_cost_more_in_model_3(self):
        text = "ps_{}_0\ndcl_cube s1\ntexld r0, v0, s1\ntexldb r1, v0, s2\ntexkill r0\n"
        self.assertEqual(d3d9_slots.count(text.format(2)).texture, 1 + 1 + 1)
        self.assertEqual(d3d9_slots.count(text.format(3)).texture, 4 + 6 + 2)

    def test_ps_2_0_holds_64_arithmetic_and_32_texture_slots(self):
        fits = d3d9_slots.Slots(arithmetic=164, texture=32, copies=100)
        self.assertEqual(d3d9_slots.over_the_limit(fits, "ps_2_0"), "")
        for slots in (d3d9_slots.Slots(165, 0, 100), d3d9_slots.Slots(0, 33, 0)):
            self.assertIn("ps_2_0 has", d3d9_slots.over_the_limit(slots, "ps_2_0"))
            self.assertEqual(d3d9_slots.over_the_limit(slots, "ps_3_0"), "")

    def test_other_text_is_no_assembly(self):
        with self.assertRaises(ValueError):
            d3d9_slots.count("mov r0, r1\n")


@unittest.skipIf(REASON, f"not installed: {REASON}")
class Compiler(unittest.TestCase):
    """compile_fx, with Wine."""

    def test_table_1_compiles_in_both_shader_models(self):
        wanted = [(TABLE_1, entry, profile)
                  for entry, profiles in (("LumaDiffusePS", ("ps_2_0", "ps_3_0")),
                                          ("PhongVertexShader", ("vs_2_0", "vs_3_0")))
                  for profile in profiles]
        for (_, _, profile), result in zip(wanted, compile_fx.compile_entries(wanted)):
            with self.subTest(profile):
                self.assertTrue(result.ok, result.messages)
                self.assertEqual(result.messages, "")
                self.assertTrue(result.disassembly.startswith(profile))

    def test_table_1s_pixel_shader_fetches_once_and_fits_ps_2_0(self):
        slots = compile_fx.compile_entry(TABLE_1, "LumaDiffusePS", "ps_2_0").slots
        self.assertEqual(slots.texture, 1)
        # 9 for three normalisations, 3 for pow, 3 + 6 for the matrices; everything else is added
        self.assertGreater(slots.arithmetic - slots.copies, 21)
        self.assertEqual(d3d9_slots.over_the_limit(slots, "ps_2_0"), "")

    def test_a_refused_entry_does_not_stop_the_others(self):
        good, missing = ("LumaDiffusePS", "ps_2_0"), ("NoSuchShader", "ps_2_0")
        results = compile_fx.compile_entries([(TABLE_1, *entry) for entry in (good, missing, good)])
        self.assertEqual([result.ok for result in results], [True, False, True])
        self.assertIn('Entry point "NoSuchShader" is not defined', results[1].messages)

    def test_a_misspelt_function_is_a_defect_with_its_line(self):
        status, printed = check(changed("TexCol = YIQtoRGB(WorkCol)", "TexCol = YIQtoRG(WorkCol)"))
        self.assertEqual(status, 1)
        self.assertRegex(printed, r"broken\.fx:\d+:\d+: E5005: Function \"YIQtoRG\"")

    def test_a_sound_effect_ends_with_0_and_prints_slots(self):
        status, printed = check(changed("= 55.0;", "= 5.5;"))
        self.assertEqual(status, 0, printed)
        self.assertRegex(printed, r"LumaDiffusePS as ps_2_0: \d+ slots, \d+ without copies")

    def test_a_shader_too_long_for_ps_2_0_is_a_defect(self):
        long = "".join(f"OutCol.x = OutCol.x * OutCol.y + {n}.5;" for n in range(40))
        status, printed = check(changed("  return OutCol;\n", f"{long} return OutCol;\n"))
        self.assertEqual(status, 1)
        self.assertRegex(printed, r"\d+ arithmetic slots without copies, ps_2_0 has 64")

    def test_a_deadline_ends_everything_that_runs(self):
        seconds = "54321"  # distinguishes this sleep from others
        with self.assertRaises(compile_fx.WineFailed):
            compile_fx.run(compile_fx.trixie_folder(), "/", time.monotonic() + 1,
                           ["/bin/sh", "-c", f"setsid sleep {seconds} & sleep {seconds}"])
        time.sleep(0.5)  # the kernel ends a namespace's processes after its first
        self.assertNotIn(f"sleep\0{seconds}\0".encode(), running_commands())

    def test_nothing_stays_mounted(self):
        compile_fx.compile_entry(TABLE_1, "LumaDiffusePS", "ps_2_0")
        mounts = Path("/proc/mounts").read_text(encoding="utf-8")
        self.assertNotIn(str(compile_fx.trixie_folder()), mounts)


def running_commands():
    """The command line of every process, words separated by zero bytes."""
    commands = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):  # it ended in the meantime
            commands.append(path.read_bytes())
    return commands


def check(text):
    """check_fx.main on this text: its exit status and what it printed."""
    printed = io.StringIO()
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(printed):
        path = Path(folder, "broken.fx")
        path.write_text(text, encoding="utf-8")
        status = check_fx.main([str(path)])
    return status, printed.getvalue()


def main():
    """Runs the tests."""
    result = unittest.main(argv=[sys.argv[0], "-v"], exit=False).result
    return 1 if not result.wasSuccessful() else 3 if result.skipped else 0


if __name__ == "__main__":
    sys.exit(main())
