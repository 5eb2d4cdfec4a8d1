// The program as a user sees it.
#include <gmock/gmock.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "exporters/mesh/format.h"
#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(Program, a_missing_or_unknown_command_is_refused) {
  expect_refused({}, "no command given");
  expect_refused({"reder"}, "reder");
  expect_refused({"render", "figure2"}, "--output");
  expect_refused({"render", "--fast", "--simd", "mmx", "-o", "out.png"}, "avx512");
}

TEST_F(Program, a_built_in_scene_is_printed_and_reads_back_as_itself) {
  const std::string first = lumaknot({"scene", "figure2"}).log;
  write("scene.json", first);
  EXPECT_EQ(lumaknot({"scene", "scene.json"}).log, first);
}

TEST_F(Program, bad_scenes_are_refused_with_path_value_and_remedy) {
  const auto refused = [this](const std::string& json, const std::string& part) {
    write("scene.json", json);
    expect_refused({"render", "scene.json", "-o", "out.png"}, part);
    EXPECT_FALSE(fs::exists(path("out.png")));
  };
  refused(R"({"mesh": {"knot": {"tube": -1}}})", "mesh.knot.tube must be > 0, got -1");
  refused(R"({"mesh": {"knot": {"tube": 0}}})", "mesh.knot.tube must be > 0, got 0");
  refused(R"({"mesh": {"knot": {"segments": 2}}})", "mesh.knot.segments");
  refused(R"({"mesh": {"knot": {"sides": "40"}}})",
          "mesh.knot.sides must be an integer, got \"40\"");
  refused(R"({"lights": [{"point": {"position": [1, 2]}}]})",
          "lights[0].point.position must be three numbers");
  refused(R"({"light": {"position": [1, 2, 3]}})", "light is not a known key; known here: mesh");
  refused(R"({"ambient": 1e999})", "scene.json: ambient is '1e999'");
  refused(R"({"camera": {"fov": 40}})", "camera.fov is not a known key");
  refused(R"({"texture": {"file": "none.png"}})", "texture.file");
  refused(R"({"mesh": {"file": "none.obj"}})", "mesh.file");
  refused("{", "scene.json is not JSON");
  write("none.png", "not an image");
  refused(R"({"texture": {"file": "none.png"}})", "none.png");
  ASSERT_THAT(lumaknot({"render", "figure2", "-o", "cut.png"}), ExitsWith(0));
  fs::resize_file(path("cut.png"), fs::file_size(path("cut.png")) / 2);
  refused(R"({"texture": {"file": "cut.png"}})", "cut.png");
  write("none.obj", "not a mesh");
  refused(R"({"mesh": {"file": "none.obj"}})", "none.obj");
}

TEST_F(Program, outputs_that_cannot_be_written_are_refused_before_the_work) {
  expect_refused({"render", "figure2", "-o", "out.jpg"}, "--output out.jpg must end in");
  expect_refused({"render", "figure2", "-o", "no/such/folder/out.png"}, "--output");
  expect_refused({"mesh", "-o", "knot.stp"}, "--output knot.stp must end in");
  expect_refused({"mesh", "--tube", "-1", "-o", "knot.obj"}, "--tube must be > 0, got -1");
  expect_refused({"mesh", "--tube", "nan", "-o", "knot.obj"}, "--tube must be a finite number");
  expect_refused({"mesh", "--p", "0", "--q", "0", "-o", "knot.obj"}, "--p and --q must not both");
  expect_refused({"mesh", "--tube", "1.5", "-o", "knot.obj"}, "--tube must be < --ring");
  expect_refused({"mesh", "--tube", "0.5", "--strict", "-o", "knot.obj"}, "--tube 0.5 passes");
  expect_refused({"mesh"}, "give --output FILE");
  expect_refused({"mesh", "--max-error", "0", "-o", "knot.obj"}, "--max-error must be > 0");
  expect_refused({"mesh", "--max-error", "0.1", "--sides", "9", "-o", "knot.obj"}, "--max-error");
  expect_refused({"mesh", "--convention", "maya", "-o", "knot.obj"}, "--convention must be one of");
  expect_refused({"mesh", "--segments", "9000000", "--sides", "90000", "-o", "knot.obj"},
                 "--segments x --sides");
  expect_refused({"export", "figure2", "-o", "knot.fbx"},
                 "--output knot.fbx must end in .pov, .py, .blend, .glb, .gltf or .obj\n");
  expect_refused({"export", "figure2", "-o", "it's.py"}, "quotes");
  write("report", "a file in the way");
  expect_refused({"validate", "figure2", "-o", "report"}, "--output report");
  EXPECT_EQ(read("report"), "a file in the way");
}

TEST_F(Program, an_existing_output_survives_a_failure) {
  write("out.png", "precious");
  write("scene.json", R"({"texture": {"file": "none.png"}})");
  expect_refused({"render", "scene.json", "-o", "out.png"}, "texture.file");
  EXPECT_EQ(read("out.png"), "precious");
  EXPECT_EQ(files(), (std::vector<std::string>{"out.png", "scene.json"})) << "no partial file";
}

TEST_F(Program, no_command_overwrites_the_inputs_of_a_scene) {
  lumaknot({"render", "figure2", "--fast", "-o", "wall.png"});
  lumaknot({"mesh", "--segments", "24", "--sides", "6", "-o", "knot.obj"});
  write("report.json", R"({"mesh": {"file": "knot.obj"}, "texture": {"file": "wall.png"},
                           "image": {"width": 24, "height": 20}})");
  fs::create_symlink("report.json", path("chart.csv"));
  fs::copy_file(path("wall.png"), path("a.texture.png"));
  write("a.json", R"({"texture": {"file": "a.texture.png"}})");
  const std::vector<std::string> before = files();
  const std::string scene = read("report.json"), wall = read("wall.png"), knot = read("knot.obj");
  expect_refused({"render", "report.json", "-o", "wall.png"}, "would overwrite texture.file");
  expect_refused({"render", "a.json", "-o", "./a.texture.png"}, "overwrite texture.file");
  expect_refused({"budget", "a.json", "-o", "a.texture.png"}, "overwrite texture.file");
  expect_refused({"bench", "report.json", "-o", "report.json"}, "would overwrite the scene");
  expect_refused({"bench", "report.json", "--picture", "report.json"}, "--picture report.json");
  expect_refused({"export", "report.json", "-o", "knot.obj"}, "would overwrite mesh.file");
  expect_refused({"export", "a.json", "-o", "a.obj"}, "would overwrite texture.file");
  expect_refused({"validate", "report.json", "-o", "."}, "would overwrite the scene");
  expect_refused({"chart", "report.json", "-o", "."}, "chart.csv would overwrite the scene");
  EXPECT_EQ(files(), before);
  fs::copy_file(path("report.json"), path("parameters.json"));
  expect_refused(
      {"shader", "--scene", "parameters.json", "--lang", "glsl-330", "-o", ".", "--quiet"},
      "parameters.json would overwrite the scene");
  EXPECT_EQ(read("parameters.json"), scene);
  EXPECT_EQ(read("report.json"), scene);
  EXPECT_EQ(read("wall.png"), wall);
  EXPECT_EQ(read("knot.obj"), knot);
}

TEST_F(Program, the_same_input_gives_the_same_bytes) {
  for (const std::string& ending : mesh_endings(&MeshFormat::write)) {
    const std::string name = "knot" + ending;
    lumaknot({"mesh", "--segments", "30", "--sides", "8", "-o", name, "--quiet"});
    const std::string first = read(name);
    lumaknot({"mesh", "--segments", "30", "--sides", "8", "-o", name, "--quiet"});
    EXPECT_TRUE(read(name) == first) << name;
  }
  for (const std::string name :
       {"knot.exr", "knot.png", "knot.pov", "knot.py", "knot.glb", "knot.obj"}) {
    const std::string command = name.ends_with("r") || name.ends_with("g") ? "render" : "export";
    ASSERT_THAT(lumaknot({command, "figure1-back", "-o", name}), ExitsWith(0));
    const std::string first = read(name);
    std::this_thread::sleep_for(
        std::chrono::milliseconds(1100));  // so that a time stamp would differ
    lumaknot({command, "figure1-back", "-o", name});
    EXPECT_TRUE(read(name) == first) << name;
    EXPECT_EQ(first.find(folder_.path().string()), std::string::npos) << "a path of this machine";
  }
}

TEST_F(Program, quiet_prints_nothing_and_json_is_json) {
  EXPECT_EQ(lumaknot({"render", "figure2", "-o", "a.png", "--quiet"}).log, "");
  const auto json = nlohmann::json::parse(lumaknot({"mesh", "-o", "k.obj", "--json"}).log);
  EXPECT_EQ(json["vertices"], 31529);
  EXPECT_EQ(json["triangles"], 61440);
}

TEST_F(Program, fast_frames_take_multisample_instead_of_the_scene_s_samples) {
  write("scene.json", R"({"image": {"width": 32, "height": 24, "samples": 2}})");
  expect_refused({"render", "scene.json", "--fast", "-o", "fast.png"},
                 "image.samples must be 1 here, got 2; use --multisample 4 instead");
  for (const std::string samples : {"4", "1"}) {
    const ProcessResult result = lumaknot(
        {"render", "scene.json", "--fast", "--multisample", samples, "-o", samples + ".png"});
    EXPECT_THAT(result, ExitsWith(0));
  }
  write("scene.json", R"({"image": {"width": 32, "height": 24}})");
  lumaknot({"render", "scene.json", "--fast", "--multisample", "4", "-o", "plain.png"});
  EXPECT_EQ(read("4.png"), read("plain.png"));
  EXPECT_NE(read("4.png"), read("1.png"));
}

TEST_F(Program, files_of_a_scene_are_relative_to_it) {
  fs::create_directory(path("sub"));
  ASSERT_THAT(lumaknot({"mesh", "--segments", "30", "--sides", "8", "-o", "sub/k.obj"}),
              ExitsWith(0));
  write("sub/scene.json", R"({"mesh": {"file": "k.obj"}, "texture": {"color": [0.5, 0.5, 0.9]}})");
  const ProcessResult result = lumaknot({"render", "sub/scene.json", "-o", "out.png"});
  EXPECT_THAT(result, ExitsWith(0));
}

TEST_F(Program, truth_and_budget_need_a_knot_with_an_exact_surface) {
  write("file.json", R"({"mesh": {"file": "mesh.obj"}, "texture": {"color": [1, 1, 1]}})");
  write("three.json", R"({"mesh": {"knot": {"convention": "three"}}})");
  expect_refused({"render", "file.json", "--truth", "-o", "out.png"}, "--truth needs mesh.knot");
  expect_refused({"render", "three.json", "--truth", "-o", "out.png"}, "has no exact surface");
  expect_refused({"render", "figure2", "--truth", "exact", "-o", "out.png"}, "--truth");
  expect_refused({"budget", "file.json"}, "a budget needs mesh.knot");
  EXPECT_THAT(files(), ::testing::ElementsAre("file.json", "three.json"));
}

TEST_F(Program, validate_without_renderers_reports_nothing_to_compare) {
  const std::string none = "/nonexistent/program";
  const ProcessResult result = lumaknot(
      {"validate", "figure2", "--povray", none, "--blender", none, "--gpu", none, "-o", "r"});
  EXPECT_THAT(result, ExitsWith(3));
  EXPECT_THAT(result.log, HasSubstr("skipped: /nonexistent/program not found"));
  EXPECT_EQ(nlohmann::json::parse(read("r/report.json"))["verdict"], "nothing to compare");
}

TEST_F(Program, validate_refuses_allowances_that_mean_nothing) {
  const auto refused = [this](const std::string& value, const std::string& part) {
    expect_refused({"validate", "figure2", "--allow", value, "-o", "report"}, part);
  };
  refused("turned-normals=20%", "known: turned-normal, gated-highlight, texel-edge, silhouette");
  refused("turned-normal", "--allow turned-normal must be a share");
  refused("turned-normal=20", "from 0 to 1 or from 0% to 100%, got 20");
  refused("all=0.01,coverage=101%", "--allow coverage must be a share");
  refused("silhouette=-1%", "got -1%");
  expect_refused({"validate", "figure2", "--junit", "no/folder/tests.xml", "-o", "report"},
                 "--junit no/folder/tests.xml");
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(Program, validate_refuses_limits_that_mean_nothing) {
  const auto refused = [this](const std::string& value, const std::string& part) {
    expect_refused({"validate", "figure2", "--limit", value, "-o", "report"}, part);
  };
  refused("median=0.1", "--limit median=0.1 is not a known limit; known: max, p99.9, mean");
  refused("max", "--limit max must be a number from 0 to 1");
  refused("max=0.1,mean=1.5", "--limit mean=1.5 must be a number from 0 to 1");
  refused("p99.9=-0.1", "from 0 to 1");
  const auto file_refused = [this](const std::string& text, const std::string& part) {
    write("limits.json", text);
    expect_refused({"validate", "figure2", "--limits", "limits.json", "-o", "report"}, part);
  };
  file_refused("[1]", "must hold a JSON object");
  file_refused(R"({"blender": {}})", "blender is not a known renderer; known: cycles, povray");
  file_refused(R"({"gl": 0.5})", "limits.json: gl must be an object");
  file_refused(R"({"gl": {"least": 0.5}})", "limits.json: gl.least is not a known limit");
  file_refused(R"({"gl": {"max": "0.5"}})", "limits.json: gl.max must be a number from 0 to 1");
  expect_refused({"validate", "figure2", "--limits", "none.json", "-o", "report"}, "none.json");
  EXPECT_THAT(files(), ::testing::ElementsAre("limits.json"));
}

TEST_F(Program, why_needs_a_cell_of_a_report) {
  expect_refused({"why", "gl/specular"}, "report.json");
  write("report.json", "{}");
  expect_refused({"why", "gl/specular", "--report", "."}, "is not a report of lumaknot validate");
  write("report.json", R"({"renderers": [{"renderer": "GL", "shots": [
    {"shot": "phong", "outcome": "agreed", "comparison": {"limits": {"worst_at": [3, 4],
     "error": 1e-5, "limit": 2e-5, "limit_parts": {"formula": 1.5e-5, "output": 0}}}}]}]})");
  expect_refused({"why", "gl/specular", "--report", "."}, "there are: gl/phong");
  const ProcessResult result = lumaknot({"why", "gl/phong", "--report", "."});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_EQ(result.log,
            "gl/phong: agreed. Nearest to its limit is the pixel (3, 4): error 1e-05\n"
            "limit 2e-05, of\n  formula              1.5e-05\n");
}

TEST_F(Program, validate_refuses_noise_that_means_nothing) {
  const auto refused = [this](const std::vector<std::string>& flags, const std::string& part) {
    std::vector<std::string> arguments{"validate", "figure2", "-o", "report"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    expect_refused(arguments, part);
  };
  refused({"--noise", "0"}, "--noise");
  refused({"--noise", "1"}, "--noise");
  refused({"--noise", "-3"}, "--noise");
  refused({"--noise", "1000000"}, "--noise");
  refused({"--noise", "64", "--renderer", "gl"},
          "gl draws no random samples; give --renderer cycles");
  refused({"--noise", "64", "--renderer", "cycles,povray"}, "--noise draws with one renderer");
  refused({"--noise", "64", "--limit", "max=0.1"}, "--limit");
  refused({"--noise", "64", "--allow", "all=20%"}, "--allow");
  refused({"--noise", "64", "--self-test"}, "--self-test");
  refused({"--seed", "3"}, "--noise");
  refused({"--noise", "64", "--seed", "-1"}, "--seed");
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(Program, validate_reports_noise_without_blender_as_nothing_to_compare) {
  const ProcessResult result = lumaknot(
      {"validate", "figure2", "--noise", "16", "--blender", "/nonexistent/program", "-o", "r"});
  EXPECT_THAT(result, ExitsWith(3));
  EXPECT_THAT(result.log, HasSubstr("Cycles   skipped: /nonexistent/program not found"));
  const auto json = nlohmann::json::parse(read("r/report.json"));
  EXPECT_EQ(json["noise"]["samples"], 16);
  EXPECT_EQ(json["command"],
            "lumaknot validate figure2 --noise 16 --blender /nonexistent/program -o r");
}

TEST_F(Program, validate_writes_a_test_case_per_renderer_and_rung) {
  const std::string none = "/nonexistent/program";
  EXPECT_THAT(lumaknot({"validate", "figure2", "--renderer", "povray,cycles", "--model", "phong",
                        "--povray", none, "--blender", none, "--junit", "r/tests.xml", "-o", "r"}),
              ExitsWith(3));
  const std::string xml = read("r/tests.xml");
  EXPECT_THAT(xml, HasSubstr("tests=\"10\" failures=\"0\" errors=\"0\" skipped=\"10\""))
      << "two renderers; coverage, texture, diffuse, specular and phong";
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"POV-Ray\" name=\"coverage\"><skipped "));
  write("parse.py", "import xml.etree.ElementTree as e; e.parse('r/tests.xml')");
  EXPECT_TRUE(run_here({"/usr/bin/python3", "parse.py"}, {}).succeeded());
}

TEST_F(Program, an_interrupt_stops_the_renderers_and_leaves_no_files) {
  write("povray", "#!/bin/sh\necho $$ > " + path("pid").string() + "\nexec sleep 600\n");
  fs::permissions(path("povray"), fs::perms::owner_all);
  Process process({{LUMAKNOT_PROGRAM, "validate", "--renderer", "povray", "--povray",
                    path("povray").string(), "-o", "report"},
                   folder_.path(),
                   {}});
  int pid = 0;
  for (int tries = 0; tries < 600 && pid == 0; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::ifstream(path("pid")) >> pid;
  }
  ASSERT_GT(pid, 0) << process.log();
  process.signal(SIGINT);
  EXPECT_THAT(process.wait(std::chrono::seconds(30)), ExitsWith(130));
  EXPECT_NE(::kill(pid, 0), 0) << "the renderer outlived us";
  for (const std::string& name : files()) EXPECT_FALSE(name.starts_with("lumaknot-")) << name;
}

TEST_F(Program, validate_refuses_a_scene_the_camera_does_not_see) {
  write("scene.json", R"({"camera": {"position": [0, -5, 0], "target": [0, -9, 0]}})");
  expect_refused({"validate", "scene.json", "-o", "report"}, "the camera sees nothing");
}

TEST_F(Program, doctor_reports_how_to_get_what_is_missing) {
  const std::string none = "/nonexistent/program";
  const ProcessResult result = lumaknot({"doctor", "--povray", none, "--blender", none});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_THAT(result.log,
              AllOf(HasSubstr("apt-get install povray"), HasSubstr("apt-get install blender")));
}

TEST_F(Program, published_schema_accepts_the_built_in_scenes_and_refuses_what_we_refuse) {
  write("schema.json", lumaknot({"scene", "--schema"}).log);
  for (const std::string name : {"figure1-front", "figure1-back", "figure1-specular", "figure2"}) {
    write(name + ".json", lumaknot({"scene", name}).log);
  }
  write("bad.json", R"({"mesh": {"knot": {"tube": 0}}})");
  write("worse.json", R"({"mesh": {"knot": {}, "file": "a.obj"}})");
  write("validate.py", R"(
import json, jsonschema
schema = json.load(open("schema.json"))
jsonschema.Draft202012Validator.check_schema(schema)
check = jsonschema.Draft202012Validator(schema).is_valid
for name in ["figure1-front", "figure1-back", "figure1-specular", "figure2"]:
    assert check(json.load(open(name + ".json"))), name
for name in ["bad", "worse"]:
    assert not check(json.load(open(name + ".json"))), name
)");
  const ProcessResult result =
      run({{"/usr/bin/python3", "validate.py"}, folder_.path(), {}}, std::chrono::seconds(60));
  EXPECT_TRUE(result.succeeded()) << result.log;
}

}  // namespace
}  // namespace lumaknot::cli
