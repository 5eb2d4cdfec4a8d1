#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "shaders/languages/functions.h"
#include "system/atomic_file.h"
#include "system/process.h"
#include "tests/kernel/run.h"

namespace lumaknot::testing {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::string_view kPlace = "the kernels' folder";
constexpr const char* kScript = LUMAKNOT_SOURCE_DIR "/tests/kernel/blender.py";

/// Where scripts/install-extras puts the Python whose Blender is built with OSL.
fs::path osl_python() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base = cache && *cache ? fs::path(cache) : fs::path(home ? home : "/") / ".cache";
  return base / "lumaknot" / "osl" / "bin" / "python";
}

/// An input of a shader: its socket, and the column it reads.
struct Socket {
  std::string name;
  const KernelColumn& column;
};

std::vector<Socket> sockets_of(const Kernel& kernel, Language language) {
  std::vector<Socket> sockets;
  const auto add = [&](const std::string& name, const std::string& column) {
    const bool is_osl = language == Language::kOsl;
    sockets.push_back({is_osl ? identifier_of(name, dialect_of(Language::kOsl)) : name,
                       *kernel.rows.find(column)});
  };
  for (const ShaderFunction::Input& input : color_function(kernel.shader).inputs) {
    add(input.name, input.name.starts_with("texture") ? "texture" : input.name);
  }
  for (const ShaderParameter& p : kernel.shader.fragment.parameters) add(p.name, p.name);
  return sockets;
}

/// Writes the emitted shader and its rows, and returns its entry in the job.
Json write_shader(const fs::path& folder, const std::string& name, const Kernel& kernel,
                  Language language) {
  const bool is_osl = language == Language::kOsl;
  const std::string file = name + (is_osl ? ".osl" : ".nodes.json");
  const std::vector<Socket> sockets = sockets_of(kernel, language);
  write_file(folder / file, kernel.code, kPlace);
  std::string inputs;
  Json names = Json::array();
  for (const Socket& socket : sockets) {
    inputs += column_bytes(socket.column);
    names.push_back(
        {{"name", socket.name}, {"type", socket.column.is_vector ? "vector" : "float"}});
  }
  write_file(folder / (name + ".inputs"), inputs, kPlace);
  return {{"names", names},
          {"inputs", name + ".inputs"},
          {is_osl ? "osl" : "recipe", file},
          {"output", name + ".output"}};
}

Colors colors_in(const fs::path& file) {
  const std::string bytes = read_file(file, "blender.py");
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  Colors colors;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    colors.push_back({values[i], values[i + 1], values[i + 2]});
  }
  return colors;
}

std::vector<std::string> command(Language language) {
  if (language == Language::kOsl) return {osl_python().string(), kScript, "--", "job.json"};
  return {find_program("blender").string(),
          "-b",
          "--factory-startup",
          "--python-exit-code",
          "7",
          "--python",
          kScript,
          "--",
          "job.json"};
}

}  // namespace

std::vector<Colors> run_in_cycles(std::span<const Kernel> kernels, Language language) {
  const PrivateFolder folder;
  Json job{{"count", kKernelRows}};
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    job["shaders"].push_back(
        write_shader(folder.path(), fmt::format("kernel{}", i), kernels[i], language));
  }
  write_file(folder.path() / "job.json", job.dump(1), kPlace);
  const ProcessResult ended = run({command(language), folder.path(), {}}, std::chrono::minutes(10));
  if (!ended.succeeded()) throw std::runtime_error("Blender: " + ended.log);
  std::vector<Colors> colors;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    colors.push_back(colors_in(folder.path() / fmt::format("kernel{}.output", i)));
  }
  return colors;
}

std::string missing_for_cycles(Language language) {
  if (language == Language::kOsl) {
    const bool is_here = fs::exists(osl_python());
    return is_here ? "" : "Blender with OSL is not installed; scripts/install-extras osl";
  }
  return find_program("blender").empty() ? "blender not found; install with apt-get install blender"
                                         : "";
}

}  // namespace lumaknot::testing
