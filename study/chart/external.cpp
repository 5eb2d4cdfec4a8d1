#include "study/chart/external.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "scene/fields.h"
#include "shaders/languages/backend.h"
#include "study/measure/peer_run.h"
#include "system/error.h"
#include "validate/renderers/entry.h"

namespace lumaknot::chart {
namespace {

constexpr int kPeerFrames = 30;
constexpr int kCopies = 3;  // of each shot: timed frames of a renderer

std::string_view name_of(Space space) { return kSpaceNames[std::size_t(space)]; }

/// The scene with one sample per pixel, as other programs draw it.
Scene one_sample(Scene scene) {
  scene.view.image.samples = 1;
  return scene;
}

/// "768x40", "mesh".
std::string grid_name(const measure::Method& own) {
  const std::string name = measure::method_name(own);
  return name.substr(0, name.find(' '));
}

/// The emitted GLSL on Mesa's software driver, frames until glFinish.
class SoftwareGl final : public OtherProgram {
 public:
  std::string name() const override {
    return std::string(measure::peer_name(measure::Peer::kSoftwareGl));
  }

  OtherResult measure(const Scene& scene, std::span<const Space> spaces,
                      const measure::Method& own) override {
    OtherResult result;
    if (const std::string why = measure::missing_peer(measure::Peer::kSoftwareGl); !why.empty()) {
      result.missing.push_back({name(), why});
      return result;
    }
    std::vector<Shot> shots;
    for (const Space space : spaces) {
      shots.push_back({std::string(name_of(space)), Stage::kFinal,
                       measure::true_material(scene.view.material, space)});
    }
    try {
      for (const int samples : {1, 4}) {
        add_frames(one_sample(scene), shots, spaces, samples, grid_name(own), result);
      }
    } catch (const std::runtime_error& e) {
      result.missing.push_back({name(), e.what()});
    }
    return result;
  }

 private:
  void add_frames(const Scene& scene, std::span<const Shot> shots, std::span<const Space> spaces,
                  int samples, const std::string& grid, OtherResult& result) const {
    const measure::PeerRun run(measure::Peer::kSoftwareGl, scene, shots,
                               {.samples = samples, .threads = 1});
    const measure::PeerTimes times = run.run(kPeerFrames);
    for (std::size_t i = 0; i < shots.size(); ++i) {
      result.frames.push_back({fmt::format("{} {} pixel {} float trilinear {}x", name(), grid,
                                           name_of(spaces[i]), times.samples),
                               "one thread, until glFinish, image in the driver's memory",
                               spaces[i], times.samples, run.image(shots[i].name),
                               times.milliseconds.at(i)});
    }
  }
};

/// Milliseconds of Blender's own lines " Time: 00:02.98 (Saving: 00:00.15)", without the saving.
std::vector<double> blender_frames(std::string_view log) {
  std::vector<double> all;
  constexpr std::string_view kStart = "\n Time: ";
  for (std::size_t at = log.find(kStart); at != log.npos; at = log.find(kStart, at + 1)) {
    int minutes = 0, saving_minutes = 0;
    double seconds = 0, saving = 0;
    const std::string line(log.substr(at + 1, 80));
    if (std::sscanf(line.c_str(), " Time: %d:%lf (Saving: %d:%lf)", &minutes, &seconds,
                    &saving_minutes, &saving) == 4) {
      all.push_back(1000 * (60 * (minutes - saving_minutes) + seconds - saving));
    }
  }
  return all;
}

/// A renderer of validate/.
class ValidatedRenderer final : public OtherProgram {
 public:
  explicit ValidatedRenderer(std::unique_ptr<validate::Renderer> renderer)
      : renderer_(std::move(renderer)) {}

  std::string name() const override { return renderer_->name(); }

  OtherResult measure(const Scene& scene, std::span<const Space> spaces,
                      const measure::Method& own) override {
    const Scene drawn = one_sample(scene);
    const std::vector<Shot> shots = shots_of(drawn, spaces);
    const validate::Rendering rendering = renderer_->draw(drawn, shots);
    OtherResult result;
    const std::vector<double> milliseconds = blender_frames(rendering.log);
    const bool own_timer = milliseconds.size() == shots.size();
    const double rest = own_timer || !drew_all(rendering) ? 0 : time_of_first(drawn, shots);
    for (std::size_t i = 0; i < spaces.size(); ++i) {
      const validate::RenderedShot& first = rendering.shots[i * kCopies];
      const std::string name =
          fmt::format("{} {} pixel {} 1x", this->name(), grid_name(own), name_of(spaces[i]));
      if (first.status != validate::RenderedShot::Status::kDrawn) {
        result.missing.push_back({name, first.why});
        continue;
      }
      OtherFrame frame{name, {}, spaces[i], 1, first.image, {}};
      if (own_timer) {
        frame.how = "the renderer's own timer, all cores, image not saved";
        frame.milliseconds.assign(milliseconds.begin() + std::ptrdiff_t(i * kCopies),
                                  milliseconds.begin() + std::ptrdiff_t((i + 1) * kCopies));
      } else {
        frame.how =
            fmt::format("what each of {} frames adds to its process, all cores, scene read again",
                        shots.size());
        frame.milliseconds = {1000 * (rendering.seconds - rest) / double(shots.size() - 1)};
      }
      if (!first.note.empty()) frame.how += "; " + first.note;
      result.frames.push_back(std::move(frame));
    }
    return result;
  }

 private:
  static std::vector<Shot> shots_of(const Scene& scene, std::span<const Space> spaces) {
    std::vector<Shot> shots;
    for (const Space space : spaces) {
      for (int copy = 0; copy < kCopies; ++copy) {
        shots.push_back({fmt::format("{}-{}", name_of(space), copy), Stage::kFinal,
                         measure::true_material(scene.view.material, space)});
      }
    }
    return shots;
  }

  static bool drew_all(const validate::Rendering& rendering) {
    return std::ranges::all_of(rendering.shots, [](const validate::RenderedShot& drawn) {
      return drawn.status == validate::RenderedShot::Status::kDrawn;
    });
  }

  /// Seconds of a process that draws one frame.
  double time_of_first(const Scene& scene, std::span<const Shot> shots) const {
    return renderer_->draw(scene, shots.first(1)).seconds;
  }

  std::unique_ptr<validate::Renderer> renderer_;
};

}  // namespace

std::vector<std::unique_ptr<OtherProgram>> other_programs() {
  std::vector<std::unique_ptr<OtherProgram>> all;
  all.push_back(std::make_unique<SoftwareGl>());
  for (const char* name : {"Cycles", "POV-Ray", "Eevee"}) {
    all.push_back(std::make_unique<ValidatedRenderer>(validate::renderer_entry(name).make({})));
  }
  return all;
}

}  // namespace lumaknot::chart
