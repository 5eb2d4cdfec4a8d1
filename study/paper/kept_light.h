/// A light's pictures, kept for a run that goes on after an interrupted one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/paper/figures.h"

namespace lumaknot {

/// Writes the images to their places in `folder`, where those that were not drawn are removed, then
/// what was measured of them to images/LIGHT.json with `key`. Throws Error.
void keep_light(const LightPictures& light, const std::filesystem::path& folder, FigureLight which,
                const std::string& key);

/// What was kept; nothing when it is not there whole, has another key, or a renderer was missing,
/// which may be here by now.
std::optional<LightPictures> kept_light(const std::filesystem::path& folder, FigureLight which,
                                        const std::string& key);

/// Removes both lights' .json, the images staying: the next run draws anew.
void forget_lights(const std::filesystem::path& folder);

/// How many lights are kept.
int kept_lights(const std::filesystem::path& folder, const std::string& key);

}  // namespace lumaknot
