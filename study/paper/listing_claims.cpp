#include "study/paper/listing_claims.h"

#include <algorithm>

#include "scene/presets.h"
#include "shaders/shader.h"
#include "study/paper/picture_measures.h"
#include "study/paper/slots.h"
#include "validate/spirv.h"

namespace lumaknot {
namespace {

constexpr std::size_t kSection = 2;
constexpr double kSliderMost = 16, kDefaultPower = 55;  // of Table 1's SpecularPower

std::vector<Measure> same_picture(const Change& change) {
  return {at_most("pixels changed by more than 1/255", 100 * change.share, 0, "%"),
          note("mean change", change.mean), note("largest change", change.max)};
}

ListingPictures listing_pictures(const PaperScenes& scenes) {
  const Scene& scene = scenes.front;
  const Material equations = formula_of(scene, "yiq-eq6"),
                 listing = formula_of(scene, "yiq-table1");
  const auto with = [&](auto change) {
    Material material = equations;
    change(material);
    return picture(scenes, scene, material);
  };
  return {picture(scenes, scene, equations), picture(scenes, scene, listing),
          with([&](Material& m) { m.luma_offset = listing.luma_offset; }),
          with([&](Material& m) { m.clamp = listing.clamp; }),
          with([&](Material& m) { m.normal = listing.normal; })};
}

long long ungated(const PaperScenes& scenes, const Scene& scene) {
  const Marks dark = marked(stage_picture(scenes, scene, Stage::kDiffuse),
                            [](double light) { return light <= 0; });
  const Marks shiny = marked(stage_picture(scenes, scene, Stage::kSpecular),
                             [](double light) { return light > kStep; });
  return std::ranges::count(both(dark, shiny), 1);
}

SliderPictures slider_pictures(const PaperScenes& scenes) {
  const auto at = [&](double power) {
    Material material = formula_of(scenes.front, "yiq-table1");
    material.shininess = power;
    return picture(scenes, scenes.front, material);
  };
  return {kSliderMost, kDefaultPower, at(kSliderMost), at(kDefaultPower)};
}

ShaderJob listing_job(const Scene& scene) {
  return {"yiq-table1",
          scene.view,
          {"final", Stage::kFinal, formula_of(scene, "yiq-table1")},
          Keep::kNeeded,
          {}};
}

}  // namespace

PaperClaim listing_claim(const ListingPictures& p) {
  return {"listing",
          kSection,
          "Table 1's listing is the implementation of eq. 6 to 8.",
          "Front picture of the listing against that of the equations, as displayed. The next four "
          "take its departures one by one.",
          same_picture(change_between(p.equations, p.listing)),
          ""};
}

PaperClaim offset_claim(const ListingPictures& p) {
  return {"offset",
          kSection,
          "Y * Diffuse + Specular * 1.0 - 0.1 is eq. 6.",
          "Eq. 6-8 with the listing's -0.1, which is in no equation, against those without.",
          same_picture(change_between(p.equations, p.offset)),
          ""};
}

PaperClaim clamps_claim(const ListingPictures& p) {
  return {"clamps",
          kSection,
          "saturate(saturate(L . n) + Ambient) is L_A + L_D.",
          "Eq. 6-8 with the listing's two clamps of the light against those without: where "
          "L_A + L_D is above 1.",
          same_picture(change_between(p.equations, p.clamps)),
          ""};
}

PaperClaim normal_claim(const ListingPictures& p) {
  return {
      "normal",
      kSection,
      "The interpolated NormalWorld is the surface's unit normal.",
      "Eq. 6-8 with the normal as interpolated between the 768 x 40 grid's vertices against the "
      "normal renormalised a pixel.",
      same_picture(change_between(p.equations, p.normal)),
      ""};
}

PaperClaim gate_claim(long long front, long long back) {
  return {
      "gate",
      kSection,
      "Specular reflection appears where light reaches the surface.",
      "Pixels that face away from the light (n . L <= 0) and still have L_S above 1/255: nothing "
      "in eq. 2, 6 or the listing gates the highlight.",
      {at_most("pixels of the front picture", double(front), 0),
       at_most("pixels of the back picture", double(back), 0)},
      ""};
}

PaperClaim slider_claim(const SliderPictures& p) {
  const Change change = change_between(p.at_most, p.at_default);
  return {"slider",
          kSection,
          "SpecularPower has a slider from 0 to 16 and is 55 at first.",
          "The default against its own slider, and the front picture at 16, the nearest that the "
          "slider can return to, against 55.",
          {at_most("default", p.initial, p.slider_most),
           note("pixels changed by more than 1/255", 100 * change.share, "%"),
           note("largest change", change.max)},
          ""};
}

PaperClaim slots_claim(int pixel, int vertex) {
  return {
      "slots",
      kSection,
      "The code takes approximately 40 instruction slots.",
      "Slots of shader model 2 counted in the recorded formula: dp3, mad, mul, add, max 1; nrm, "
      "pow 3; saturating and swizzles free; 1 for the texture, 2 for the output. Vertex shader: "
      "m4x3, m3x3, m4x4, nrm, two moves. Approximately: within a tenth, of the pixel shader "
      "alone or of both.",
      {within("pixel shader", pixel, 36, 44, "slots"),
       within("pixel and vertex shader", pixel + vertex, 36, 44, "slots"),
       at_most("pixel shader's arithmetic against ps_2_0's limit", pixel - 1, 64, "slots")},
      ""};
}

PaperClaim glsl_claim(std::optional<int> hlsl, std::optional<int> glsl) {
  PaperClaim claim{
      "glsl-effort",
      kSection,
      "The code can be converted to GLSL with minimal effort.",
      "The listing's formula emitted as HLSL and as GLSL 450, both compiled to SPIR-V "
      "by glslangValidator: instructions of the pixel shader. Minimal: a tenth more at "
      "most.",
      {},
      ""};
  if (!hlsl || !glsl) {
    claim.beyond = "glslangValidator is not here; apt-get install glslang-tools";
    return claim;
  }
  claim.measures = {note("from HLSL", *hlsl, "instructions"),
                    note("from GLSL", *glsl, "instructions"),
                    at_most("GLSL over HLSL", double(*glsl) / double(*hlsl), 1.1)};
  return claim;
}

std::vector<PaperClaim> listing_claims(const PaperScenes& scenes, const Programs& programs) {
  const ListingPictures pictures = listing_pictures(scenes);
  const ShaderJob job = listing_job(scenes.front);
  return {listing_claim(pictures),
          offset_claim(pictures),
          clamps_claim(pictures),
          normal_claim(pictures),
          gate_claim(ungated(scenes, scenes.front), ungated(scenes, scenes.back)),
          slider_claim(slider_pictures(scenes)),
          slots_claim(pixel_slots(make_shader(job)), kTable1VertexSlots),
          glsl_claim(fragment_instructions(programs, job, Language::kHlsl),
                     fragment_instructions(programs, job, Language::kGlsl450))};
}

}  // namespace lumaknot
