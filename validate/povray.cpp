#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "exporters/pov.h"
#include "scene/atomic_file.h"
#include "validate/external.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBanner = "Persistence of Vision(tm) Ray Tracer Version ";

/// The scene of an animation: frame n draws shot n. One process for all shots.
std::string animation(std::span<const Shot> shots) {
  std::string text = "#version 3.7;\n#switch (frame_number)\n";
  for (std::size_t i = 0; i < shots.size(); ++i) {
    text += fmt::format("  #case ({}) #include \"{}.pov\" #break\n", i + 1, shots[i].name);
  }
  return text + "#end\n";
}

/// POV-Ray numbers frames with as many digits as the last one needs.
std::string frame_file(std::size_t index, std::size_t frames) {
  return fmt::format("frame{:0{}}.png", index + 1, std::to_string(frames).size());
}

void write_scene(const fs::path& folder, const Scene& scene, std::span<const Shot> shots) {
  const PovNames names{"texture.png", "luma.png"};
  Package package = pov_textures(scene, names);
  package.push_back({"mesh.inc", pov_mesh(scene.mesh)});
  package.push_back({"empty.ini", "; in place of the user's\n"});
  for (const Shot& shot : shots) {
    package.push_back(
        {shot.name + ".pov", pov_scene(scene, shot, names, "  #include \"mesh.inc\"\n")});
  }
  package.push_back({"animation.pov", animation(shots)});
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

/// The index of the drawn shot of `stage` with the shininess of `final`, or nothing.
std::optional<std::size_t> find_stage(std::span<const Shot> shots, const std::vector<Drawn>& drawn,
                                      Stage stage, const Shot& final) {
  for (std::size_t i = 0; i < shots.size(); ++i) {
    if (shots[i].stage == stage && drawn[i].status == Drawn::Status::kDrawn &&
        shots[i].material.shininess == final.material.shininess) {
      return i;
    }
  }
  return std::nullopt;
}

/// A shot that POV-Ray can't draw by itself, put together from the terms that it drew.
Drawn composed(const Scene& scene, const Shot& shot, std::span<const Shot> shots,
               const std::vector<Drawn>& drawn) {
  const auto texture = find_stage(shots, drawn, Stage::kTexture, shot);
  const auto diffuse = find_stage(shots, drawn, Stage::kDiffuse, shot);
  const auto specular = find_stage(shots, drawn, Stage::kSpecular, shot);
  if (!texture || !diffuse || !specular) {
    return undrawn(1, Drawn::Status::kSkipped,
                   *pov_shortfall(shot) + ", and its terms were not drawn apart")
        .front();
  }
  Drawn result;
  result.status = Drawn::Status::kDrawn;
  result.instead = shot;
  result.instead->material.normal = NormalUse::kUnit;
  result.note = *pov_shortfall(shot) +
                ": composed from the texture, diffuse and specular images that it drew, and "
                "compared with our image with unit normals";
  result.image = compose(scene, *result.instead, drawn[*texture].image, drawn[*diffuse].image,
                         drawn[*specular].image);
  return result;
}

class PovRay final : public Renderer {
 public:
  explicit PovRay(const Programs& programs) : programs_(programs) {}

  std::string name() const override { return "POV-Ray"; }

  Availability availability() const override {
    const fs::path program = find_program(programs_.povray);
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
    const fs::path program = find_program(programs_.povray);
    if (program.empty()) {
      rendering.shots = undrawn(shots.size(), Drawn::Status::kSkipped, remedy());
      return rendering;
    }
    try {
      draw_in_folder(program, scene, shots, rendering);
    } catch (const std::runtime_error& e) {
      rendering.shots = undrawn(shots.size(), Drawn::Status::kFailed, e.what());
    }
    return rendering;
  }

 private:
  std::string remedy() const {
    return fmt::format("{} is not here; apt-get install povray", programs_.povray);
  }

  void draw_in_folder(const fs::path& program, const Scene& scene, std::span<const Shot> shots,
                      Rendering& rendering) const {
    std::vector<Shot> native;
    std::ranges::copy_if(shots, std::back_inserter(native),
                         [](const Shot& s) { return !pov_shortfall(s); });
    const PrivateFolder folder;
    write_scene(folder.path(), scene, native);
    rendering.command = arguments(program.string(), scene.view.image, native.size());
    const Ended ended =
        run({rendering.command, folder.path(), {"POVINI=empty.ini"}}, programs_.time_limit);
    rendering.seconds = ended.seconds;
    rendering.log = ended.log;
    const std::string banner = line_with(ended.log, kBanner);
    if (!banner.empty()) {
      rendering.version = banner.substr(kBanner.size());
      rendering.version.resize(std::min(rendering.version.size(), rendering.version.find(" (")));
    }
    const std::string bad = bad_end(ended);
    std::size_t frame = 0;
    for (const Shot& shot : shots) {
      if (pov_shortfall(shot)) {
        rendering.shots.emplace_back();
      } else if (!bad.empty()) {
        rendering.shots.push_back(undrawn(1, Drawn::Status::kFailed, bad).front());
      } else {
        rendering.shots.push_back(
            drawn_image(folder.path() / frame_file(frame++, native.size()), scene.view));
      }
    }
    for (std::size_t i = 0; i < shots.size(); ++i) {
      if (pov_shortfall(shots[i])) {
        rendering.shots[i] = composed(scene, shots[i], shots, rendering.shots);
      }
    }
  }

  Programs programs_;
};

}  // namespace

std::unique_ptr<Renderer> povray_renderer(const Programs& programs) {
  return std::make_unique<PovRay>(programs);
}

}  // namespace lumaknot
