/// Every kind of picture that a material can ask for.
#pragma once

#include <string>
#include <vector>

#include "scene/fields.h"
#include "scene/presets.h"
#include "scene/shot.h"

namespace lumaknot {

/// `base`'s numbers are neither 0 nor 1 nor their defaults, its colours not grey.
inline Material colored_material() {
  Material m;
  m.parameters["shininess"] = 20;
  m.parameters["roughness"] = 0.4;
  m.parameters["reflectance"] = 0.3;
  m.parameters["darkness"] = 1.4;
  m.diffuse = 0.75;
  m.specular = 0.5;
  m.ambient_color = {0.9, 0.7, 0.6};
  m.diffuse_color = {0.8, 0.9, 0.5};
  m.specular_color = {0.7, 0.8, 0.9};
  m.emissive = {0.02, 0.01, 0.03};
  return m;
}

/// One shot for each formula, stage, gamut and rule of highlights, as far as the stage reads them;
/// the name says which.
inline std::vector<Shot> every_shot(const Material& base = colored_material()) {
  std::vector<Shot> shots;
  for (const std::string& formula : formula_names()) {
    Shot shot{formula, Stage::kTexture, *with_formula(base, formula)};
    const auto add = [&](Stage stage, const std::string& what) {
      shot.stage = stage;
      shot.name = formula + " " + what;
      shots.push_back(shot);
    };
    add(Stage::kTexture, "texture");
    add(Stage::kDiffuse, "diffuse");
    for (const Highlights highlights : {Highlights::kFree, Highlights::kGated}) {
      shot.material.highlights = highlights;
      const std::string rule(kHighlightNames[std::size_t(highlights)]);
      shot.material.gamut = Gamut::kFree;
      add(Stage::kSpecular, "specular, " + rule);
      for (const Gamut gamut : {Gamut::kFree, Gamut::kClamp, Gamut::kChroma}) {
        shot.material.gamut = gamut;
        add(Stage::kFinal, rule + ", gamut " + std::string(kGamutNames[std::size_t(gamut)]));
      }
    }
  }
  return shots;
}

/// The shots of every_shot() that show the lit colour with free highlights: one per formula and
/// gamut.
inline std::vector<Shot> final_shots() {
  std::vector<Shot> shots;
  for (const Shot& shot : every_shot()) {
    const bool free = shot.material.highlights == Highlights::kFree;
    if (shot.stage == Stage::kFinal && free) shots.push_back(shot);
  }
  return shots;
}

}  // namespace lumaknot
