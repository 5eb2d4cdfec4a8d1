/// What the adapters of other programs share.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "system/process.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::validate {

/// The image that `read` returns, believed only when it throws no std::runtime_error, is finite and
/// shows something, be it with an alpha of 0; else why not.
RenderedShot checked_image(const std::function<Image()>& read);

/// The image in `path`, believed as above when it decodes and has the scene's size.
RenderedShot drawn_image(const std::filesystem::path& path, const View& view);

/// The first line of `text` that starts with `prefix`, or nothing.
std::string line_with(std::string_view text, std::string_view prefix);

/// Why a program ended badly, with the last line that it printed; empty when it ended well.
std::string bad_end(const ProcessResult& ended);

/// The version that the program at `path` prints when called with `argument`: the first line that
/// starts with `prefix`. Empty when it can't be run.
std::string version_of(const std::filesystem::path& path, const std::string& argument,
                       std::string_view prefix);

}  // namespace lumaknot::validate
