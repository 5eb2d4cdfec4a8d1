#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/terminal.h"
#include "exporters/image_file.h"
#include "render/render.h"
#include "scene/atomic_file.h"

namespace lumaknot {
namespace {

struct RenderFlags {
  std::string scene = "figure2", output;
  Output out;
};

void run(const RenderFlags& flags) {
  check_image_extension(flags.output, "--output");
  check_writable(flags.output, "--output");
  const Scene scene = load_scene(read_scene(flags.scene));
  const auto start = std::chrono::steady_clock::now();
  const Image image = render(scene, progress_bar(flags.out, "render"));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  write_image(flags.output, image, "--output");
  if (flags.out.json) {
    const nlohmann::ordered_json json{{"output", flags.output},
                                      {"width", image.width},
                                      {"height", image.height},
                                      {"seconds", seconds.count()}};
    fmt::print("{}\n", json.dump(2));
  }
  flags.out.say(fmt::format("{}: {} x {}, {:.2f} s", flags.output, image.width, image.height,
                            seconds.count()));
}

}  // namespace

void add_render_command(CLI::App& program) {
  auto flags = std::make_shared<RenderFlags>();
  CLI::App* command = program.add_subcommand("render", "Draw a scene with the software renderer");
  command->add_option("scene", flags->scene, "scene file, built-in scene, or -")
      ->capture_default_str();
  command->add_option("-o,--output", flags->output, "the image: .exr (float) or .png (16 bits)")
      ->required();
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot render scene.json -o knot.exr\n"
      "  lumaknot render figure1-back -o back.png");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
