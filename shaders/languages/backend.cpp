#include "shaders/languages/backend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lumaknot {

#define LUMAKNOT_LANGUAGE(name) extern const Backend k##name##Backend;
LUMAKNOT_LANGUAGES(LUMAKNOT_LANGUAGE)
#undef LUMAKNOT_LANGUAGE

std::span<const Language> languages() {
#define LUMAKNOT_LANGUAGE(name) Language::k##name,
  static constexpr std::array kAll{LUMAKNOT_LANGUAGES(LUMAKNOT_LANGUAGE)};
#undef LUMAKNOT_LANGUAGE
  return kAll;
}

const Backend& backend_of(Language language) {
#define LUMAKNOT_LANGUAGE(name) &k##name##Backend,
  static constexpr std::array kBackends{LUMAKNOT_LANGUAGES(LUMAKNOT_LANGUAGE)};
#undef LUMAKNOT_LANGUAGE
  return *kBackends.at(std::size_t(language));
}

std::optional<Language> language_of(std::string_view name) {
  const auto found = std::ranges::find(languages(), name,
                                       [](Language language) { return backend_of(language).name; });
  return found == languages().end() ? std::nullopt : std::optional(*found);
}

std::optional<std::string> language_shortfall(Language language, const Material& material) {
  const Backend& backend = backend_of(language);
  if (material.rate == ShadingFrequency::kPixel || backend.has_vertex_stage) return std::nullopt;
  return fmt::format("{} has no vertex stage to compute light in; the nearest is rate \"pixel\"",
                     backend.name);
}

}  // namespace lumaknot
