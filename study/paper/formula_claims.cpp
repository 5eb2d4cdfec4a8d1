#include "study/paper/formula_claims.h"

#include <algorithm>
#include <cmath>

#include "scene/presets.h"
#include "shaders/spaces/yiq.h"
#include "study/paper/picture_measures.h"

namespace lumaknot::paper {
namespace {

constexpr double kFloat = 1e-6;  // of colours kept as float: a few units in the last place of 2

/// How far `value(point)` is from `right(point)` over all points.
template <class F, class G>
Change over(std::span<const LitPoint> points, F value, G right) {
  Change change;
  for (const LitPoint& p : points) {
    const double d = std::abs(value(p) - right(p));
    change.pixels += d > kStep;
    change.mean += d;
    change.max = std::max(change.max, d);
  }
  if (points.empty()) return change;
  change.mean /= double(points.size());
  change.share = double(change.pixels) / double(points.size());
  return change;
}

/// The largest change of I or Q between two pictures, and the share of pixels where it exceeds a
/// step; of displayed colours, or of those computed.
Change chroma_change(const Image& a, const Image& b, bool displayed) {
  Change change;
  long long count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i].coverage <= 0) continue;
    const auto yiq = [&](const Image& image) {
      const Vec3d c = to_vec(image.pixels[i].color);
      return yiq_from_rgb<double>(displayed ? saturate(c) : c);
    };
    const Yiq<double> p = yiq(a), q = yiq(b);
    const double d = std::max(std::abs(p.i - q.i), std::abs(p.q - q.q));
    ++count;
    change.pixels += d > kStep;
    change.max = std::max(change.max, d);
  }
  change.share = count ? double(change.pixels) / double(count) : 0;
  return change;
}

double mean_luma_gain(const Image& image, const Image& above) {
  double sum = 0;
  long long count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (image.pixels[i].coverage <= 0) continue;
    const auto luma = [&](const Image& of) {
      return yiq_from_rgb<double>(to_vec(of.pixels[i].color)).y;
    };
    sum += luma(image) - luma(above);
    ++count;
  }
  return count ? sum / double(count) : 0;
}

std::vector<LitPoint> lit_points(const PaperScenes& scenes) {
  const Scene& scene = scenes.front;
  const Image diffuse = stage_picture(scenes, scene, Stage::kDiffuse);
  const Image specular = stage_picture(scenes, scene, Stage::kSpecular);
  const Vec3d light = std::get<PointLight>(scene.view.lights.front()).position;
  std::vector<LitPoint> points;
  for (std::size_t i = 0; i < scenes.fragments.pixels.size(); ++i) {
    const Fragment& f = scenes.fragments.pixels[i];
    if (!f.covered()) continue;
    points.push_back(
        {{unit(f.normal), unit(light - f.position), unit(scene.view.camera.position - f.position)},
         double(diffuse.pixels[i].color.r),
         double(specular.pixels[i].color.r)});
  }
  return points;
}

/// The scene's material with `formula`, without highlights.
Material dull(const Scene& scene, std::string_view formula) {
  Material material = formula_of(scene, formula);
  material.specular = 0;
  return material;
}

HighlightPictures highlight_pictures(const PaperScenes& scenes, std::string_view formula) {
  const Scene& scene = scenes.front;
  return {picture(scenes, scene, formula_of(scene, formula)),
          picture(scenes, scene, dull(scene, formula))};
}

Image plain_picture(const PaperScenes& scenes, const Vec3d& color) {
  Scene scene = scenes.front;
  scene.texture = color;
  return picture(scenes, scene, formula_of(scene, "yiq-eq6"));
}

}  // namespace

PaperClaim eq1_claim(std::span<const LitPoint> points) {
  const auto right = [](const LitPoint& p) { return p.diffuse; };
  const Change worded =
      over(points, [](const LitPoint& p) { return eq1_as_worded(p.directions); }, right);
  return {
      "eq1",
      0,
      "Eq. 1, where L points from the light source to the surface, is Lambert's law.",
      "L_D at every pixel of the front picture, with L as the text defines it, against Table 1's, "
      "whose L points to the light.",
      {at_most("pixels with another L_D than Table 1's", 100 * worded.share, 0, "%"),
       note("mean difference of L_D", worded.mean)},
      ""};
}

PaperClaim delimited_claim(std::span<const LitPoint> points) {
  const auto [low, high] = std::ranges::minmax(points, {}, &LitPoint::diffuse);
  return {"delimited",
          0,
          "L_D is delimited within [0, 1].",
          "The extremes of L_D over the front picture, of unit vectors.",
          {at_least("least L_D", low.diffuse, 0), at_most("most L_D", high.diffuse, 1)},
          ""};
}

PaperClaim eq2_claim(std::span<const LitPoint> points, double shininess) {
  const auto right = [](const LitPoint& p) { return p.specular; };
  const Change printed =
      over(points, [](const LitPoint& p) { return eq2_as_printed(p.directions); }, right);
  const Change repaired = over(
      points, [&](const LitPoint& p) { return std::pow(eq2_with_n(p.directions), shininess); },
      right);
  return {
      "eq2",
      0,
      "Eq. 2 is Phong's specular reflection.",
      "L_S at every pixel of the front picture against Table 1's. As printed, "
      "v . (L - (2 L . n)) takes a number from a vector, which HLSL does component by component, "
      "and has no exponent. With the missing n and the exponent put back, and L from the light "
      "to the surface as the text has it, it must be Phong's.",
      {at_most("pixels with another L_S as printed", 100 * printed.share, 0, "%"),
       note("mean difference as printed", printed.mean),
       note("largest difference as printed", printed.max),
       at_most("largest difference with n and exponent put back", repaired.max, kFloat)},
      ""};
}

PaperClaim rgb_brightness_claim(const Image& texture, const Image& phong) {
  const Rise rise = luma_rise(phong, texture);
  return {
      "rgb-no-brighter",
      0,
      "With eq. 3 the original texture colour cannot get brighter.",
      "Front picture without highlights, as displayed: pixels whose luma is above the texture's "
      "by more than 1/255. Light reaches L_A + L_D = 1.1 there.",
      {at_most("pixels brighter than the texture", 100 * rise.share, 0, "%"),
       note("largest rise of luma", rise.max)},
      ""};
}

PaperClaim yiq_brightness_claim(const Image& texture, const Image& phong, const Image& yiq) {
  const Rise rise = luma_rise(yiq, texture);
  return {"yiq-brighter",
          1,
          "In YIQ diffuse light can make the texture brighter than eq. 3 can.",
          "The same picture in YIQ. Luma is a weighted sum of the channels, so eq. 3 already "
          "multiplies it by L_A + L_D, as eq. 6 does: what YIQ gains is taken before the clamp.",
          {at_least("pixels brighter than the texture", 100 * rise.share, 0.1, "%"),
           note("largest rise of luma", rise.max),
           at_least("mean luma above Phong's, as computed", mean_luma_gain(yiq, phong), kStep)},
          ""};
}

PaperClaim kept_color_claim(const Image& texture, const Image& yiq) {
  const Change computed = chroma_change(texture, yiq, false);
  const Change shown = chroma_change(texture, yiq, true);
  return {"kept-color",
          1,
          "The colour part of the texture is preserved: I_F = I_T, Q_F = Q_T (eq. 7 and 8).",
          "I and Q of the front picture, of eq. 6-8 without clamp, against the texture's; as "
          "computed and as a display limits them to [0, 1].",
          {at_most("largest change as computed", computed.max, kFloat),
           at_most("pixels changed on a display", 100 * shown.share, 0, "%"),
           note("largest change on a display", shown.max)},
          ""};
}

PaperClaim grey_added_claim(const HighlightPictures& phong) {
  const Image added = minus(phong.with, phong.without);
  return {
      "grey-added",
      0,
      "In RGB the specular reflection is added independently of the texture: a certain amount of "
      "grey.",
      "Front picture with highlights minus the same without, not limited: the largest difference "
      "of two channels, 0 for grey.",
      {at_most("largest tint of what is added", largest_tint(added), kFloat)},
      ""};
}

PaperClaim highlight_depends_claim(const HighlightPictures& yiq) {
  const Image added = minus(yiq.with, yiq.without);
  return {
      "highlight-depends",
      1,
      "In YIQ the specular reflection depends on the surface's texture.",
      "The same in YIQ. Eq. 6 adds L_S to Y, and eq. 5's column of ones adds Y to every channel: "
      "were the highlight the texture's, what is added would have a tint of more than 1/255.",
      {at_least("largest tint of what is added", largest_tint(added), kStep)},
      ""};
}

PaperClaim eliminated_claim(const HighlightPictures& phong, const HighlightPictures& yiq) {
  return {
      "eliminated",
      4,
      "The approach eliminates RGB's restrictions: that the diffuse colour cannot become brighter "
      "and that the specular reflection adds grey whatever the texture.",
      "Front pictures as computed: luma of YIQ's above Phong's without highlights, and the tint "
      "of what YIQ's highlight adds; both by more than 1/255.",
      {at_least("mean luma above Phong's", mean_luma_gain(yiq.without, phong.without), kStep),
       at_least("largest tint of what is added", largest_tint(minus(yiq.with, yiq.without)),
                kStep)},
      ""};
}

PaperClaim always_depends_claim(const Image& one, const Image& other) {
  const Marks all = covered(one);
  const auto same = [&](double share) { return 100 * (1 - share); };
  return {
      "always-depends",
      1,
      "The resulting colour is always dependent on the surface's texture.",
      "Front picture of a plain red and of a plain blue surface of the same luma, in YIQ: pixels "
      "that look the same, no channel more than 1/255 apart.",
      {at_most("the same as computed", same(unlimited_change(one, other).share), 0, "%"),
       at_most("the same on a display", same(change_between(one, other, all).share), 0, "%")},
      ""};
}

std::vector<PaperClaim> formula_claims(const PaperScenes& scenes) {
  const Scene& scene = scenes.front;
  const YiqMatrices m = paper_matrices();
  const std::vector<LitPoint> points = lit_points(scenes);
  const Image texture = stage_picture(scenes, scene, Stage::kTexture);
  const HighlightPictures phong = highlight_pictures(scenes, "phong");
  const HighlightPictures yiq = highlight_pictures(scenes, "yiq-eq6");
  const Vec3d red{0.6, 0.15, 0.1}, &weights = m.from_rgb.rows[0];
  Vec3d blue{0.15, 0.25, 0};
  blue.z = (dot(weights, red) - dot(weights, blue)) / weights.z;  // of the same luma
  return {eq1_claim(points),
          delimited_claim(points),
          eq2_claim(points, scene.view.material.parameters["shininess"]),
          rgb_brightness_claim(texture, phong.without),
          grey_added_claim(phong),
          luma_claim(m.from_rgb.rows[0]),
          ranges_claim(m),
          inverse_claim(m),
          ones_claim(m),
          kept_color_claim(texture, yiq.with),
          yiq_brightness_claim(texture, phong.without, yiq.without),
          highlight_depends_claim(yiq),
          eliminated_claim(phong, yiq),
          always_depends_claim(plain_picture(scenes, red), plain_picture(scenes, blue))};
}

}  // namespace lumaknot::paper
