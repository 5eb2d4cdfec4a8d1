// The brightest light that a scene may have, in each space and model.
#include <gtest/gtest.h>

#include "render/reference.h"
#include "scene/fields.h"
#include "tests/render/fast/testing.h"

namespace lumaknot {
namespace {

using testing::fast_image;
using testing::knot_scene;

int count_not_finite(const Image& image) {
  return int(std::ranges::count_if(image.pixels, [](const RgbaPixel& p) {
    return !(std::isfinite(p.color.r) && std::isfinite(p.color.g) && std::isfinite(p.color.b));
  }));
}

TEST(BrightestLight, stays_finite_in_float_images_in_every_space_and_model) {
  for (std::size_t space = 0; space < kSpaceNames.size(); ++space) {
    for (std::size_t model = 0; model < kModelNames.size(); ++model) {
      Scene scene = knot_scene(40, 60, 8);
      scene.view.material.model = Model(model);
      scene.view.material.space = Space(space);
      scene.view.lights = {PointLight{}};
      std::get<PointLight>(scene.view.lights[0]).color.intensity = kBrightest;
      scene.view.ambient = scene.view.material.diffuse = scene.view.material.specular = kBrightest;
      EXPECT_EQ(count_not_finite(render(scene)), 0) << kSpaceNames[space] << kModelNames[model];
      EXPECT_EQ(count_not_finite(fast_image(scene)), 0) << kSpaceNames[space] << kModelNames[model];
    }
  }
}

}  // namespace
}  // namespace lumaknot
