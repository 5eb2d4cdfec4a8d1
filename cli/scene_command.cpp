#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "scene/presets.h"
#include "scene/scene_json.h"

namespace lumaknot {
namespace {

struct SceneFlags {
  std::string source;
  bool list = false, schema = false;
};

void list_scenes() {
  for (const NamedScene& scene : named_scenes()) fmt::print("{:<18} {}\n", scene.name, scene.about);
}

void run(const SceneFlags& flags) {
  if (flags.schema) {
    fmt::print("{}", scene_json_schema());
  } else if (flags.list || flags.source.empty()) {
    list_scenes();
  } else {
    fmt::print("{}", scene_to_json(read_scene(flags.source).spec));
  }
}

}  // namespace

void add_scene_command(CLI::App& program) {
  auto flags = std::make_shared<SceneFlags>();
  CLI::App* command =
      program.add_subcommand("scene", "Print a built-in scene, or check and complete a scene file");
  command->add_option("scene", flags->source,
                      "built-in scene, scene file, or - for standard input");
  command->add_flag("--list", flags->list, "list the built-in scenes");
  command->add_flag("--schema", flags->schema, "print the JSON Schema of scene.json");
  command->footer(
      "Examples:\n"
      "  lumaknot scene figure2 > scene.json\n"
      "  lumaknot scene mine.json           check it and fill in the defaults\n"
      "  lumaknot scene --schema > scene.schema.json");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
