// Jobs that can't be done, and lumaknot-gpu's messages.
#include <functional>

#include "tests/gpu/testing.h"
#include "tests/system/exits_with.h"

namespace lumaknot::gpu {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class GpuJob : public GpuTest {
 protected:
  /// A valid job with a mesh, a texture and one draw.
  Json good_job() {
    write("mesh.bin", bytes_of(std::vector<float>(3 * 8, 0.5f)));
    write("indices.bin", bytes_of(std::vector<std::uint32_t>{0, 1, 2}));
    write("texture.bin", bytes_of(std::vector<float>(2 * 2 * 4, 0.5f)));
    write("v.vert",
          "#version 330 core\nlayout(location = 0) in vec3 position;\n"
          "void main() { gl_Position = vec4(position, 1.0); }\n");
    write("f.frag",
          "#version 330 core\nuniform float value;\nuniform sampler2D t;\nout vec4 color;\n"
          "void main() { color = texture(t, vec2(value)); }\n");
    return Json::parse(R"({"api": "gl", "width": 4, "height": 4,
      "mesh": {"vertices": "mesh.bin", "count": 3, "indices": "indices.bin", "triangles": 1},
      "textures": [{"name": "t", "binding": 1, "file": "texture.bin", "width": 2, "height": 2,
                    "filter": "nearest"}],
      "draws": [{"name": "d", "vertex": "v.vert", "fragment": "f.frag", "output": "o.bin",
                 "uniforms": [{"name": "value", "values": [0.5]}]}]})");
  }
  /// Expects exit code `code`, a log that holds `part`, and no picture.
  void expect_end(const Json& job, int code, const std::string& part) {
    const ProcessResult ended = run_job(job);
    EXPECT_THAT(ended, ExitsWith(code));
    EXPECT_THAT(ended.log, AllOf(StartsWith("lumaknot-gpu: "), HasSubstr(part)));
    EXPECT_FALSE(std::filesystem::exists(path("o.bin")));
    if (code != 2) return;
    EXPECT_EQ(std::ranges::count(ended.log, '\n'), 1) << ended.log;
  }
};

struct BadField {
  const char* pointer;  ///< JSON pointer
  const char* value;    ///< as JSON
  const char* message;  ///< part of the message
};

TEST_F(GpuJob, a_wrong_field_is_refused_by_its_name) {
  const std::vector<BadField> cases{
      {"/api", R"("metal")", "api must be gl, gles or vulkan, got metal"},
      {"/api", "3", "api must be a non-empty string, got 3"},
      {"/width", "0", "width must be an integer from 1 to 65536, got 0"},
      {"/height", "1e300", "height must be an integer"},
      {"/height", "1.5", "height must be an integer"},
      {"/samples", "0", "samples must be an integer from 1 to 16, got 0"},
      {"/samples", "17", "samples must be an integer from 1 to 16, got 17"},
      {"/frames", "0", "frames must be an integer from 1"},
      {"/cull", R"("front")", "cull must be none or back, got \"front\""},
      {"/format", R"("half")", "format must be float or bytes"},
      {"/driver", R"("gpu")", "driver must be software or hardware"},
      {"/colour", "1", "\"colour\" is unknown; must be one of"},
      {"/mesh", "[]", "mesh must be an object, got []"},
      {"/mesh/count", "4", "mesh.vertices must have 128 bytes"},
      {"/mesh/count", "1000000000", "mesh.vertices must have 32000000000 bytes"},
      {"/mesh/triangles", "2", "mesh.indices must have 24 bytes"},
      {"/mesh/triangles", "1000000000000", "mesh.triangles must be an integer from 1"},
      {"/mesh/vertices", R"("none.bin")", "mesh.vertices can't be read"},
      {"/mesh/vertices", R"(".")", "mesh.vertices can't be read"},
      {"/mesh/normals", "1", "mesh.normals is unknown; must be one of"},
      {"/textures", "{}", "textures must be a list of objects"},
      {"/textures/0/width", "65536", "textures[0].file must have 2097152 bytes"},
      {"/textures/0/filter", R"("cubic")", "textures[0].filter must be linear, nearest or"},
      {"/textures/0/name", R"("")", "textures[0].name must be a non-empty string"},
      {"/draws", "[]", "draws must hold at least one draw"},
      {"/draws/0", "7", "draws[0] must be an object, got 7"},
      {"/draws/0/vertex", R"("none.vert")", "draws[0].vertex can't be read"},
      {"/draws/0/vertex_entry", R"("vs")", "draws[0].vertex_entry must be main in GLSL"},
      {"/draws/0/uniform_block", R"("b.bin")", "draws[0].uniform_block is unknown; must be one of"},
      {"/draws/0/uniforms/0/values", "[1, 2, 3, 4, 5]", "draws[0].uniforms[0].values must be 1, 2"},
      {"/draws/0/uniforms/0/values", "[1e39]", "within the range of float"},
      {"/draws/0/uniforms/0/values", R"(["1"])", "draws[0].uniforms[0].values must be a list"},
      {"/draws/0/output", R"("no/folder/o.bin")", "can't be written"},
  };
  for (const BadField& bad : cases) {
    SCOPED_TRACE(std::string(bad.pointer) + " = " + bad.value);
    Json job = good_job();
    job[Json::json_pointer(bad.pointer)] = Json::parse(bad.value);
    expect_end(job, 2, bad.message);
  }
}

TEST_F(GpuJob, a_missing_field_is_named) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"api", "api must be a non-empty string, got nothing"},
      {"width", "width must be an integer from 1 to 65536, got nothing"},
      {"draws", "draws must be a list of objects, got nothing"}};
  for (const auto& [key, message] : cases) {
    Json job = good_job();
    job.erase(key);
    expect_end(job, 2, message);
  }
}

TEST_F(GpuJob, an_index_beyond_the_vertices_is_refused) {
  const Json job = good_job();
  write("indices.bin", bytes_of(std::vector<std::uint32_t>{0, 1, 3}));
  expect_end(job, 2, "mesh.indices must be below the mesh's 3 vertices, but index 2 is 3");
}

TEST_F(GpuJob, two_draws_may_not_write_one_file) {
  Json job = good_job();
  job["draws"].push_back(job["draws"][0]);
  job["draws"][1]["output"] = "./o.bin";
  expect_end(job, 2, "is used twice");
}

TEST_F(GpuJob, text_that_is_no_json_is_refused) {
  write("job.json", "{\"api\": \n");
  const ProcessResult ended = gpu({"job.json"});
  EXPECT_THAT(ended, ExitsWith(2));
  EXPECT_THAT(ended.log, AllOf(HasSubstr("job.json is not JSON"), HasSubstr("line 2")));
  EXPECT_THAT(gpu({"none.json"}), ExitsWith(2));
}

TEST_F(GpuJob, wrong_use_is_told) {
  EXPECT_THAT(gpu({}).log, HasSubstr("usage: lumaknot-gpu JOB.json"));
  EXPECT_THAT(gpu({}), ExitsWith(2));
  EXPECT_THAT(gpu({"--version-of", "direct3d"}), ExitsWith(2));
}

class GlJob : public GpuJob, public ::testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    if (const std::string why = missing(GetParam()); !why.empty()) FAIL() << why;
  }
  Json job() {
    Json job = good_job();
    job["api"] = GetParam();
    if (GetParam() == "gl") return job;
    for (const std::string name : {"v.vert", "f.frag"}) {
      std::string code = read_file(path(name), name);
      code.replace(0, code.find('\n'), "#version 300 es\nprecision highp float;");
      write(name, code);
    }
    return job;
  }
  void replace(const std::string& file, const std::string& old, const std::string& by) {
    std::string code = read_file(path(file), file);
    ASSERT_NE(code.find(old), std::string::npos);
    write(file, code.replace(code.find(old), old.size(), by));
  }
};

TEST_P(GlJob, a_good_job_draws) { EXPECT_TRUE(run_job(job()).succeeded()); }

TEST_P(GlJob, version_is_one_line) {
  const ProcessResult ended = gpu({"--version-of", GetParam()});
  EXPECT_THAT(ended, ExitsWith(0));
  EXPECT_EQ(std::ranges::count(ended.log, '\n'), 1);
}

TEST_P(GlJob, a_shader_that_does_not_compile_shows_the_compilers_log) {
  const Json j = job();
  replace("f.frag", "vec2(value)", "vec2(valve)");
  expect_end(j, 3, "draws[0].fragment f.frag does not compile: ");
  EXPECT_THAT(run_job(j).log, HasSubstr("`valve' undeclared"));
}

TEST_P(GlJob, shaders_that_do_not_link_are_told) {
  const Json j = job();
  replace("v.vert", "void main", "uniform vec3 value;\nvoid main");  // a float in the other stage
  replace("v.vert", "vec4(position, 1.0)", "vec4(position * value, 1.0)");
  expect_end(j, 3, "draws[0] d does not link: ");
}

TEST_P(GlJob, a_varying_that_nobody_writes_is_told) {
  const Json j = job();
  replace("f.frag", "void main", "in vec3 n;\nvoid main");
  replace("f.frag", "texture(t, vec2(value))", "texture(t, vec2(value)) + vec4(n, 1.0)");
  expect_end(j, 3, "draws[0] d does not link: ");
}

TEST_P(GlJob, a_uniform_that_the_job_does_not_give_is_told) {
  Json j = job();
  j["draws"][0].erase("uniforms");
  expect_end(j, 2, "the shaders read uniform value, which the job does not set");
}

TEST_P(GlJob, a_texture_that_the_job_does_not_give_is_told) {
  Json j = job();
  j["textures"][0]["name"] = "other";
  expect_end(j, 2, "the shaders read uniform t, which the job does not set");
}

TEST_P(GlJob, a_uniform_of_another_type_is_told) {
  Json j = job();
  j["draws"][0]["uniforms"][0]["values"] = {1, 2, 3};
  expect_end(j, 2, "uniform value is set as vec3");
}

TEST_P(GlJob, an_array_of_uniforms_is_given_element_by_element) {
  Json j = job();
  replace("f.frag", "uniform float value", "uniform float value[2]");
  replace("f.frag", "vec2(value)", "vec2(value[0], value[1])");
  j["draws"][0]["uniforms"][0]["name"] = "value[0]";
  expect_end(j, 2, "the shaders read uniform value");
  j["draws"][0]["uniforms"].push_back({{"name", "value[1]"}, {"values", {0.5}}});
  EXPECT_TRUE(run_job(j).succeeded());
}

TEST_P(GlJob, a_name_that_the_shaders_do_not_use_is_ignored) {
  Json j = job();
  j["draws"][0]["uniforms"].push_back({{"name", "unused"}, {"values", {1, 2, 3}}});
  EXPECT_TRUE(run_job(j).succeeded());
}

TEST_P(GlJob, an_attribute_that_the_mesh_lacks_is_told) {
  const Json j = job();
  replace("v.vert", "location = 0", "location = 3");
  expect_end(j, 2, "reads position at location 3, which the mesh lacks");
}

TEST_P(GlJob, attributes_need_a_mesh) {
  Json j = job();
  j.erase("mesh");
  expect_end(j, 2, "reads position at location 0, which needs a mesh");
}

TEST_P(GlJob, an_image_beyond_the_driver_is_told) {
  Json j = job();
  j["width"] = 65536;
  j["height"] = 65536;
  expect_end(j, 3, "the image has a side of 65536, the driver's limit is ");
}

INSTANTIATE_TEST_SUITE_P(Gpu, GlJob, ::testing::Values("gl", "gles"), api_name);

class VulkanJob : public GpuJob {
 protected:
  void SetUp() override {
    if (const std::string why = missing("vulkan"); !why.empty()) FAIL() << why;
  }
  /// A job with `statements` in a fragment stage that declares `globals`.
  Json job(const std::string& globals, const std::string& statements) {
    write("v.vert",
          "#version 450\nvoid main() { gl_Position = vec4(gl_VertexIndex == 1 ? 3.0 : -1.0,\n"
          "gl_VertexIndex == 2 ? 3.0 : -1.0, 0.5, 1.0); }\n");
    write("f.frag", "#version 450\nlayout(location = 0) out vec4 color;\n" + globals +
                        "void main() {" + statements + "}\n");
    compile("v.vert", "vert");
    compile("f.frag", "frag");
    return Json::parse(R"({"api": "vulkan", "width": 4, "height": 4,
      "draws": [{"name": "d", "vertex": "v.vert.spv", "fragment": "f.frag.spv",
                 "output": "o.bin"}]})");
  }
  Json with_block(Json job, std::size_t bytes) {
    write("block.bin", std::string(bytes, '\0'));
    job["draws"][0]["uniform_block"] = "block.bin";
    return job;
  }
};

const std::string kBlock = "layout(std140, binding = 0) uniform P { vec4 a[4]; float b; };\n";
const std::string kUseBlock = "color = a[3] * b;";

TEST_F(VulkanJob, a_good_job_draws) {
  EXPECT_TRUE(run_job(with_block(job(kBlock, kUseBlock), 80)).succeeded());
  EXPECT_THAT(gpu({"--version-of", "vulkan"}), ExitsWith(0));
}

TEST_F(VulkanJob, a_block_shorter_than_the_shaders_is_told) {
  expect_end(with_block(job(kBlock, kUseBlock), 64), 2, "uniform_block has 64 bytes");
}

TEST_F(VulkanJob, resources_that_the_job_does_not_give_are_told) {
  expect_end(job(kBlock, kUseBlock), 2, "uses a uniform block at set 0, binding 0");
  expect_end(job("layout(binding = 5) uniform sampler2D t;\n", "color = texture(t, vec2(0.5));"), 2,
             "uses a texture with its sampler at set 0, binding 5");
  expect_end(job("layout(push_constant) uniform P { vec4 a; };\n", "color = a;"), 2,
             "uses something else at set 0");
}

TEST_F(VulkanJob, a_resource_that_is_declared_and_not_used_is_no_matter) {
  EXPECT_TRUE(run_job(job(kBlock, "color = vec4(1.0);")).succeeded());
}

TEST_F(VulkanJob, a_varying_that_nobody_writes_is_told) {
  expect_end(job("layout(location = 2) in vec4 v;\n", "color = v;"), 2,
             "reads location 2, which draws[0].vertex v.vert.spv does not write");
}

TEST_F(VulkanJob, two_things_at_one_binding_are_refused) {
  Json j = with_block(job(kBlock, kUseBlock), 80);
  write("t.bin", bytes_of(std::vector<float>(4, 0.0f)));
  j["textures"] = Json::parse(
      R"([{"binding": 0, "file": "t.bin", "width": 1, "height": 1, "filter": "nearest"}])");
  expect_end(j, 2, "uniform_binding 0 is used twice");
}

TEST_F(VulkanJob, what_is_not_spirv_never_reaches_the_driver) {
  Json j = job("", "color = vec4(1.0);");
  j["draws"][0]["fragment"] = "f.frag";
  expect_end(j, 2, "draws[0].fragment f.frag is not a SPIR-V module");
  std::string words = read_file(path("f.frag.spv"), "f.frag.spv");
  write("cut.spv", words.substr(0, words.size() - 4));
  j["draws"][0]["fragment"] = "cut.spv";
  expect_end(j, 3, "draws[0].fragment cut.spv is not valid SPIR-V");
  j["draws"][0]["fragment"] = "v.vert.spv";
  expect_end(j, 2, "v.vert.spv has no fragment entry point main");
  j["draws"][0]["fragment"] = "f.frag.spv";
  j["draws"][0]["fragment_entry"] = "ps";
  expect_end(j, 2, "f.frag.spv has no fragment entry point ps");
}

}  // namespace
}  // namespace lumaknot::gpu
