#include "study/paper/appearance_claims.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"
#include "scene/presets.h"
#include "study/measure/metrics.h"
#include "validate/compare/claims.h"

namespace lumaknot::paper {
namespace {

constexpr std::size_t kLookSection = 3;
constexpr double kHighlight = 0.1;  // of L_S: bright enough to be seen as one

/// A shade is grey if it has less than half of the texture's chroma, percent, and the texture's own
/// if its hue is within this many degrees.
constexpr double kHalf = 50, kAngle = 10;

LookPictures look_pictures(const PaperScenes& scenes, const Scene& scene) {
  const Image diffuse = stage_picture(scenes, scene, Stage::kDiffuse);
  const Image specular = stage_picture(scenes, scene, Stage::kSpecular);
  return {stage_picture(scenes, scene, Stage::kTexture),
          picture(scenes, scene, formula_of(scene, "phong")),
          picture(scenes, scene, formula_of(scene, "yiq-eq6")),
          marked(diffuse, [](double light) { return light <= 0; }),
          marked(specular, [](double light) { return light >= kHighlight; }),
          marked(specular, [](double light) { return light <= kStep; })};
}

/// The share of `part` in `whole`, percent.
double percent_of(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

/// Specular reflection only, in space rgb, on surfaces of several colours and on bricks.
std::vector<Image> phong_highlights(const PaperScenes& scenes) {
  Scene scene = scenes.specular;
  const Material phong = formula_of(scene, "phong");
  std::vector<Image> all{picture(scenes, scene, phong)};
  for (const Vec3d& color : {Vec3d{0.8, 0.1, 0.1}, Vec3d{0.1, 0.7, 0.2}, Vec3d{0.15, 0.2, 0.9},
                             Vec3d{0.9, 0.8, 0.1}, Vec3d{0.5, 0.5, 0.5}}) {
    scene.texture = color;
    all.push_back(picture(scenes, scene, phong));
  }
  return all;
}

/// The highlight times the texture: how a metal reflects white light.
Image metal_of(const PaperScenes& scenes, const Image& texture) {
  Image metal = stage_picture(scenes, scenes.specular, Stage::kSpecular);
  for (std::size_t i = 0; i < metal.pixels.size(); ++i) {
    Rgb& c = metal.pixels[i].color;
    c = to_rgb(modulate(to_vec(c), to_vec(texture.pixels[i].color)));
  }
  return metal;
}

/// The front scene from `count` places around the knot with a fixed light, in small pictures.
std::vector<View360> views_around(const PaperScenes& scenes, int count) {
  constexpr int kSide = 180;
  Scene scene = scenes.front;
  scene.view.image = {kSide, kSide, 1};
  const Vec3d from = scene.view.camera.position;
  std::vector<View360> views;
  for (int i = 0; i < count; ++i) {
    const double angle = kTurn * i / count;
    const double c = std::cos(angle), s = std::sin(angle);
    scene.view.camera.position = {c * from.x - s * from.y, s * from.x + c * from.y, from.z};
    const Grid<Fragment> fragments = visible_fragments(scene);
    const Shot texture{"texture", Stage::kTexture, scene.view.material};
    const Shot yiq{"final", Stage::kFinal, formula_of(scene, "yiq-eq6")};
    views.push_back({shade_all(scene, texture, fragments), shade_all(scene, yiq, fragments)});
  }
  return views;
}

}  // namespace

PaperClaim front_similar_claim(const LookPictures& front) {
  const ColorDifference difference =
      color_difference(front.phong, front.yiq, covered(front.texture));
  const double flip =
      measure::errors_between(measure::seen(front.phong), measure::seen(front.yiq)).flip;
  return {
      "front-similar",
      kLookSection,
      "With the light in front, the results of Phong and YIQ are quite similar.",
      "Both front pictures, as displayed: CIEDE2000 of each pixel (1 is just seen, 10 is another "
      "colour) and FLIP (mean of the picture, 0 to 1).",
      {at_most("mean CIEDE2000", difference.mean, 5),
       at_most("95 % of pixels below", difference.p95, 10), at_most("mean FLIP", flip, 0.1)},
      ""};
}

PaperClaim no_worse_claim(const LookPictures& front) {
  const auto turn = [&](const Image& image) {
    return mean_hue_turn(front.texture, image, covered(front.texture));
  };
  const auto cut = [](const Image& image) { return 100 * share_out_of_gamut(image); };
  return {"no-worse",
          kLookSection,
          "With the light in front the proposed model is no worse than the classical one.",
          "Front pictures: how far CIELAB hues turn from the texture's, and how many pixels have a "
          "colour that a display cuts off. No worse: no more than Phong's, to one degree and one "
          "percent. No number says which picture looks better.",
          {at_most("mean turn of the hue, YIQ", turn(front.yiq), turn(front.phong) + 1, "degrees"),
           note("mean turn of the hue, Phong", turn(front.phong), "degrees"),
           at_most("pixels cut off, YIQ", cut(front.yiq), cut(front.phong) + 1, "%"),
           note("pixels cut off, Phong", cut(front.phong), "%")},
          ""};
}

PaperClaim phong_back_claim(const LookPictures& back) {
  const auto& [texture, phong, yiq, shadow, highlight, unlit] = back;
  return {
      "phong-back-grey",
      kLookSection,
      "With the light at the back, Phong generates grey shades.",
      "Back picture as displayed: CIELAB chroma C* and saturation C*/L* where n . L <= 0, and "
      "saturation where L_S is at least 0.1, each as a share of the texture's there. Grey: less "
      "than half. Dark colours have little chroma without being grey; their saturation shows it.",
      {at_most("chroma in the shadow",
               percent_of(mean_chroma(phong, shadow), mean_chroma(texture, shadow)), kHalf, "%"),
       at_most("saturation in the shadow",
               percent_of(saturation(phong, shadow), saturation(texture, shadow)), kHalf, "%"),
       at_most("saturation in highlights",
               percent_of(saturation(phong, highlight), saturation(texture, highlight)), kHalf,
               "%"),
       note("pixels in the shadow", 100 * share_marked(shadow, texture), "%")},
      ""};
}

PaperClaim yiq_back_claim(const LookPictures& back) {
  const auto& [texture, phong, yiq, shadow, highlight, unlit] = back;
  return {
      "yiq-back-color",
      kLookSection,
      "With the light at the back, YIQ does not generate grey shades.",
      "The same in YIQ. Not grey: at least half; and the shade must be the texture's, within 10 "
      "degrees of its CIELAB hue.",
      {at_least("chroma in the shadow",
                percent_of(mean_chroma(yiq, shadow), mean_chroma(texture, shadow)), kHalf, "%"),
       at_least("saturation in highlights",
                percent_of(saturation(yiq, highlight), saturation(texture, highlight)), kHalf, "%"),
       at_most("mean turn of the hue in the shadow", mean_hue_turn(texture, yiq, shadow), kAngle,
               "degrees"),
       note("pixels that a display cuts off", 100 * share_out_of_gamut(yiq), "%")},
      ""};
}

PaperClaim phong_grey_claim(const std::vector<Image>& phong) {
  double tint = 0, change = 0;
  for (const Image& image : phong) {
    tint = std::max(tint, largest_tint(image));
    change = std::max(change, unlimited_change(phong.front(), image).max);
  }
  return {
      "phong-specular-grey",
      kLookSection,
      "Phong's specular reflection alone is completely grey, no matter what the texture is.",
      "Specular picture on bricks and five plain colours: the largest difference of two channels "
      "of a pixel, and of two textures' pictures.",
      {at_most("largest difference of channels", tint, 0),
       at_most("largest difference between textures", change, 0),
       note("textures", double(phong.size()))},
      ""};
}

PaperClaim yiq_keeps_claim(const LookPictures& p) {
  return {
      "yiq-specular-color",
      kLookSection,
      "In YIQ the specular reflection alone depends on the surface and keeps its colour.",
      "Specular picture in YIQ, as displayed, where L_S is at least 0.1: chroma as a share of "
      "the texture's (kept: half of it, as a highlight is brighter), and its hue.",
      {at_least("chroma in highlights",
                percent_of(mean_chroma(p.yiq, p.highlight), mean_chroma(p.texture, p.highlight)),
                kHalf, "%"),
       at_most("mean turn of the hue in highlights", mean_hue_turn(p.texture, p.yiq, p.highlight),
               kAngle, "degrees"),
       note("Phong's chroma there",
            percent_of(mean_chroma(p.phong, p.highlight), mean_chroma(p.texture, p.highlight)),
            "%")},
      ""};
}

PaperClaim metal_claim(const LookPictures& p, const Image& metal) {
  const double yiq = color_difference(metal, p.yiq, p.highlight).mean;
  const double phong = color_difference(metal, p.phong, p.highlight).mean;
  Image black = p.yiq;
  for (RgbaPixel& pixel : black.pixels) pixel.color = {};
  const Change glow = change_between(black, p.yiq, p.unlit);
  return {"metal",
          kLookSection,
          "In YIQ the specular reflection alone can simulate metallic surfaces.",
          "Specular pictures against a metal's, whose highlight is L_S times the texture: mean "
          "CIEDE2000 in highlights, where YIQ must be nearer to it than Phong; and pixels without "
          "highlight, which a metal leaves black and where eq. 7 and 8 leave the whole chroma.",
          {at_most("CIEDE2000 in highlights, YIQ", yiq, phong),
           note("CIEDE2000 in highlights, Phong", phong),
           at_most("pixels without light that glow", 100 * glow.share, 0, "%"),
           note("mean of their largest channel", glow.mean)},
          ""};
}

PaperClaim any_angle_claim(const std::vector<View360>& views) {
  double turn = 0, cut = 0;
  for (const View360& view : views) {
    turn = std::max(turn, mean_hue_turn(view.texture, view.yiq, covered(view.texture)));
    cut = std::max(cut, share_out_of_gamut(view.yiq));
  }
  return {"any-angle",
          kLookSection,
          "The results are reasonably realistic when viewed from any possible angle and look "
          "natural.",
          "The YIQ picture from all around the knot, the light staying: the most that the mean hue "
          "turns from the texture's, and that a display cuts off.",
          {note("views", double(views.size())), note("most mean turn of the hue", turn, "degrees"),
           note("most pixels cut off", 100 * cut, "%")},
          "What looks realistic or natural only people can say; no observers took part."};
}

std::vector<PaperClaim> look_claims(const PaperScenes& scenes) {
  constexpr int kViews = 12;
  const LookPictures front = look_pictures(scenes, scenes.front);
  const LookPictures back = look_pictures(scenes, scenes.back);
  const LookPictures specular = look_pictures(scenes, scenes.specular);
  return {front_similar_claim(front),
          no_worse_claim(front),
          phong_back_claim(back),
          yiq_back_claim(back),
          phong_grey_claim(phong_highlights(scenes)),
          yiq_keeps_claim(specular),
          metal_claim(specular, metal_of(scenes, specular.texture)),
          any_angle_claim(views_around(scenes, kViews))};
}

}  // namespace lumaknot::paper
