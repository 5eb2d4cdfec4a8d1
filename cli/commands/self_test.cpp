#include "cli/commands/self_test.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/command_table.h"
#include "cli/commands/output_folder.h"
#include "system/atomic_file.h"
#include "validate/self_test/self_test.h"

namespace lumaknot::cli {

int run_self_test_command(const SceneInput& input, const std::vector<std::string>& renderers,
                          const validate::Programs& programs, const std::string& output,
                          const Output& out) {
  const std::filesystem::path file = std::filesystem::path(output) / "self-test.md";
  check_not_input(file, input, "--output");
  const OutputFolder folder(output, "self-test.md");
  const auto* knot = std::get_if<KnotSpec>(&input.spec.mesh);
  const validate::SelfTest test = validate::run_self_test(
      {load_scene(input), knot ? std::optional(*knot) : std::nullopt, renderers, programs},
      progress_bar(out, "self-test"));
  write_file(file, validate::self_test_markdown(test), "--output");
  if (out.json) fmt::print("{}", validate::self_test_json(test));
  out.say(
      fmt::format("{} faults planted that change a picture: {} noticed, {} named, {} unknown, "
                  "{} named wrongly; {} of {} unaltered pictures accused; see {}",
                  test.planted - test.unseen, test.noticed, test.right, test.unknown, test.wrong,
                  test.accused, test.unaltered, file.string()));
  return test.passed() ? kExitAgreed : kExitDiffered;
}

}  // namespace lumaknot::cli
