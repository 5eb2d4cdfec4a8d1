// What the bench's peers draw is the picture whose frames are timed.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "study/bench/frame_rates.h"
#include "study/measure/peer_run.h"

namespace lumaknot {
namespace {

Scene figure2() {
  const SceneSpec spec = *builtin_scene("figure2");
  return {knot_mesh(std::get<KnotSpec>(spec.mesh)), bricks(), spec.view};
}

/// How far two images are apart, the reference's colours limited as bytes are.
struct Distance {
  int coverage = 0;  ///< pixels covered in one alone
  int beyond = 0;    ///< other pixels farther than the limit in a channel
  double mean = 0;   ///< over all channels
};

Distance distance(const Image& drawn, const Image& reference, double limit) {
  Distance d;
  for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
    const RgbaPixel &a = drawn.pixels[i], &b = reference.pixels[i];
    const Vec3d from = to_vec(a.color), to = to_vec(b.color);
    const auto apart = [](double x, double y) { return std::abs(x - std::clamp(y, 0.0, 1.0)); };
    const double sides[] = {apart(from.x, to.x), apart(from.y, to.y), apart(from.z, to.z)};
    d.mean += (sides[0] + sides[1] + sides[2]) / 3 / double(drawn.pixels.size());
    if (a.coverage != b.coverage) {
      ++d.coverage;
    } else if (std::ranges::max(sides) > limit) {
      ++d.beyond;
    }
  }
  return d;
}

struct Promise {
  measure::Peer peer;
  int coverage;  ///< pixels
  double limit;
  int beyond;  ///< pixels
};

// A byte rounds by half a step. llvmpipe snaps vertices to 1/256 pixel and blends texels of 8 bits
// with weights of 8 bits. Embree's rays are floats: a few slip between triangles at silhouettes.
constexpr Promise kPromises[] = {{measure::Peer::kSoftwareGl, 8, 2.0 / 255, 0},
                                 {measure::Peer::kEmbree, 3, 1.0 / 255, 8}};

class Peers : public ::testing::TestWithParam<Promise> {
 protected:
  void SetUp() override {
    if (const std::string why = measure::missing_peer(GetParam().peer); !why.empty()) FAIL() << why;
  }
};

TEST_P(Peers, frame_of_each_shot_is_the_reference) {
  const Scene scene = figure2();
  const std::vector<Shot> shots = bench::rate_shots(scene);
  const measure::PeerRun run(GetParam().peer, scene, shots, {.trilinear = false});
  const measure::PeerTimes times = run.run(2);
  ASSERT_EQ(times.milliseconds.size(), shots.size());
  const Grid<Fragment> fragments = visible_fragments(scene);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    EXPECT_EQ(times.milliseconds[i].size(), 2u);
    const Image reference = shade_all(scene, shots[i], fragments);
    const Distance d = distance(run.image(shots[i].name), reference, GetParam().limit);
    EXPECT_LE(d.coverage, GetParam().coverage) << shots[i].name;
    EXPECT_LE(d.beyond, GetParam().beyond) << shots[i].name;
  }
}

TEST_P(Peers, several_samples_are_nearer_to_the_filtered_picture) {
  Scene scene = figure2();
  scene.view.image = {180, 180, 1};
  const std::vector<Shot> shots = bench::rate_shots(scene);
  Scene filtered = scene;
  filtered.view.material = shots[0].material;
  filtered.view.image.samples = 8;
  const Image reference = render(filtered);
  const auto mean = [&](int samples) {
    const measure::PeerRun run(GetParam().peer, scene, shots, {.samples = samples, .threads = 1});
    EXPECT_GT(run.run(1).samples, samples / 4);
    return distance(run.image(shots[0].name), reference, 0).mean;
  };
  EXPECT_LT(mean(8), mean(1));
}

TEST_P(Peers, samples_that_there_are_not_are_refused_by_their_name) {
  Scene scene = figure2();
  scene.view.image = {32, 32, 1};
  const std::vector<Shot> shots = bench::rate_shots(scene);
  for (const int samples : {0, 17}) {
    const measure::PeerRun run(GetParam().peer, scene, shots, {.samples = samples});
    EXPECT_THAT([&] { run.run(1); },
                ::testing::ThrowsMessage<std::runtime_error>(
                    ::testing::HasSubstr("samples must be an integer from 1")));
  }
}

INSTANTIATE_TEST_SUITE_P(Peers, Peers, ::testing::ValuesIn(kPromises), [](const auto& promise) {
  return std::string(measure::peer_name(promise.param.peer));
});

TEST(SoftwareGl, back_faces_of_a_closed_mesh_are_never_seen) {
  if (const std::string why = measure::missing_peer(measure::Peer::kSoftwareGl); !why.empty())
    FAIL() << why;
  const Scene scene = figure2();
  const std::vector<Shot> shots = bench::rate_shots(scene);
  const measure::PeerRun all(measure::Peer::kSoftwareGl, scene, shots, {});
  const measure::PeerRun culled(measure::Peer::kSoftwareGl, scene, shots,
                                {.cull_back_faces = true});
  all.run(1);
  culled.run(1);
  const Distance d = distance(culled.image("classical"), all.image("classical"), 1.0 / 255);
  EXPECT_LE(d.coverage + d.beyond, 8);  // at silhouettes a back face may cover a pixel's centre
}

}  // namespace
}  // namespace lumaknot
