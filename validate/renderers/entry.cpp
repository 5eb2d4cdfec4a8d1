#include "validate/renderers/entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "validate/renderers/list.h"

namespace lumaknot::validate {

#define LUMAKNOT_RENDERER(name) extern const RendererEntry k##name##Entry;
LUMAKNOT_RENDERERS(LUMAKNOT_RENDERER)
#undef LUMAKNOT_RENDERER

std::span<const RendererEntry* const> renderer_entries() {
#define LUMAKNOT_RENDERER(name) &k##name##Entry,
  static constexpr auto kEntries =
      std::to_array<const RendererEntry*>({LUMAKNOT_RENDERERS(LUMAKNOT_RENDERER)});
#undef LUMAKNOT_RENDERER
  return kEntries;
}

const RendererEntry& renderer_entry(std::string_view name) {
  for (const RendererEntry* entry : renderer_entries()) {
    if (entry->name == name) return *entry;
  }
  throw std::logic_error(fmt::format("no renderer is called {}", name));
}

Promise promise_of(const RendererEntry& entry, std::string_view version) {
  return entry.promise_of ? entry.promise_of(entry.promise, version) : entry.promise;
}

std::vector<const ProgramInfo*> renderer_programs() {
  std::vector<const ProgramInfo*> programs;
  for (const RendererEntry* entry : renderer_entries()) {
    for (const ProgramInfo* program : entry->programs) {
      if (program && std::ranges::count(programs, program) == 0) programs.push_back(program);
    }
  }
  return programs;
}

std::string not_found(const Programs& programs, const ProgramInfo& program) {
  const std::string path = programs.path(program);
  return fmt::format("{} not found; {}", path.empty() ? program.name : path, program.remedy);
}

}  // namespace lumaknot::validate
