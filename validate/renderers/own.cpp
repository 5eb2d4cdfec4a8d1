#include "system/version.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::validate {
namespace {

class OwnRenderer final : public Renderer {
 public:
  explicit OwnRenderer(const Grid<Fragment>& fragments) : fragments_(fragments) {}

  std::string name() const override { return "lumaknot"; }

  Availability availability() const override {
    return {.found = true, .version = std::string(version()), .path = {}, .remedy = {}};
  }

  Rendering draw(const Scene& scene, std::span<const Shot> shots) const override {
    const auto start = std::chrono::steady_clock::now();
    Rendering rendering;
    rendering.renderer = name();
    rendering.version = availability().version;
    for (const Shot& shot : shots) {
      RenderedShot drawn;
      drawn.status = RenderedShot::Status::kDrawn;
      drawn.image = shade_all(scene, shot, fragments_);
      rendering.shots.push_back(std::move(drawn));
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    rendering.seconds = elapsed.count();
    return rendering;
  }

 private:
  const Grid<Fragment>& fragments_;
};

}  // namespace

std::unique_ptr<Renderer> own_renderer(const Grid<Fragment>& fragments) {
  return std::make_unique<OwnRenderer>(fragments);
}

}  // namespace lumaknot::validate
