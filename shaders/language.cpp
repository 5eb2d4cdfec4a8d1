#include "shaders/language.h"

#include <fmt/format.h>

#include <algorithm>

namespace lumaknot {

const LanguageInfo& info_of(Language language) { return kLanguages[std::size_t(language)]; }

std::optional<Language> language_of(std::string_view name) {
  const auto found = std::ranges::find(kLanguages, name, &LanguageInfo::name);
  return found == kLanguages.end() ? std::nullopt : std::optional(found->language);
}

std::optional<std::string> language_shortfall(Language language, const Material& material) {
  const LanguageInfo& info = info_of(language);
  if (material.rate == Rate::kPixel || info.has_vertex_stage) return std::nullopt;
  return fmt::format("{} has no vertex stage to compute light in; the nearest is rate \"pixel\"",
                     info.name);
}

}  // namespace lumaknot
