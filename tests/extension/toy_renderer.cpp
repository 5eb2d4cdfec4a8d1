// A renderer in one file: it draws every pixel grey, with a program of its own.
#include "validate/renderers/entry.h"

namespace lumaknot::validate {
namespace {

constexpr ProgramInfo kToyProgram{"--toy", "toy-renderer", "toy renderer", "build it"};

class Toy final : public Renderer {
 public:
  explicit Toy(const Programs& programs) : path_(programs.path(kToyProgram)) {}

  std::string name() const override { return "Toy"; }

  Availability availability() const override {
    return {.found = true, .version = "Toy 1", .path = path_, .remedy = {}};
  }

  Rendering draw(const Scene& scene, std::span<const Shot> shots) const override {
    Rendering rendering;
    rendering.renderer = name();
    for (std::size_t i = 0; i < shots.size(); ++i) {
      RenderedShot shot;
      shot.status = RenderedShot::Status::kDrawn;
      shot.image = Image(scene.view.image.width, scene.view.image.height);
      for (RgbaPixel& pixel : shot.image.pixels) pixel = {{0.5f, 0.5f, 0.5f}, 1};
      rendering.shots.push_back(std::move(shot));
    }
    return rendering;
  }

 private:
  std::string path_;
};

std::unique_ptr<Renderer> make_toy(const Programs& programs) {
  return std::make_unique<Toy>(programs);
}

}  // namespace

extern const RendererEntry kToyEntry{.name = "Toy",
                                     .flag = "toy",
                                     .make = make_toy,
                                     .programs = {&kToyProgram},
                                     .promise = {.reason = "a test"}};

}  // namespace lumaknot::validate
