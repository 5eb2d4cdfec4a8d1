// The list of renderers in docs/renderer-facts.md is that of their entries.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "system/atomic_file.h"
#include "validate/renderers/entry.h"

namespace lumaknot::validate {
namespace {

std::string row_of(const RendererEntry& entry) {
  std::vector<std::string_view> programs;
  for (const ProgramInfo* program : entry.programs) {
    if (program) programs.push_back(program->name);
  }
  return fmt::format("| {} | {} | {} | {} | {} |\n", entry.name, entry.flag,
                     entry.by_default ? "yes" : "", fmt::join(programs, ", "),
                     entry.promise.reason);
}

TEST(Documentation, lists_every_renderer_with_the_reason_for_its_limits) {
  std::string table =
      "| renderer | `--renderer` | by default | programs | why its limits "
      "|\n|---|---|---|---|---|\n";
  for (const RendererEntry* entry : renderer_entries()) table += row_of(*entry);
  const std::string path = LUMAKNOT_SOURCE_DIR "/docs/renderer-facts.md";
  EXPECT_THAT(read_file(path, path), ::testing::HasSubstr("\n\n" + table + "\n"))
      << "the table should be:\n"
      << table;
}

}  // namespace
}  // namespace lumaknot::validate
