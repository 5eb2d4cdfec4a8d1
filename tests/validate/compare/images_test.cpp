#include "validate/compare/images.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/validate/small_scene.h"

namespace lumaknot::validate {
namespace {

using testing::final_shot;
using testing::small_scene;

/// An error of a thousandth is an outlier; edges pass within a thousandth of a pixel.
const Standard kThousandth{.promise = {.grid_bits = 10}, .limits = {.max = 1e-3}};

/// A scene with its fragments, for pictures that differ deliberately.
struct Bench {
  Scene scene;
  Grid<Fragment> fragments = visible_fragments(scene);
  Reference reference{scene, fragments};

  Comparison compare_with(const Shot& shot, const Image& theirs, bool limited = false) const {
    Standard standard = kThousandth;
    standard.limited = limited;
    return compare(reference, shot, shade_all(scene, shot, fragments), theirs, {}, standard);
  }
  long long count(const Comparison& c, PixelClass k) const { return c.classes[std::size_t(k)]; }

  /// The picture of a renderer that sees each fragment changed by `change`.
  template <class F>
  Image changed(const Shot& shot, F change) const {
    Grid<Fragment> copy = fragments;
    for (Fragment& f : copy.pixels) {
      if (f.covered()) change(f);
    }
    return shade_all(scene, shot, copy);
  }
};

TEST(Compare, our_own_picture_agrees_exactly) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("yiq-eq6");
  const Comparison c = bench.compare_with(shot, shade_all(bench.scene, shot, bench.fragments));
  EXPECT_GT(c.covered, 1000);
  EXPECT_GT(c.inside, c.covered / 2);
  EXPECT_EQ(c.coverage_differs, 0);
  EXPECT_EQ(c.max, 0);
  EXPECT_EQ(c.outliers, 0);
  EXPECT_EQ(c.outcome(), Outcome::kAgreed);
}

TEST(Compare, counts_every_pixel_covered_in_one_picture_only) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("phong");
  Image theirs = shade_all(bench.scene, shot, bench.fragments);
  const auto covered = std::ranges::find(theirs.pixels, 1.0f, &RgbaPixel::coverage);
  covered->coverage = 0;
  theirs.at(0, 0).coverage = 1;
  const Comparison c = bench.compare_with(shot, theirs);
  EXPECT_EQ(c.coverage_differs, 2);
  EXPECT_EQ(c.coverage_unexplained, 2) << "no edge passes within a thousandth of a pixel";
}

TEST(Compare, a_constant_error_is_mean_and_quantile_and_maximum) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("phong");
  Image theirs = shade_all(bench.scene, shot, bench.fragments);
  for (RgbaPixel& p : theirs.pixels) p.color.g += 0.25f;
  const Comparison c = bench.compare_with(shot, theirs);
  for (const double value : {c.mean, c.rmse, c.p99, c.p999, c.p9999, c.max}) {
    EXPECT_NEAR(value, 0.25, 1e-6);  // float32 colours
  }
}

TEST(Compare, finds_the_place_of_the_largest_error) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("phong");
  Image theirs = shade_all(bench.scene, shot, bench.fragments);
  std::size_t inside = 0;
  while (!bench.fragments.pixels[inside].covered() || bench.reference.silhouettes.pixels[inside]) {
    ++inside;
  }
  theirs.pixels[inside].color.b += 0.75f;
  const Comparison c = bench.compare_with(shot, theirs);
  EXPECT_NEAR(c.max, 0.75, 1e-6);
  EXPECT_EQ(std::size_t(c.max_at.y * theirs.width + c.max_at.x), inside);
  EXPECT_EQ(bench.count(c, PixelClass::kUnexplained), 1);
  ASSERT_EQ(c.unexplained.size(), 1u);
  EXPECT_EQ(c.outcome(), Outcome::kDiffered) << "one unexplained pixel is enough";
}

TEST(Compare, limits_ours_only_when_theirs_is_limited) {
  const Bench bench{small_scene()};
  Shot shot = final_shot("phong");
  shot.material.specular = 5;
  Image theirs = shade_all(bench.scene, shot, bench.fragments);
  for (RgbaPixel& p : theirs.pixels) {
    p.color = {std::min(p.color.r, 1.0f), std::min(p.color.g, 1.0f), std::min(p.color.b, 1.0f)};
  }
  EXPECT_EQ(bench.compare_with(shot, theirs, true).max, 0);
  EXPECT_GT(bench.compare_with(shot, theirs, false).max, 1);
}

TEST(Compare, judges_colours_alone_of_a_picture_without_coverage) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("phong");
  Image theirs = shade_all(bench.scene, shot, bench.fragments);
  for (RgbaPixel& p : theirs.pixels) p.coverage = 0;
  const Comparison c = bench.compare_with(shot, theirs);
  EXPECT_TRUE(c.has_no_coverage);
  EXPECT_EQ(c.coverage_unexplained, c.covered);
  EXPECT_EQ(c.max, 0);
  EXPECT_EQ(c.outcome(), Outcome::kAgreed) << "coverage is a rung of its own";
}

TEST(Compare, gives_up_the_search_where_a_picture_differs_everywhere) {
  const Bench bench{small_scene(128)};
  const Shot shot = final_shot("phong");
  Image theirs = shade_all(bench.scene, shot, bench.fragments);
  for (RgbaPixel& p : theirs.pixels) p.color = {p.color.b, p.color.r, p.color.g + 0.5f};
  const Comparison c = bench.compare_with(shot, theirs);
  EXPECT_EQ(c.outliers, c.covered);
  EXPECT_GT(c.unsearched, c.covered / 2);
  EXPECT_EQ(bench.count(c, PixelClass::kUnexplained), c.covered);
  EXPECT_EQ(c.outcome(), Outcome::kDiffered);
}

TEST(Compare, of_more_known_differences_than_are_allowed_is_explained) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("phong");
  Bench bent = bench;
  for (Fragment& f : bent.fragments.pixels) f.normal = -f.normal;
  const Image theirs = shade_all(bench.scene, shot, bench.fragments);
  const Image ours = shade_all(bent.scene, shot, bent.fragments);
  const Reference reference(bent.scene, bent.fragments);
  const auto judged = [&](const Allowances& allowances) {
    Standard standard = kThousandth;
    standard.allowances = allowances;
    return compare(reference, shot, ours, theirs, {}, standard);
  };
  const Comparison usual = judged({});
  EXPECT_EQ(usual.outcome(), Outcome::kExplained);
  const auto turned = std::size_t(PixelClass::kTurnedNormal);
  ASSERT_EQ(usual.shares.front().allowance, turned);
  EXPECT_GT(usual.shares.front().share(), 0.5);
  EXPECT_GT(usual.mean, 0.01) << "the error of all pixels is not that of the judged ones";
  EXPECT_EQ(usual.mean_unclassed, 0);
  Allowances generous;
  generous.stated[turned] = 1;
  EXPECT_EQ(judged(generous).outcome(), Outcome::kAgreed);
  generous.stated[turned] = 0.5;
  EXPECT_EQ(judged(generous).outcome(), Outcome::kExplained);
}

TEST(Explain, names_a_normal_turned_to_the_viewer) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("phong");
  // Turned normals are rare; bend all of them away, so that a renderer that turns them is noticed.
  Bench bent = bench;
  for (Fragment& f : bent.fragments.pixels) f.normal = -f.normal;
  const Image theirs = shade_all(bench.scene, shot, bench.fragments);
  const Image ours = shade_all(bent.scene, shot, bent.fragments);
  const Reference reference(bent.scene, bent.fragments);
  const Comparison c = compare(reference, shot, ours, theirs, {}, kThousandth);
  EXPECT_GT(c.outliers, 1000);
  EXPECT_GT(c.classes[std::size_t(PixelClass::kTurnedNormal)], c.outliers * 9 / 10);
}

TEST(Explain, names_a_highlight_that_is_gated_behind_the_light) {
  Scene scene = small_scene();
  scene.view.lights = {PointLight{.position = {0.5, 5, 0}, .color = {}, .falloff = {}}};
  const Bench bench{scene};
  Shot shot = final_shot("phong");
  shot.material.parameters["shininess"] = 2;
  Image theirs = shade_all(bench.scene, shot, bench.fragments);
  Shot without = shot;
  without.material.specular = 0;
  for (std::size_t i = 0; i < theirs.pixels.size(); ++i) {
    const Fragment& f = bench.fragments.pixels[i];
    if (dot(f.normal, Vec3d{0.5, 5, 0} - f.position) <= 0) {
      theirs.pixels[i].color = to_rgb(shade(scene, without, f));
    }
  }
  const Comparison c = bench.compare_with(shot, theirs);
  EXPECT_GT(bench.count(c, PixelClass::kGatedHighlight), 100);
  EXPECT_EQ(bench.count(c, PixelClass::kUnexplained), 0);
}

TEST(Explain, names_texture_coordinates_off_by_less_than_a_hundredth_of_a_texel) {
  const Bench bench{small_scene()};
  const Shot shot{"texture", Stage::kTexture, {}};
  const auto shift = [&](double texels) {
    return bench.changed(shot, [&](Fragment& f) { f.uv.u += texels / 512; });
  };
  const Comparison near = bench.compare_with(shot, shift(0.008));
  EXPECT_GT(near.outliers, 0);
  EXPECT_EQ(near.outliers, bench.count(near, PixelClass::kTexelEdge));
  const Comparison far = bench.compare_with(shot, shift(0.5));
  EXPECT_GT(bench.count(far, PixelClass::kUnexplained), 100) << "half a texel is a defect";
}

TEST(Explain, does_not_explain_inward_winding_or_a_wrong_light) {
  const Bench bench{small_scene()};
  const Shot shot = final_shot("phong");
  Scene wrong = bench.scene;
  std::get<PointLight>(wrong.view.lights[0]).position.x += 0.05;
  const Comparison c = bench.compare_with(shot, shade_all(wrong, shot, bench.fragments));
  EXPECT_GT(bench.count(c, PixelClass::kUnexplained), 100);
  EXPECT_EQ(c.outcome(), Outcome::kDiffered);
}

TEST(Explain, names_a_sample_that_an_edge_of_the_surface_passes_by) {
  // Theirs is drawn from a slightly shifted eye: the edges move by about a thousandth of a pixel.
  const Bench bench{small_scene(256)};
  Scene aside = bench.scene;
  aside.view.camera.position.x += 4e-5;
  aside.view.camera.target.x += 4e-5;
  const Shot shot{"diffuse", Stage::kDiffuse, {}};
  const Image theirs = shade_all(aside, shot, visible_fragments(aside));
  const Comparison c = bench.compare_with(shot, theirs);
  EXPECT_GT(c.coverage_differs, 0);
  Standard wide = kThousandth;
  wide.promise.grid_bits = 6;
  const Image ours = shade_all(bench.scene, shot, bench.fragments);
  EXPECT_EQ(compare(bench.reference, shot, ours, theirs, {}, wide).coverage_unexplained, 0);
}

TEST(Explain, names_a_ray_that_slipped_between_two_triangles) {
  // Two sheets, each of two triangles whose common edge runs through pixel centres.
  TriangleMesh mesh;
  for (const double y : {0.0, 1.0}) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const auto& [x, z] : {Vec2d{-1, -1}, Vec2d{1, -1}, Vec2d{1, 1}, Vec2d{-1, 1}}) {
      mesh.positions.push_back({x, y, z});
      mesh.normals.push_back({0, -1, 0});
      mesh.uvs.push_back({0, 0});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  Scene scene{mesh, Vec3d{0.5, 0.5, 0.5}, {}};
  scene.view.camera = {{0, -4, 0}, {0, 0, 0}, {0, 0, 1}, 45};
  scene.view.lights = {PointLight{.position = {0, -3, 0.5}, .color = {}, .falloff = {}}};
  scene.view.image = {64, 64, 1};
  const Bench bench{scene};
  const Shot shot{"diffuse", Stage::kDiffuse, {}};
  Image theirs = shade_all(scene, shot, bench.fragments);
  const auto slip = [&](int x, int y) {
    const Fragment behind = bench.reference.probe.at(x + 0.5, y + 0.5, 4.5);
    theirs.at(x, y).color = to_rgb(shade(scene, shot, behind));
  };
  slip(40, 23);  // on the diagonal
  const Comparison on_edge = bench.compare_with(shot, theirs);
  EXPECT_EQ(on_edge.outliers, 1);
  EXPECT_EQ(bench.count(on_edge, PixelClass::kSlippedRay), 1);
  slip(40, 30);  // no ray may slip inside a triangle
  EXPECT_EQ(bench.count(bench.compare_with(shot, theirs), PixelClass::kUnexplained), 1);
}

TEST(Silhouettes, lie_where_the_surface_ends_or_passes_before_itself) {
  const Bench bench{small_scene(256)};
  const Grid<char>& marks = bench.reference.silhouettes;
  long long marked = 0, covered = 0, inner = 0;
  for (int y = 1; y + 1 < marks.height; ++y) {
    for (int x = 1; x + 1 < marks.width; ++x) {
      if (!bench.fragments.at(x, y).covered()) {
        EXPECT_FALSE(marks.at(x, y));
        continue;
      }
      ++covered;
      marked += marks.at(x, y) != 0;
      bool beside_nothing = false;
      for (int k = 0; k < 9; ++k) {
        beside_nothing |= !bench.fragments.at(x + k % 3 - 1, y + k / 3 - 1).covered();
      }
      EXPECT_TRUE(marks.at(x, y) || !beside_nothing);
      inner += marks.at(x, y) && !beside_nothing;
    }
  }
  EXPECT_GT(inner, 50) << "the knot passes before itself";
  EXPECT_LT(marked, covered / 3) << "most of the surface is inside";
}

}  // namespace
}  // namespace lumaknot::validate
