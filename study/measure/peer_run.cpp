#include "study/measure/peer_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "scene/json.h"
#include "system/atomic_file.h"
#include "validate/renderers/external.h"
#include "validate/renderers/gpu_job.h"
#include "validate/renderers/job_files.h"

namespace lumaknot::measure {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kPlace = "the peer's folder";
constexpr auto kTimeLimit = std::chrono::minutes(5);

struct PeerFacts {
  std::string_view name, program, remedy;
};

const PeerFacts& facts(Peer peer) {
  static constexpr PeerFacts kFacts[] = {
      {"llvmpipe", "lumaknot-gpu", "install with apt-get install libegl1 libgl1-mesa-dri"},
      {"GPU", "lumaknot-gpu", "install the GPU's driver with its libEGL"},
      {"Embree", "lumaknot-embree",
       "install with apt-get install libembree-dev libxsimd-dev and build lumaknot again"}};
  return kFacts[std::size_t(peer)];
}

/// The scene as a file of its own: all that is drawn except the mesh and the texture's image.
std::string view_json(const Scene& scene, const Shot& shot) {
  SceneSpec spec;
  spec.view = scene.view;
  spec.view.material = shot.material;
  if (const auto* color = std::get_if<Vec3d>(&scene.texture)) spec.texture = PlainColor{*color};
  return scene_to_json(spec);
}

void write_embree_job(const fs::path& folder, const Scene& scene, std::span<const Shot> shots,
                      const PeerOptions& options) {
  Json json{{"frames", 1}, {"samples", options.samples}, {"threads", options.threads}};
  json["mesh"] = validate::write_job_mesh(folder, scene.mesh);
  if (const auto* image = std::get_if<TextureImage>(&scene.texture)) {
    json["texture"] = validate::write_job_texture(folder, "texture", *image);
  }
  for (const Shot& shot : shots) {
    write_file(folder / (shot.name + ".json"), view_json(scene, shot), kPlace);
    json["draws"].push_back(
        {{"name", shot.name}, {"scene", shot.name + ".json"}, {"output", shot.name + ".bin"}});
  }
  write_file(folder / "job.json", json.dump(1), kPlace);
}

/// llvmpipe: only the caller's own thread, or this many that fill pixels.
std::vector<std::string> environment(Peer peer, int threads) {
  if (peer != Peer::kSoftwareGl || threads == 0) return {};
  return {fmt::format("LP_NUM_THREADS={}", threads == 1 ? 0 : threads)};
}

}  // namespace

std::string_view peer_name(Peer peer) { return facts(peer).name; }

std::string missing_peer(Peer peer) {
  const auto& [name, program, remedy] = facts(peer);
  const fs::path path = program_beside(std::string(program));
  if (path.empty()) return fmt::format("{} not found; {}", program, remedy);
  const PrivateFolder folder;
  std::vector<std::string> arguments{path.string(), "--version"};
  if (peer == Peer::kSoftwareGl) arguments = {path.string(), "--version-of", "gl"};
  if (peer == Peer::kHardwareGl) arguments = {path.string(), "--version-of", "gl-hardware"};
  const ProcessResult ended = run({arguments, folder.path(), {}}, std::chrono::seconds(30));
  const std::string line = ended.log.substr(0, ended.log.find('\n'));
  return ended.succeeded() ? "" : fmt::format("{}; {}", line, remedy);
}

PeerRun::PeerRun(Peer peer, const Scene& scene, std::span<const Shot> shots,
                 const PeerOptions& options)
    : size_(scene.view.image) {
  const fs::path program = program_beside(std::string(facts(peer).program));
  if (program.empty()) throw std::runtime_error(missing_peer(peer));
  command_ = {{program.string(), "job.json"}, folder_.path(), environment(peer, options.threads)};
  if (peer == Peer::kEmbree) {
    write_embree_job(folder_.path(), scene, shots, options);
    return;
  }
  const validate::GpuTiming timing{1, options.samples, options.cull_back_faces, options.trilinear,
                                   peer == Peer::kHardwareGl};
  validate::write_gpu_job(folder_.path(), scene, shots, Language::kGlsl330, {}, &timing);
}

PeerTimes PeerRun::run(int frames) const {
  const fs::path file = command_.folder / command_.arguments.back();
  Json job = Json::parse(read_file(file, kPlace));
  job["frames"] = frames;
  write_file(file, job.dump(1), kPlace);
  const ProcessResult ended = lumaknot::run(command_, kTimeLimit);
  if (const std::string bad = validate::bad_end(ended); !bad.empty()) throw std::runtime_error(bad);
  try {
    const Json json = Json::parse(validate::line_with(ended.log, "{"));
    PeerTimes times;
    times.renderer = json.at("renderer");
    times.samples = json.at("samples");
    for (const Json& draw : json.at("draws")) times.milliseconds.push_back(draw.at("ms"));
    return times;
  } catch (const Json::exception&) {
    throw std::runtime_error("reported no times: " + ended.log.substr(0, 200));
  }
}

Image PeerRun::image(const std::string& name) const {
  return validate::read_gpu_image(folder_.path() / (name + ".bin"), size_.width, size_.height);
}

}  // namespace lumaknot::measure
