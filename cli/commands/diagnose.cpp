#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/command_table.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "diagnosis/report.h"
#include "exporters/image/file.h"
#include "scene/presets.h"
#include "system/error.h"

namespace lumaknot::cli {
namespace {

struct DiagnoseFlags {
  std::string picture, scene = "figure2", model;
  Output out;
};

int run(const DiagnoseFlags& flags) {
  const SceneInput input = read_scene(flags.scene);
  const Image picture = read_picture(flags.picture, "PICTURE");
  const Scene scene = load_scene(input);
  Shot shot{"final", Stage::kFinal, scene.view.material};
  if (!flags.model.empty()) shot.material = *with_formula(shot.material, flags.model);
  const auto* knot = std::get_if<KnotSpec>(&input.spec.mesh);
  const diagnosis::Diagnosis result =
      diagnosis::diagnose({scene, shot, picture, knot ? std::optional(*knot) : std::nullopt, false,
                           false, progress_bar(flags.out, "diagnose")});
  if (flags.out.json) fmt::print("{}", diagnosis::report_json(result));
  flags.out.say(diagnosis::report_text(result, flags.picture));
  return result.verdict == diagnosis::Diagnosis::Verdict::kAgrees ? kExitAgreed : kExitDiffered;
}

std::vector<Argument> diagnose_arguments(DiagnoseFlags& flags) {
  std::vector<Argument> all{
      {.names = "PICTURE",
       .target = &flags.picture,
       .meaning = "picture of the scene that another renderer drew: .exr, .png, .tif, ...",
       .value = kFile,
       .required = true},
      scene_argument(flags.scene),
      {.names = "--model",
       .target = &flags.model,
       .meaning = "shader of the picture, from lumaknot shader --list",
       .default_text = "the scene's own",
       .choices = formula_names()}};
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand diagnose_command() {
  const auto flags = std::make_shared<DiagnoseFlags>();
  return {.name = "diagnose",
          .group = Group::kProve,
          .about = "Name the cause of a picture's difference from the scene, with its number",
          .arguments = diagnose_arguments(*flags),
          .notes =
              "Tries changes of the scene, and of how it is drawn and stored, alone and in "
              "pairs, and names the least that makes our picture theirs. Where none does, it "
              "says unknown. Exit code: 0 the picture agrees, 1 it differs, 2 invalid usage or "
              "input.",
          .examples = {{"lumaknot diagnose theirs.exr figure2"},
                       {"lumaknot diagnose theirs.png scene.json --json"},
                       {"lumaknot diagnose shot.png figure2 --model yiq-phong"}},
          .run = [flags] { return run(*flags); }};
}

}  // namespace lumaknot::cli
