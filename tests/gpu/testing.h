/// Jobs for lumaknot-gpu, written by hand.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "system/atomic_file.h"
#include "system/process.h"
#include "tests/system/exits_with.h"

namespace lumaknot::gpu {

using Json = nlohmann::ordered_json;
using Pixel = std::array<float, 4>;

/// The bytes of `values` in memory.
template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A folder with a job in it, and the program to run it.
class GpuTest : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& bytes) {
    write_file(path(name), bytes, name);
  }

  ProcessResult gpu(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{LUMAKNOT_GPU};
    all.insert(all.end(), arguments.begin(), arguments.end());
    std::filesystem::remove(path("lumaknot-gpu.log"));
    return run({all, folder_.path(), sanitizer_options()}, std::chrono::seconds(60));
  }
  ProcessResult run_job(const Json& job) {
    write("job.json", job.dump());
    return gpu({"job.json"});
  }
  /// The pixels of a job's output, from the top left.
  std::vector<Pixel> pixels(const std::string& output) const {
    const std::string bytes = read_file(path(output), output);
    std::vector<Pixel> all(bytes.size() / sizeof(Pixel));
    std::memcpy(all.data(), bytes.data(), all.size() * sizeof(Pixel));
    return all;
  }
  /// Compiles the source file `name` to the SPIR-V file `name`.spv; returns whether that succeeded.
  bool compile(const std::string& name, const std::string& stage,
               const std::vector<std::string>& options = {}) {
    std::vector<std::string> all{find_program("glslangValidator").string(), "-V", "-S", stage};
    all.insert(all.end(), options.begin(), options.end());
    all.insert(all.end(), {"-o", name + ".spv", name});
    const ProcessResult ended = run({all, folder_.path(), {}}, std::chrono::seconds(60));
    EXPECT_TRUE(ended.succeeded()) << ended.log;
    return ended.succeeded();
  }
  /// Why `api` can't be tested here, or empty.
  std::string missing(const std::string& api) {
    if (api == "vulkan" && find_program("glslangValidator").empty()) {
      return "glslangValidator is not installed";
    }
    const ProcessResult ended = gpu({"--version-of", api});
    return ended.exit_code == 3 ? ended.log : "";
  }

 private:
  /// A program built with sanitizers needs this test's options. Drivers leak, and are unloaded
  /// before a leak could be attributed to them.
  static std::vector<std::string> sanitizer_options() {
    const char* given = std::getenv("ASAN_OPTIONS");
    return {fmt::format("ASAN_OPTIONS={}:detect_leaks=0", given ? given : "")};
  }

  PrivateFolder folder_;
};

/// The name of an EachApi test's instance.
inline std::string api_name(const ::testing::TestParamInfo<std::string>& info) {
  return info.param;
}

/// A uniform of a test: its GLSL type, name and values, matrices column by column.
struct TestUniform {
  std::string type, name;
  std::vector<float> values;
};

/// A job for one API, written in that API's GLSL.
class EachApi : public GpuTest, public ::testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    if (const std::string why = missing(api()); !why.empty()) FAIL() << why;
    job_ = {{"api", api()},
            {"width", 4},
            {"height", 4},
            {"textures", Json::array()},
            {"draws", Json::array()}};
  }

  std::string api() const { return GetParam(); }
  bool vulkan() const { return api() == "vulkan"; }
  /// The sign of clip space's y at the image's top.
  float top() const { return vulkan() ? -1.0f : 1.0f; }

  void set_size(int width, int height) {
    job_["width"] = width;
    job_["height"] = height;
  }

  /// Vertices of eight floats, and three indices per triangle.
  void set_mesh(const std::vector<float>& vertices, const std::vector<std::uint32_t>& indices) {
    write("mesh.bin", bytes_of(vertices));
    write("indices.bin", bytes_of(indices));
    job_["mesh"] = {{"vertices", "mesh.bin"},
                    {"count", vertices.size() / 8},
                    {"indices", "indices.bin"},
                    {"triangles", indices.size() / 3}};
  }

  /// Adds a texture, its rows from the bottom up. Bindings count from 1.
  void add_texture(const std::string& name, int width, int height, const std::string& filter,
                   const std::vector<float>& rgba) {
    const std::size_t binding = job_["textures"].size() + 1;
    write(name + ".bin", bytes_of(rgba));
    job_["textures"].push_back({{"name", name},
                                {"binding", binding},
                                {"file", name + ".bin"},
                                {"width", width},
                                {"height", height},
                                {"filter", filter}});
  }

  /// The code before a stage's: version, precision, uniforms (a block in Vulkan), textures.
  std::string header(const std::vector<TestUniform>& uniforms) const {
    std::string text = vulkan()        ? "#version 450\n"
                       : api() == "gl" ? "#version 330 core\n"
                                       : "#version 300 es\nprecision highp float;\n"
                                         "precision highp int;\nprecision highp sampler2D;\n";
    if (vulkan() && !uniforms.empty()) text += "layout(std140, binding = 0) uniform Parameters {\n";
    for (const TestUniform& u : uniforms) {
      text += fmt::format("{}{} {};\n", vulkan() ? "" : "uniform ", u.type, u.name);
    }
    if (vulkan() && !uniforms.empty()) text += "};\n";
    for (const Json& texture : job_["textures"]) {
      if (vulkan()) text += fmt::format("layout(binding = {}) ", texture["binding"].get<int>());
      text += fmt::format("uniform sampler2D {};\n", texture["name"].get<std::string>());
    }
    return text;
  }
  /// "in" or "out", with its location if the language has them between stages.
  std::string varying(const std::string& direction, int location, const std::string& what) const {
    return (vulkan() ? fmt::format("layout(location = {}) ", location) : std::string()) +
           direction + " " + what + ";\n";
  }
  /// A vertex stage that covers the image and passes `place` on: x to the right, y up, in [-1, 1].
  std::string full_screen() const {
    return header({}) + varying("out", 0, "vec2 place") +
           fmt::format(
               "void main() {{ int i = {};\n"
               "place = vec2(i == 1 ? 3.0 : -1.0, i == 2 ? 3.0 : -1.0);\n"
               "gl_Position = vec4(place.x, place.y * {:.1f}, 0.5, 1.0); }}\n",
               vulkan() ? "gl_VertexIndex" : "gl_VertexID", top());
  }
  /// A fragment stage after full_screen(): statements that set `color`.
  std::string fragment(const std::string& statements,
                       const std::vector<TestUniform>& uniforms = {}) const {
    return header(uniforms) + varying("in", 0, "vec2 place") +
           "layout(location = 0) out vec4 color;\nvoid main() {\n" + statements + "\n}\n";
  }

  /// Adds a draw that writes "<name>.bin".
  void add_draw(const std::string& name, const std::string& vertex, const std::string& fragment,
                const std::vector<TestUniform>& uniforms = {}) {
    Json draw{{"name", name}, {"output", name + ".bin"}};
    draw["vertex"] = written(name + ".vert", vertex, "vert");
    draw["fragment"] = written(name + ".frag", fragment, "frag");
    if (vulkan() && !uniforms.empty()) {
      write(name + ".block", bytes_of(std140(uniforms)));
      draw["uniform_block"] = name + ".block";
    }
    for (const TestUniform& u : uniforms) {
      if (!vulkan()) draw["uniforms"].push_back({{"name", u.name}, {"values", u.values}});
    }
    job_["draws"].push_back(draw);
  }

  /// Runs the job and returns the pixels of draw `name`.
  std::vector<Pixel> drawn(const std::string& name) {
    const ProcessResult ended = run_job(job_);
    EXPECT_THAT(ended, ExitsWith(0));
    return ended.succeeded() ? pixels(name + ".bin") : std::vector<Pixel>();
  }
  /// The pixels where `statements` set `color` over the whole image.
  std::vector<Pixel> shaded(const std::string& statements,
                            const std::vector<TestUniform>& uniforms = {}) {
    add_draw("shaded", full_screen(), fragment(statements, uniforms), uniforms);
    return drawn("shaded");
  }

  Json job_;

 private:
  std::string written(const std::string& name, const std::string& code, const std::string& stage) {
    write(name, code);
    if (!vulkan()) return name;
    compile(name, stage);
    return name + ".spv";
  }
  /// A block's bytes as floats: vec3 and vec4 begin at multiples of four, matrices have columns of
  /// four.
  static std::vector<float> std140(const std::vector<TestUniform>& uniforms) {
    std::vector<float> block;
    const auto align = [&] { block.resize((block.size() + 3) / 4 * 4); };
    for (const TestUniform& u : uniforms) {
      if (u.type != "float") align();
      const std::size_t rows = u.type == "mat3" ? 3 : u.values.size();
      for (std::size_t first = 0; first < u.values.size(); first += rows) {
        block.insert(block.end(), u.values.begin() + std::ptrdiff_t(first),
                     u.values.begin() + std::ptrdiff_t(first + rows));
        if (u.type == "mat3") align();
      }
    }
    align();
    return block;
  }
};

}  // namespace lumaknot::gpu
