#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "system/atomic_file.h"
#include "system/process.h"
#include "tests/kernel/run.h"
#include "validate/renderers/gpu_job.h"
#include "validate/renderers/spirv.h"

namespace lumaknot::testing {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::string_view kPlace = "the kernels' folder";

/// All kernels of a job share one texture: a kernel's rows begin at line `first` in it.
std::string reading_from(const std::string& fragment, std::size_t first) {
  static const std::regex kLine(R"(\(index, (\d+))");
  std::string text;
  auto rest = fragment.cbegin();
  for (std::smatch m; std::regex_search(rest, fragment.cend(), m, kLine); rest = m[0].second) {
    text += m.prefix().str() + fmt::format("(index, {}", first + std::stoul(m[1].str()));
  }
  return text + std::string(rest, fragment.cend());
}

/// Writes a stage in the form that the API accepts and returns its draw's entries.
void add_stage(Json& draw, const fs::path& folder, const std::string& file, const std::string& text,
               Language language, bool is_fragment) {
  const bool is_hlsl = language == Language::kHlsl;
  const std::string stage = is_fragment ? "fragment" : "vertex";
  const std::string entry = is_hlsl ? stage + "_main" : "main";
  if (!fs::exists(folder / file)) {
    const bool is_source = backend_of(language).api != "vulkan";
    write_file(folder / file,
               is_source ? text : validate::compile_spirv({}, text, {is_hlsl, is_fragment, entry}),
               kPlace);
  }
  draw[stage] = file;
  draw[stage + "_entry"] = entry;
}

Colors colors_in(const fs::path& file) {
  const Image image = validate::read_gpu_image(file, kKernelSide, kKernelSide);
  Colors colors;
  for (const RgbaPixel& p : image.pixels) colors.push_back({p.color.r, p.color.g, p.color.b});
  return colors;
}

}  // namespace

std::vector<Colors> run_on_gpu(std::span<const Kernel> kernels, Language language) {
  const PrivateFolder folder;
  Json job{{"api", backend_of(language).api}, {"width", kKernelSide}, {"height", kKernelSide}};
  std::string inputs;
  std::size_t lines = 0;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    Json draw{{"output", fmt::format("{}.bin", i)}};
    // One vertex stage serves all.
    add_stage(draw, folder.path(), "vertex", emit_kernel(kernels[i].shader, language).vertex,
              language, false);
    add_stage(draw, folder.path(), fmt::format("{}.fragment", i),
              reading_from(kernels[i].code, lines), language, true);
    job["draws"].push_back(std::move(draw));
    for (const KernelColumn& column : kernels[i].rows.columns()) inputs += column_bytes(column);
    lines += kernels[i].rows.columns().size();
  }
  job["textures"] = {{{"name", "inputs"},
                      {"binding", 1},
                      {"file", "inputs.bin"},
                      {"width", kKernelRows},
                      {"height", lines},
                      {"filter", "nearest"}}};
  write_file(folder.path() / "inputs.bin", inputs, kPlace);
  write_file(folder.path() / "job.json", job.dump(1), kPlace);
  const ProcessResult ended =
      run({{LUMAKNOT_GPU, "job.json"}, folder.path(), {}}, std::chrono::minutes(5));
  if (!ended.succeeded()) throw std::runtime_error("lumaknot-gpu: " + ended.log);
  std::vector<Colors> colors;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    colors.push_back(colors_in(folder.path() / fmt::format("{}.bin", i)));
  }
  return colors;
}

std::string missing_for_gpu(Language language) {
  if (backend_of(language).api == "vulkan" &&
      find_program(validate::Programs{}.path(validate::kGlslangProgram)).empty()) {
    return "glslangValidator not found; install with apt-get install glslang-tools";
  }
  const PrivateFolder folder;
  const ProcessResult ended = run(
      {{LUMAKNOT_GPU, "--version-of", std::string(backend_of(language).api)}, folder.path(), {}},
      std::chrono::seconds(60));
  return ended.succeeded() ? ""
                           : ended.log +
                                 "; apt-get install libegl1 libgl1-mesa-dri "
                                 "mesa-vulkan-drivers";
}

}  // namespace lumaknot::testing
