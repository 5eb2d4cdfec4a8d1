#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "exporters/povray/scene.h"
#include "system/atomic_file.h"
#include "validate/renderers/entry.h"
#include "validate/renderers/external.h"
#include "validate/renderers/povray_plan.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBanner = "Persistence of Vision(tm) Ray Tracer Version ";

std::string scene_file(std::size_t index) { return fmt::format("scene{}.pov", index + 1); }

/// The scene of an animation: its frames are the scene files. One process for all of them. POV-Ray
/// takes a single frame for no animation: its number is then 0, and its file has none.
std::string animation(std::size_t frames) {
  if (frames == 1) return fmt::format("#version 3.7;\n#include \"{}\"\n", scene_file(0));
  std::string text = "#version 3.7;\n#switch (frame_number)\n";
  for (std::size_t i = 0; i < frames; ++i) {
    text += fmt::format("  #case ({}) #include \"{}\" #break\n", i + 1, scene_file(i));
  }
  return text + "#end\n";
}

/// POV-Ray numbers frames with as many digits as the last one needs.
std::string frame_file(std::size_t index, std::size_t frames) {
  if (frames == 1) return "frame.png";
  return fmt::format("frame{:0{}}.png", index + 1, std::to_string(frames).size());
}

void write_scenes(const fs::path& folder, const Scene& scene, std::span<const Shot> shots,
                  const std::vector<std::string>& frames) {
  Package package = povray::pov_textures(scene.texture, shots, "");
  package.push_back({"mesh.inc", povray::pov_mesh(scene.mesh)});
  package.push_back({"empty.ini", "; in place of the user's\n"});
  for (std::size_t i = 0; i < frames.size(); ++i) package.push_back({scene_file(i), frames[i]});
  package.push_back({"animation.pov", animation(frames.size())});
  write_package(folder, package, "POV-Ray's folder");
}

std::vector<std::string> arguments(const std::string& program, const ImageSpec& image,
                                   std::size_t frames) {
  return {program,
          "+Ianimation.pov",
          "+Oframe.png",
          "+FN16",  // half-float EXR would round to 5e-4
          "File_Gamma=1.0",
          "+UA",
          "-A",
          "-D",
          "-V",
          "-GA",
          fmt::format("+W{}", image.width),
          fmt::format("+H{}", image.height),
          "+KFI1",
          fmt::format("+KFF{}", frames),
          fmt::format("+WT{}", std::max(1u, std::thread::hardware_concurrency()))};
}

/// What became of the frames that POV-Ray was asked for.
std::vector<RenderedShot> drawn_frames(const ProcessResult& ended, const fs::path& folder,
                                       const View& view, std::size_t frames) {
  const std::string bad = bad_end(ended);
  if (!bad.empty()) return undrawn(frames, RenderedShot::Status::kFailed, bad);
  std::vector<RenderedShot> drawn;
  drawn.reserve(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    drawn.push_back(drawn_image(folder / frame_file(i, frames), view));
  }
  return drawn;
}

/// The image of a term that was drawn with its light divided by `brightness`; black without.
Image term_image(const std::vector<RenderedShot>& frames, std::optional<std::size_t> index,
                 double brightness, const ImageSpec& size) {
  if (!index) return {size.width, size.height};
  Image image = frames[*index].image;
  for (RgbaPixel& p : image.pixels) p.color = to_rgb(to_vec(p.color) * brightness);
  return image;
}

/// A shot that POV-Ray can't draw by itself, for the reason `why`, put together from `parts`, which
/// it drew.
RenderedShot composed(const Scene& scene, const Shot& shot, const PovParts& parts,
                      const std::string& why, const std::vector<RenderedShot>& frames) {
  for (const auto index : {std::optional(parts.texture), parts.diffuse, parts.specular}) {
    if (index && frames[*index].status != RenderedShot::Status::kDrawn) return frames[*index];
  }
  RenderedShot result;
  result.status = RenderedShot::Status::kDrawn;
  result.note = why + ": composed from the texture, diffuse and specular images that it drew";
  result.output_steps = 1 + 2 * parts.brightness;
  Shot nearest = shot;
  nearest.material.normal = NormalUse::kUnit;
  if (shot.material.normal != NormalUse::kUnit) {
    result.instead = nearest;
    result.note += ", and compared with our image with unit normals";
  }
  const auto term = [&](std::optional<std::size_t> index) {
    return term_image(frames, index, parts.brightness, scene.view.image);
  };
  result.image = compose(scene, nearest, frames[parts.texture].image, term(parts.diffuse),
                         term(parts.specular));
  return result;
}

RenderedShot shown(const Scene& scene, const Shot& shot, const PovShot& planned,
                   const std::vector<RenderedShot>& frames) {
  if (planned.frame) {
    RenderedShot drawn = frames[*planned.frame];
    // Where light acts on luma, that is a texture of 16 bits of its own: taken from the colour
    // once, and added to it times the light.
    if (shot.stage == Stage::kFinal && is_linear(shot.material.space)) {
      const double light =
          scene.view.ambient + brightest_light(scene.mesh, scene.view, shot.material.space);
      drawn.output_steps += std::max(1.0, light);
    }
    return drawn;
  }
  if (planned.parts) return composed(scene, shot, *planned.parts, planned.why, frames);
  return undrawn(1, RenderedShot::Status::kSkipped, planned.why).front();
}

class PovRay final : public Renderer {
 public:
  explicit PovRay(const Programs& programs) : programs_(programs) {}

  std::string name() const override { return "POV-Ray"; }

  Availability availability() const override {
    const fs::path program = find_program(programs_.path(kPovrayProgram));
    if (program.empty()) return {.found = false, .version = {}, .path = {}, .remedy = remedy()};
    return {.found = true,
            .version = version_of(program, "--version", "POV-Ray"),
            .path = program.string(),
            .remedy = {}};
  }

  Rendering draw(const Scene& scene, std::span<const Shot> shots) const override {
    Rendering rendering;
    rendering.renderer = name();
    rendering.limited = true;  // PNG
    const fs::path program = find_program(programs_.path(kPovrayProgram));
    if (program.empty()) {
      rendering.shots = undrawn(shots.size(), RenderedShot::Status::kSkipped, remedy());
      return rendering;
    }
    try {
      draw_in_folder(program, povray::placed(scene, povray::pov_placement(scene.mesh)), shots,
                     rendering);
    } catch (const std::runtime_error& e) {
      rendering.shots = undrawn(shots.size(), RenderedShot::Status::kFailed, e.what());
    }
    return rendering;
  }

 private:
  std::string remedy() const { return not_found(programs_, kPovrayProgram); }

  void draw_in_folder(const fs::path& program, const Scene& scene, std::span<const Shot> shots,
                      Rendering& rendering) const {
    const PovPlan plan = plan_povray(scene, shots, "", "  #include \"mesh.inc\"\n");
    const PrivateFolder folder;
    std::vector<RenderedShot> frames;
    if (!plan.frames.empty()) {
      write_scenes(folder.path(), scene, shots, plan.frames);
      rendering.command = arguments(program.string(), scene.view.image, plan.frames.size());
      const ProcessResult ended =
          run({rendering.command, folder.path(), {"POVINI=empty.ini"}}, programs_.time_limit);
      tell_run(ended, rendering);
      frames = drawn_frames(ended, folder.path(), scene.view, plan.frames.size());
    }
    for (std::size_t i = 0; i < shots.size(); ++i) {
      rendering.shots.push_back(shown(scene, shots[i], plan.shots[i], frames));
    }
  }

  static void tell_run(const ProcessResult& ended, Rendering& rendering) {
    rendering.seconds = ended.seconds;
    rendering.log = ended.log;
    const std::string banner = line_with(ended.log, kBanner);
    if (banner.empty()) return;
    rendering.version = banner.substr(kBanner.size());
    rendering.version.resize(std::min(rendering.version.size(), rendering.version.find(" (")));
  }

  Programs programs_;
};

std::unique_ptr<Renderer> make_povray(const Programs& programs) {
  return std::make_unique<PovRay>(programs);
}

}  // namespace

extern const RendererEntry kPovrayEntry{
    .name = "POV-Ray",
    .flag = "povray",
    .by_default = true,
    .make = make_povray,
    .programs = {&kPovrayProgram},
    .promise = {.texture_step = kStep16,
                .output_step = kStep16,
                .reason = "a float32 mesh, double formulas and 16 bits of output; it turns normals "
                          "to the viewer and draws no highlight where n.l < 0, which has classes "
                          "of its own"}};

}  // namespace lumaknot::validate
