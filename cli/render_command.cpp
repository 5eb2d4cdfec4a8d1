#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/terminal.h"
#include "exporters/image_file.h"
#include "render/fast_renderer.h"
#include "render/render.h"
#include "scene/atomic_file.h"

namespace lumaknot {
namespace {

struct RenderFlags {
  std::string scene = "figure2", output;
  bool fast = false;
  std::string filter = "bilinear", wrap = "repeat";
  FastOptions options;
  Output out;
};

Image draw(const Scene& scene, const RenderFlags& flags) {
  if (!flags.fast) return render(scene, progress_bar(flags.out, "render"));
  FastOptions options = flags.options;
  options.filter = flags.filter == "trilinear" ? Filter::kTrilinear : Filter::kBilinear;
  options.wrapping = flags.wrap == "clamp" ? Wrapping::kClamp : Wrapping::kRepeat;
  Image image;
  FastRenderer(scene, options).draw(image);
  return image;
}

void add_fast_flags(CLI::App& command, RenderFlags& flags) {
  CLI::Option* fast = command.add_flag(
      "--fast", flags.fast,
      "draw in single precision at the machine's speed; without it, in double precision");
  FastOptions& options = flags.options;
  command
      .add_option("--multisample", options.samples,
                  "samples of coverage and depth a pixel: 1, 2, 4, 6, 8 or 16")
      ->capture_default_str()
      ->needs(fast);
  command.add_option("--filter", flags.filter, "of the texture")
      ->capture_default_str()
      ->check(CLI::IsMember({"bilinear", "trilinear"}))
      ->needs(fast);
  command.add_option("--wrap", flags.wrap, "texture coordinates beyond [0, 1]")
      ->capture_default_str()
      ->check(CLI::IsMember({"repeat", "clamp"}))
      ->needs(fast);
  command.add_flag("--cull", options.cull_back_faces, "leave out triangles seen from behind")
      ->needs(fast);
  command.add_option("--threads", options.threads, "0: one for each core")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024))
      ->needs(fast);
}

void run(const RenderFlags& flags) {
  check_image_extension(flags.output, "--output");
  check_writable(flags.output, "--output");
  const Scene scene = load_scene(read_scene(flags.scene));
  const auto start = std::chrono::steady_clock::now();
  const Image image = draw(scene, flags);
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
  add_fast_flags(*command, *flags);
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot render scene.json -o knot.exr\n"
      "  lumaknot render figure1-back -o back.png\n"
      "  lumaknot render figure2 --fast --multisample 8 --filter trilinear -o fast.png");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
