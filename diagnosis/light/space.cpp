/// Light that acts in another colour space, or with other rules at the limits.
#include "diagnosis/cause.h"
#include "scene/fields.h"

namespace lumaknot::diagnosis {

namespace {

Hypothesis in_space(Space space) {
  const std::string name(kSpaceNames[std::size_t(space)]);
  return discrete("space-" + name, Rung::kLight, "light acting in " + name, [space](Setup& s) {
    s.view.material.space = space;
    if (!is_linear(space)) s.view.material.form = Form::kMatrices;
  });
}

}  // namespace

std::vector<Hypothesis> space(const Situation& situation) {
  const Material& own = situation.setup.view.material;
  std::vector<Hypothesis> all;
  for (std::size_t i = 0; i < kSpaceNames.size(); ++i) {
    if (Space(i) != own.space) all.push_back(in_space(Space(i)));
  }
  const auto with = [&](const std::string& id, const std::string& sentence, auto Material::* member,
                        auto value) {
    if (own.*member != value) {
      all.push_back(discrete(id, Rung::kLight, sentence,
                             [member, value](Setup& s) { s.view.material.*member = value; }));
    }
  };
  with("clamp-table1", "the light clamped as in Table 1", &Material::clamp, Clamp::kTable1);
  with("clamp-none", "the light not clamped", &Material::clamp, Clamp::kFree);
  with("gamut-chroma", "colours out of gamut brought back along their chroma", &Material::gamut,
       Gamut::kChroma);
  with("gamut-free", "colours out of gamut left as they are", &Material::gamut, Gamut::kFree);
  with("highlights-gated", "no highlight where the light is behind the surface",
       &Material::highlights, Highlights::kGated);
  with("highlights-free", "highlights where the light is behind the surface", &Material::highlights,
       Highlights::kFree);
  if (own.space != Space::kRgb) {
    all.push_back(
        continuous("luma-offset", Rung::kLight, {"offset", own.luma_offset, 0.01, -10, 10},
                   "a luma offset of {:.4g}, not " + number(own.luma_offset),
                   [](Setup& s, double offset) { s.view.material.luma_offset = offset; }));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
