"""Tests of a lumaknot to which extend.py has added a toy of each kind: everything that knows the entries of a
kind knows the toy.

    extension_test.py PROGRAM
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = ""


class Toy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_lumaknot(self, *arguments, code=0):
        """What it prints; its message if it is expected to fail."""
        ended = subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True, text=True,
                               check=False, timeout=120)
        self.assertEqual(ended.returncode, code, ended.stdout + ended.stderr)
        return ended.stderr if code == 2 else ended.stdout

    def read(self, name):
        return (self.folder / name).read_text(encoding="utf-8")

    def write_scene(self, **material):
        """A small picture of a knot with the toy model."""
        scene = {"mesh": {"knot": {"segments": 90, "sides": 12}}, "image": {"width": 24, "height": 24},
                 "texture": {"color": [0.7, 0.6, 0.5]}, "material": {"model": "toy", **material}}
        (self.folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")


class ToyModel(Toy):
    def test_scenes_have_its_parameter(self):
        self.write_scene()
        self.assertEqual(json.loads(self.run_lumaknot("scene", "scene.json"))["material"]["wrap"], 0.5)
        material = json.loads(self.run_lumaknot("scene", "--schema"))["properties"]["material"]
        self.assertIn("toy", material["properties"]["model"]["enum"])
        wrap = material["properties"]["wrap"]
        self.assertEqual((wrap["minimum"], wrap["maximum"], wrap["default"]), (0, 1, 0.5))
        self.assertEqual(wrap["description"], "toy: how far light reaches around")

    def test_its_parameter_has_its_range(self):
        self.write_scene(wrap=2)
        self.assertIn("material.wrap must be <= 1", self.run_lumaknot("scene", "scene.json", code=2))

    def test_both_renderers_of_ours_draw_it(self):
        pictures = {}
        for wrap in (0, 1):
            self.write_scene(wrap=wrap)
            for flags in ((), ("--fast",)):
                self.run_lumaknot("render", "scene.json", *flags, "-o", "knot.png")
                pictures[wrap, flags] = (self.folder / "knot.png").read_bytes()
        self.assertNotEqual(pictures[0, ()], pictures[1, ()])
        self.assertNotEqual(pictures[0, ("--fast",)], pictures[1, ("--fast",)])
        self.write_scene(model="blinn-phong")
        self.run_lumaknot("render", "scene.json", "-o", "knot.png")
        self.assertEqual((self.folder / "knot.png").read_bytes(), pictures[0, ()], "Lambert's is wrap 0")

    def test_is_emitted_in_every_space_and_language(self):
        listed = json.loads(self.run_lumaknot("shader", "--list", "--json"))
        self.assertEqual(len({entry["shader"] for entry in listed if entry["shader"].endswith("-toy")}), 11)
        for language in ("glsl-330", "osl", "toy"):
            self.run_lumaknot("shader", "cielab-toy", "--lang", language, "-o", language)
            parameters = json.loads(self.read(f"{language}/parameters.json"))["parameters"]
            wrap = next(entry for entry in parameters if entry["name"] == "wrap")
            self.assertEqual((wrap["default"], wrap["range"], wrap["unit"]), (0.5, [0, 1], "cosine"))

    def test_povray_refuses_what_it_can_not_draw(self):
        self.write_scene()
        self.assertIn("POV-Ray can't draw the toy's diffuse term; nearest: material.wrap 0",
                      self.run_lumaknot("export", "scene.json", "-o", "knot.pov", code=2))
        self.write_scene(wrap=0, shininess=20)
        self.run_lumaknot("export", "scene.json", "-o", "knot.pov")
        self.assertIn("specular 1 roughness 0.05", self.read("knot.pov"))

    def test_gltf_gets_the_width_of_its_highlight(self):
        self.write_scene(shininess=30)
        self.run_lumaknot("export", "scene.json", "-o", "knot.gltf")
        surface = json.loads(self.read("knot.gltf"))["materials"][0]["pbrMetallicRoughness"]
        self.assertAlmostEqual(surface["roughnessFactor"], (2 / 32) ** 0.25)

    def test_plan_knows_its_bounds(self):
        self.write_scene()
        plan = json.loads(self.run_lumaknot("plan", "scene.json", "--tolerance", "0.1", "--rounds", "1",
                                            "--json", "-o", "plan"))
        self.assertIn("toy as phong", json.dumps(plan) + self.read("plan/certificate.json"))


class ToyLanguage(Toy):
    def test_is_emitted_in_its_own_words(self):
        self.run_lumaknot("shader", "yiq-minnaert", "--lang", "toy", "--all-parameters", "-o", "out")
        text = self.read("out/yiq-minnaert.toy")
        self.assertIn("fn yiq_minnaert(position: vec3f, normal: vec3f, ", text)
        self.assertIn("let n_dot_l: f32 = ", text)
        self.assertIn("fn safe_power(base: f32, exponent: f32) -> f32", text)
        for word in ("float ", "vec3 ", "float3", "?"):
            self.assertNotIn(word, text)
        self.assertEqual(json.loads(self.read("out/parameters.json"))["language"], "toy")

    def test_without_a_vertex_stage_refuses_light_at_vertices(self):
        refused = self.run_lumaknot("shader", "yiq-phong", "--lang", "toy", "--rate", "vertex", code=2)
        self.assertIn("toy has no vertex stage", refused)


class ToyFormat(Toy):
    def test_is_written_and_read_again(self):
        self.run_lumaknot("mesh", "--segments", "90", "--sides", "8", "-o", "knot.toy")
        self.assertEqual(len(self.read("knot.toy").splitlines()), 90 * 8 * 2)
        self.write_scene()
        scene = json.loads(self.read("scene.json")) | {"mesh": {"file": "knot.toy"}}
        (self.folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
        self.run_lumaknot("render", "scene.json", "-o", "knot.png")

    def test_is_listed_with_the_others(self):
        self.assertIn(" or .toy", self.run_lumaknot("mesh", "-o", "knot.other", code=2))
        self.assertIn(".toy", self.run_lumaknot("mesh", "--help"))

    def test_refuses_what_its_entry_does_not_have(self):
        self.run_lumaknot("mesh", "--ascii", "--segments", "30", "--sides", "8", "-o", "knot.toy")
        self.assertIn("knot.toy can't hold quads", self.run_lumaknot("mesh", "--quads", "-o", "knot.toy", code=2))

    def test_errors_in_its_files_have_their_line(self):
        (self.folder / "cut.toy").write_text("0 0 0 1 0 0 0 1 0\n0 0 0 1\n")
        (self.folder / "scene.json").write_text('{"mesh": {"file": "cut.toy"}, "texture": {"color": [1, 1, 1]}}')
        self.assertIn("cut.toy, line 2", self.run_lumaknot("render", "scene.json", "-o", "cut.png", code=2))


class ToyRenderer(Toy):
    def test_is_drawn_when_asked_for_and_held_to_its_own_promise(self):
        self.write_scene()
        self.run_lumaknot("validate", "scene.json", "--renderer", "toy", "--toy", "toy-program", "-o", "report",
                          code=1)
        report = json.loads(self.read("report/report.json"))
        self.assertEqual(report["verdict"], "differed", "it draws grey")
        (toy,) = report["renderers"]
        self.assertEqual((toy["renderer"], toy["promise"]["reason"]), ("Toy", "a test"))

    def test_brings_the_flag_of_its_program(self):
        self.assertIn("--toy ", self.run_lumaknot("validate", "--help"))
        self.assertIn("Toy 1", self.run_lumaknot("doctor", "--json"))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop()
    unittest.main()
