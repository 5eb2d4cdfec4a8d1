#include <fmt/format.h>

#include <memory>

#include "cli/command_table.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "scene/json.h"
#include "scene/presets.h"

namespace lumaknot::cli {
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

Subcommand scene_command() {
  const auto flags = std::make_shared<SceneFlags>();
  Argument source = scene_argument(flags->source);
  source.meaning =
      "scene file, built-in scene, or - for standard input; if omitted, the built-in scenes are "
      "listed";
  return {.name = "scene",
          .group = Group::kMake,
          .about = "Print a built-in scene, or check and complete a scene file",
          .arguments = {std::move(source),
                        {.names = "--list",
                         .target = &flags->list,
                         .meaning = "list the built-in scenes"},
                        {.names = "--schema",
                         .target = &flags->schema,
                         .meaning = "print the JSON Schema of scene.json"}},
          .examples = {{"lumaknot scene figure2 > scene.json"},
                       {"lumaknot scene mine.json", "check it and fill in the defaults"},
                       {"lumaknot scene --schema > scene.schema.json"}},
          .run = [flags] {
            run(*flags);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
