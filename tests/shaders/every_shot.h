/// Every kind of picture that a material can ask for.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/shot.h"

namespace lumaknot {

/// One shot for each combination of stage, space, clamp and normal; the name tells which.
inline std::vector<Shot> every_shot() {
  std::vector<Shot> shots;
  for (const Stage stage : {Stage::kTexture, Stage::kDiffuse, Stage::kSpecular, Stage::kFinal}) {
    for (const Space space : {Space::kRgb, Space::kYiq}) {
      for (const Clamp clamp : {Clamp::kFree, Clamp::kTable1}) {
        for (const NormalUse normal : {NormalUse::kUnit, NormalUse::kInterpolated}) {
          Shot shot;
          shot.stage = stage;
          shot.material.space = space;
          shot.material.clamp = clamp;
          shot.material.normal = normal;
          shot.material.diffuse = 0.75;
          shot.material.specular = 0.5;
          shot.material.shininess = 20;
          shot.material.luma_offset = space == Space::kYiq ? -0.1 : 0;
          shot.name = "stage " + std::to_string(int(stage)) + " space " +
                      std::to_string(int(space)) + " clamp " + std::to_string(int(clamp)) +
                      " normal " + std::to_string(int(normal));
          shots.push_back(shot);
        }
      }
    }
  }
  return shots;
}

}  // namespace lumaknot
