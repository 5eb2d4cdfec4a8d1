#include "study/paper/listing_claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <set>

#include "scene/presets.h"
#include "shaders/graph/shader.h"
#include "shaders/languages/backend.h"
#include "shaders/languages/functions.h"
#include "study/paper/instruction_slots.h"
#include "study/paper/picture_measures.h"

namespace lumaknot::embedded {
std::string_view table1_as_printed();
}  // namespace lumaknot::embedded

namespace lumaknot::paper {
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

/// The tokens of a program's text.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
      word += c;
      continue;
    }
    if (!word.empty() && !std::isdigit(static_cast<unsigned char>(word.front())))
      words.insert(word);
    word.clear();
  }
  return words;
}

/// Local variables ("float3 name = ...") that their function declares again. Functions are
/// the text between brackets of the first depth.
int declared_twice(std::string_view text) {
  static const std::regex kDeclaration(R"(\bfloat[234]?\s+(\w+)\s*=)");
  int twice = 0, depth = 0;
  std::string body;
  const auto end_body = [&] {
    std::set<std::string> known;
    for (std::sregex_iterator at(body.begin(), body.end(), kDeclaration), end; at != end; ++at) {
      twice += !known.insert((*at)[1]).second;
    }
    body.clear();
  };
  for (const char c : text) {
    if (c == '{') ++depth;
    if (depth > 0) body += c;
    if (c == '}' && --depth == 0) end_body();
  }
  return twice;
}

/// Where the surface faces away from the light and the highlight of exponent `power` shows.
Ungated ungated(const PaperScenes& scenes, Scene scene, const std::string& name, double power) {
  scene.view.material.parameters["shininess"] = power;
  const Marks dark = marked(stage_picture(scenes, scene, Stage::kDiffuse),
                            [](double light) { return light <= 0; });
  const Marks shiny = marked(stage_picture(scenes, scene, Stage::kSpecular),
                             [](double light) { return light > kStep; });
  return {fmt::format("{}, SpecularPower {}", name, power),
          std::ranges::count(both(dark, shiny), 1)};
}

std::vector<Ungated> all_ungated(const PaperScenes& scenes) {
  std::vector<Ungated> all;
  for (const double power : {kDefaultPower, kSliderMost, 1.0}) {
    all.push_back(ungated(scenes, scenes.front, "front picture", power));
    all.push_back(ungated(scenes, scenes.back, "back picture", power));
  }
  return all;
}

SliderPictures slider_pictures(const PaperScenes& scenes) {
  const auto at = [&](double power) {
    Material material = formula_of(scenes.front, "yiq-table1");
    material.parameters["shininess"] = power;
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
      "normal renormalised per pixel.",
      same_picture(change_between(p.equations, p.normal)),
      ""};
}

PaperClaim gate_claim(const std::vector<Ungated>& pictures) {
  PaperClaim claim{
      "gate",
      kSection,
      "Specular reflection appears where light reaches the surface.",
      "Pixels that face away from the light (n . L <= 0) and still have L_S above "
      "1/255: nothing in eq. 2, eq. 6 or the listing gates the highlight. At its default "
      "exponent and at the most and the least but zero that its slider has.",
      {},
      ""};
  for (const Ungated& u : pictures) {
    claim.measures.push_back(at_most(u.picture, double(u.pixels), 0, "pixels"));
  }
  return claim;
}

PaperClaim slider_claim(const SliderPictures& p) {
  const Change change = change_between(p.at_most, p.at_default);
  return {"slider",
          kSection,
          "SpecularPower has a slider from 0 to 16 and is 55 at first.",
          "The default against its own slider, and the front picture at 16, the nearest that the "
          "slider can return to, against 55.",
          {at_most("default", p.initial, p.slider_max),
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

PaperClaim glsl_claim(const std::string& hlsl, const std::string& glsl) {
  const std::set<std::string> before = words_of(hlsl), after = words_of(glsl);
  std::vector<std::string> replaced;
  std::ranges::set_difference(before, after, std::back_inserter(replaced));
  constexpr double kFew = 5;
  return {
      "glsl-effort",
      kSection,
      "The code can be converted to GLSL with minimal effort.",
      "The listing's formula as one function, emitted as HLSL and as GLSL: words of the HLSL that "
      "the GLSL has not. Minimal: at most five.",
      {at_most("words to replace", double(replaced.size()), kFew),
       note("different words of the function", double(before.size()))},
      ""};
}

PaperClaim ready_claim(std::string_view text) {
  const auto open = std::ranges::count(text, '{'), closed = std::ranges::count(text, '}');
  return {"ready",
          kSection,
          "The complete HLSL code is described, ready to use.",
          "The listing's text as both scans print it: variables declared again in one scope, which "
          "no compiler takes, and brackets that nothing closes. The print may be at fault.",
          {at_most("variables declared twice", double(declared_twice(text)), 0),
           at_most("brackets left open", double(open - closed), 0)},
          ""};
}

std::vector<PaperClaim> listing_claims(const PaperScenes& scenes) {
  const ListingPictures pictures = listing_pictures(scenes);
  const Shader shader = make_shader(listing_job(scenes.front));
  const ShaderFunction function = color_function(shader);
  return {ready_claim(embedded::table1_as_printed()),
          listing_claim(pictures),
          offset_claim(pictures),
          clamps_claim(pictures),
          normal_claim(pictures),
          gate_claim(all_ungated(scenes)),
          slider_claim(slider_pictures(scenes)),
          slots_claim(pixel_slots(shader), kTable1VertexSlots),
          glsl_claim(function_text(function, dialect_of(Language::kHlsl)),
                     function_text(function, dialect_of(Language::kGlsl330)))};
}

}  // namespace lumaknot::paper
