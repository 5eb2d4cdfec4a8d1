/// The pictures of a light, kept so that an interrupted run can resume.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/paper/figures.h"

namespace lumaknot::paper {

/// Writes the images to their places in `folder`, where those that were not drawn are removed, then
/// their measures to images/LIGHT.json with `key`. Throws Error.
void keep_light(const LightPictures& light, const std::filesystem::path& folder, FigureLight which,
                const std::string& key);

/// What was kept; nothing if a part of it is missing, its key differs, or a renderer was missing,
/// which may be installed by now.
std::optional<LightPictures> kept_light(const std::filesystem::path& folder, FigureLight which,
                                        const std::string& key);

/// Removes both lights' .json but not the images: the next run draws them again.
void forget_lights(const std::filesystem::path& folder);

/// The number of lights that are kept.
int checkpointed_lights(const std::filesystem::path& folder, const std::string& key);

}  // namespace lumaknot::paper
