#include "study/paper/outlook_claims.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/presets.h"
#include "shaders/graph/shader.h"
#include "shaders/spaces/srgb.h"
#include "study/measure/metrics.h"
#include "study/paper/instruction_slots.h"
#include "study/paper/speed_claims.h"

namespace lumaknot::paper {
namespace {

constexpr std::size_t kOutlookSection = 4;
constexpr std::string_view kSpaces[] = {"yiq",    "yuv601", "yuv709", "cielab",
                                        "cieluv", "din99",  "atd95"};

/// Minnaert's exponent: above 1, which darkens.
constexpr double kDarkness = 1.5;

Image minnaert_picture(const PaperScenes& scenes, std::string_view formula) {
  Material material = formula_of(scenes.front, formula);
  material.parameters["darkness"] = kDarkness;
  material.specular = 0;
  return picture(scenes, scenes.front, material);
}

std::vector<ModelPictures> model_pictures(const PaperScenes& scenes) {
  std::vector<ModelPictures> all;
  for (const std::string name : {"oren-nayar", "cook-torrance"}) {
    const auto drawn = [&](const std::string& space) {
      return picture(scenes, scenes.back,
                     formula_of(scenes.back, fmt::format("{}-{}", space, name)));
    };
    all.push_back({name, drawn("rgb"), drawn("yiq")});
  }
  return all;
}

std::vector<SpacePicture> space_pictures(const PaperScenes& scenes) {
  std::vector<SpacePicture> all;
  const Scene& scene = scenes.back;
  for (const std::string_view space : kSpaces) {
    const std::string formula = fmt::format("{}-phong", space);
    const Shot shot{"final", Stage::kFinal, formula_of(scene, formula)};
    const Shader shader = make_shader({formula, scene.view, shot, Keep::kNeeded, {}});
    all.push_back({std::string(space), picture(scenes, scene, shot.material), pixel_slots(shader)});
  }
  return all;
}

/// FLIP between the back pictures, the knot seen from this many times as far.
double flip_from(const PaperScenes& scenes, double times) {
  Scene scene = scenes.back;
  scene.view.camera.position = scene.view.camera.position * times;
  const Grid<Fragment> fragments = visible_fragments(scene);
  const auto drawn = [&](std::string_view formula) {
    return measure::seen(
        shade_all(scene, {"final", Stage::kFinal, formula_of(scene, formula)}, fragments));
  };
  return measure::errors_between(drawn("phong"), drawn("yiq-eq6")).flip;
}

/// Eq. 3 on linear light: the texture decoded, the picture encoded, both by sRGB.
Image linear_picture(const PaperScenes& scenes, Scene scene) {
  for (Rgb& texel : std::get<TextureImage>(scene.texture).pixels) {
    const Vec3d c = to_vec(texel);
    texel = to_rgb({decode_srgb(c.x), decode_srgb(c.y), decode_srgb(c.z)});
  }
  Image image = picture(scenes, scene, formula_of(scene, "phong"));
  for (RgbaPixel& pixel : image.pixels) {
    const Vec3d c = to_vec(pixel.color);
    pixel.color = to_rgb({encode_srgb(c.x), encode_srgb(c.y), encode_srgb(c.z)});
  }
  return image;
}

RealPictures real_pictures(const PaperScenes& scenes, const Scene& scene) {
  return {linear_picture(scenes, scene), picture(scenes, scene, formula_of(scene, "phong")),
          picture(scenes, scene, formula_of(scene, "yiq-eq6"))};
}

const SpacePicture& space_called(const std::vector<SpacePicture>& spaces, std::string_view name) {
  return *std::ranges::find(spaces, name, &SpacePicture::name);
}

}  // namespace

PaperClaim minnaert_claim(const Image& texture, const Image& rgb, const Image& yiq) {
  const Rise in_rgb = luma_rise(rgb, texture), in_yiq = luma_rise(yiq, texture);
  return {
      "minnaert",
      kOutlookSection,
      "In YIQ Minnaert's model makes the colour brighter in some cases instead of darker each "
      "time.",
      "Front picture without highlights, Minnaert's exponent 1.5: pixels whose luma is above the "
      "texture's by more than 1/255, and how many more they are in YIQ.",
      {at_least("pixels brighter than the texture, YIQ", 100 * in_yiq.share, 0.1, "%"),
       note("the same, RGB", 100 * in_rgb.share, "%"),
       at_least("more of them in YIQ", 100 * (in_yiq.share - in_rgb.share), 0.1, "%")},
      ""};
}

PaperClaim models_claim(const Image& texture, const std::vector<ModelPictures>& models) {
  const Marks all = covered(texture);
  PaperClaim claim{
      "models",
      kOutlookSection,
      "Other lighting models such as Oren-Nayar or Cook-Torrance can benefit as well.",
      "Back picture of each, as displayed: mean CIELAB chroma in YIQ over that in RGB. "
      "A benefit: a tenth more. How far the hue turns from the texture's is beside it.",
      {},
      ""};
  for (const ModelPictures& model : models) {
    const double in_rgb = mean_chroma(model.rgb, all);
    const double more = in_rgb > 0 ? mean_chroma(model.yiq, all) / in_rgb : 0;
    claim.measures.push_back(at_least(model.name + ": chroma over RGB's", more, 1.1));
    claim.measures.push_back(note(model.name + ": mean turn of the hue",
                                  mean_hue_turn(texture, model.yiq, all), "degrees"));
  }
  return claim;
}

PaperClaim spaces_claim(const std::vector<SpacePicture>& spaces) {
  PaperClaim claim{
      "spaces",
      kOutlookSection,
      "Other spaces with a brightness component, YUV, CIELAB, CIELUV, ATD95 and DIN99, "
      "can be used.",
      "The back picture with light on each one's brightness alone: pictures whose every "
      "channel is a number. Instruction slots of the pixel shader; shader model 2 has "
      "64 for arithmetic, model 3 has 512.",
      {},
      ""};
  const auto finite =
      std::ranges::count_if(spaces, [](const SpacePicture& s) { return is_finite(s.image); });
  claim.measures.push_back(
      at_least("spaces that draw the picture", double(finite), double(spaces.size())));
  const int max = std::ranges::max(spaces, {}, &SpacePicture::slots).slots;
  claim.measures.push_back(at_most("most slots", max, 512));
  for (const SpacePicture& s : spaces) claim.measures.push_back(note("slots, " + s.name, s.slots));
  return claim;
}

PaperClaim slow_spaces_claim(const std::vector<FormulaTime>& times) {
  const double yiq = time_of(times, "yiq-phong").milliseconds.median;
  PaperClaim claim{"slow-spaces",
                   kOutlookSection,
                   "CIELAB and CIELUV might not be good choices for real-time processing.",
                   "Frames of Figure 2 on one thread of this machine's processor. Not "
                   "good: fewer than 30 a second, or twice YIQ's time.",
                   {},
                   ""};
  for (const char* formula : {"cielab-phong", "cieluv-phong"}) {
    const double ms = time_of(times, formula).milliseconds.median;
    const std::string space = std::string(formula).substr(0, 6);
    claim.measures.push_back(at_most(space, 1000 / ms, 30, "frames/s"));
    claim.measures.push_back(at_least(space + ": time over YIQ's", ms / yiq, 2));
  }
  for (const char* formula : {"din99-phong", "atd95-phong"}) {
    const double ms = time_of(times, formula).milliseconds.median;
    claim.measures.push_back(note(std::string(formula).substr(0, 5), 1000 / ms, "frames/s"));
  }
  return claim;
}

PaperClaim perceptual_claim(const Image& texture, const std::vector<SpacePicture>& spaces,
                            const Marks& shadow) {
  const auto turn = [&](std::string_view name) {
    return mean_hue_turn(texture, space_called(spaces, name).image, shadow);
  };
  PaperClaim claim{
      "perceptual",
      kOutlookSection,
      "ATD95 and DIN99, modelled closely to human perception, give greater illumination "
      "accuracy.",
      "Back picture as displayed where n . L <= 0: how far the CIELAB hue turns from "
      "the texture's, which light should not change. More accurate: less than in YIQ.",
      {at_most("mean turn, atd95", turn("atd95"), turn("yiq"), "degrees"),
       at_most("mean turn, din99", turn("din99"), turn("yiq"), "degrees")},
      ""};
  for (const SpacePicture& s : spaces) {
    if (s.name == "atd95" || s.name == "din99") continue;
    claim.measures.push_back(note("mean turn, " + s.name, turn(s.name), "degrees"));
  }
  return claim;
}

PaperClaim realism_claim(const RealPictures& front, const RealPictures& back) {
  PaperClaim claim{
      "realism",
      kOutlookSection,
      "Where photo-realism is of higher importance the approach may provide a significant "
      "improvement.",
      "Real lamps add up as linear light, so the real picture here is eq. 3 on the decoded "
      "texture, encoded again (sRGB), with the same lamp and surface. Mean CIEDE2000 from "
      "it: an improvement when YIQ's is less than Phong's.",
      {},
      ""};
  const auto add = [&](const std::string& where, const RealPictures& p) {
    const Marks all = covered(p.real);
    const double phong = color_difference(p.real, p.phong, all).mean;
    claim.measures.push_back(
        at_most(where + ", YIQ", color_difference(p.real, p.yiq, all).mean, phong));
    claim.measures.push_back(note(where + ", Phong", phong));
  };
  add("light in front", front);
  add("light at the back", back);
  return claim;
}

PaperClaim complex_scenes_claim(double flip_near, double flip_far) {
  return {
      "complex-scenes",
      kOutlookSection,
      "In scenes of significant complexity the artefacts of classical illumination may not be "
      "easily apparent.",
      "FLIP between Phong's and YIQ's back picture, mean of the picture, as the scene has it and "
      "with the knot four times as far away.",
      {note("mean FLIP", flip_near), note("mean FLIP from afar", flip_far)},
      "What viewers notice in a game is not to be had from one knot; no observers took part."};
}

std::vector<PaperClaim> outlook_claims(const PaperScenes& scenes,
                                       const std::vector<FormulaTime>& times) {
  const Image front = stage_picture(scenes, scenes.front, Stage::kTexture);
  const Image back = stage_picture(scenes, scenes.back, Stage::kTexture);
  const Marks shadow = marked(stage_picture(scenes, scenes.back, Stage::kDiffuse),
                              [](double light) { return light <= 0; });
  const std::vector<SpacePicture> spaces = space_pictures(scenes);
  return {minnaert_claim(front, minnaert_picture(scenes, "rgb-minnaert"),
                         minnaert_picture(scenes, "yiq-minnaert")),
          models_claim(back, model_pictures(scenes)),
          spaces_claim(spaces),
          slow_spaces_claim(times),
          perceptual_claim(back, spaces, shadow),
          realism_claim(real_pictures(scenes, scenes.front), real_pictures(scenes, scenes.back)),
          complex_scenes_claim(flip_from(scenes, 1), flip_from(scenes, 4))};
}

}  // namespace lumaknot::paper
