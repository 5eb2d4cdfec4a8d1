// FLIP compared with its authors' own program.
#include "validate/compare/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "system/atomic_file.h"
#include "system/process.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;

void write_floats(const fs::path& path, const Image& image) {
  std::string bytes;
  for (const RgbaPixel& p : image.pixels) {
    const float rgb[] = {p.color.r, p.color.g, p.color.b};
    bytes.append(reinterpret_cast<const char*>(rgb), sizeof rgb);
  }
  write_file(path, bytes, "the test's folder");
}

/// The folder of scripts/install-peers; other programs don't see the variables that tell it.
std::string peers_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (!variable("LUMAKNOT_PEERS").empty()) return variable("LUMAKNOT_PEERS");
  const fs::path cache = variable("XDG_CACHE_HOME");
  return (cache.empty() ? variable("HOME") / ".cache" : cache) / "lumaknot/peers";
}

Grid<float> their_errors(const Image& reference, const Image& test) {
  const PrivateFolder folder;
  write_floats(folder.path() / "reference.bin", reference);
  write_floats(folder.path() / "test.bin", test);
  const fs::path script = fs::path(LUMAKNOT_SOURCE_DIR) / "tests/validate/peers/flip.py";
  const ProcessResult ended =
      run({{"/usr/bin/python3", script.string(), std::to_string(test.width),
            std::to_string(test.height), "reference.bin", "test.bin", "errors.bin"},
           folder.path(),
           {"LUMAKNOT_PEERS=" + peers_folder()}},
          std::chrono::seconds(60));
  if (!ended.succeeded()) throw std::runtime_error(ended.log);
  EXPECT_NEAR(std::stod(ended.log), kFlipPixelsPerDegree, 1e-5);  // float
  const std::string bytes = read_file(folder.path() / "errors.bin", "their errors");
  Grid<float> errors(test.width, test.height);
  EXPECT_EQ(bytes.size(), errors.pixels.size() * sizeof(float));
  std::memcpy(errors.pixels.data(), bytes.data(), bytes.size());
  return errors;
}

/// Theirs computes in float; it multiplies unfactored kernels and has the white point in seven
/// digits, which the exponent 0.7 lets grow where images hardly differ.
constexpr double kPixel = 2e-4, kMean = 2e-5;

void expect_same(const Image& reference, const Image& test) {
  const Grid<float> theirs = their_errors(reference, test);
  const Grid<float> ours = flip_errors(flip_image(reference), flip_image(test));
  double mean = 0, largest = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    const double d = double(ours.pixels[i]) - double(theirs.pixels[i]);
    mean += d / double(ours.pixels.size());
    largest = std::max(largest, std::abs(d));
  }
  EXPECT_LE(largest, kPixel);
  EXPECT_LE(std::abs(mean), kMean);
}

/// Blocks of random colours, so that there are edges, points and plains.
Image blocks(unsigned seed, int side) {
  std::mt19937 random(seed);
  const auto next = [&] { return float(random()) / float(std::mt19937::max()); };
  Image image(97, 61);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      RgbaPixel& p = image.at(x, y);
      p = {{next(), next(), next()}, 1};
      if (x % side > 0) p = image.at(x - x % side, y);
      if (y % side > 0) p = image.at(x, y - y % side);
    }
  }
  return image;
}

TEST(FlipPeer, random_blocks_have_the_package_s_errors) {
  for (const int side : {1, 5, 20}) expect_same(blocks(1, side), blocks(2, side));
}

TEST(FlipPeer, a_coarse_knot_has_the_package_s_errors) {
  SceneSpec spec = *builtin_scene("figure2");
  spec.view.image = {200, 160, 1};
  auto knot = std::get<KnotSpec>(spec.mesh);
  const auto drawn = [&](int segments, int sides) {
    knot.segments = segments, knot.sides = sides;
    Image image = render(Scene{knot_mesh(knot), bricks(), spec.view});
    for (RgbaPixel& p : image.pixels) {
      for (float* c : {&p.color.r, &p.color.g, &p.color.b}) *c = std::clamp(*c, 0.0f, 1.0f);
    }
    return image;
  };
  expect_same(drawn(384, 20), drawn(48, 6));
}

}  // namespace
}  // namespace lumaknot::validate
