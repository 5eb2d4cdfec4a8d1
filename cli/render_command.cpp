#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/terminal.h"
#include "exporters/image_file.h"
#include "render/fast_renderer.h"
#include "render/render.h"
#include "render/truth.h"
#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

/// By SimdLevel.
const std::vector<std::string> kSimdNames{"baseline", "avx2", "avx512"};

struct RenderFlags {
  std::string scene = "figure2", output;
  bool fast = false;
  std::string truth;
  TruthOptions truth_options;
  std::string filter = "bilinear", wrap = "repeat", simd;
  FastOptions options;
  bool multisampled = false;
  Output out;
};

/// The knot whose exact surface is asked for.
KnotSpec exact_knot(const MeshSpec& mesh) {
  if (const auto* knot = std::get_if<KnotSpec>(&mesh)) return *knot;
  throw Error("--truth needs mesh.knot: a mesh file has no exact surface; leave out --truth");
}

/// A drawn image and, of the truth, the largest error that it tells of itself.
struct RenderedImage {
  Image image;
  std::optional<double> error;
};

RenderedImage draw_truth(const SceneInput& input, const RenderFlags& flags) {
  const KnotSpec knot = exact_knot(input.spec.mesh);
  const Scene scene{{}, load_texture(input), input.spec.view};
  TruthOptions options = flags.truth_options;
  options.sampling = flags.truth == "area" ? TruthSampling::kArea : TruthSampling::kPoint;
  Truth truth = draw_truth(scene, knot, options, progress_bar(flags.out, "render"));
  return {std::move(truth.image), std::ranges::max(truth.error.pixels)};
}

RenderedImage draw(const SceneInput& input, const RenderFlags& flags) {
  if (!flags.truth.empty()) return draw_truth(input, flags);
  Scene scene = load_scene(input);
  if (!flags.fast) return {render(scene, progress_bar(flags.out, "render")), {}};
  if (flags.multisampled) scene.view.image.samples = 1;
  FastOptions options = flags.options;
  options.filter = flags.filter == "trilinear" ? Filter::kTrilinear : Filter::kBilinear;
  if (!flags.simd.empty()) {
    options.level = SimdLevel(std::ranges::find(kSimdNames, flags.simd) - kSimdNames.begin());
  }
  options.wrapping = flags.wrap == "clamp" ? Wrapping::kClamp : Wrapping::kRepeat;
  Image image;
  FastRenderer(scene, options).draw(image);
  return {std::move(image), {}};
}

void add_fast_flags(CLI::App& command, RenderFlags& flags) {
  CLI::Option* fast = command.add_flag(
      "--fast", flags.fast,
      "draw in single precision at the machine's speed; without it, in double precision");
  FastOptions& options = flags.options;
  command
      .add_option(
          "--multisample", options.samples,
          "samples of coverage and depth a pixel, in place of image.samples: 1, 2, 4, 6, 8 or 16")
      ->capture_default_str()
      ->each([&flags](const std::string&) { flags.multisampled = true; })
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
  command
      .add_option("--simd", flags.simd,
                  "instructions, to compare their pictures; otherwise the most that there are")
      ->check(CLI::IsMember(kSimdNames))
      ->needs(fast);
  command.add_option("--threads", options.threads, "0: one for each core")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024))
      ->needs(fast);
}

void add_truth_flags(CLI::App& command, RenderFlags& flags) {
  CLI::Option* truth =
      command
          .add_option("--truth", flags.truth,
                      "draw the exact tube in place of its mesh: point, each pixel's centre; area, "
                      "the mean over each pixel")
          ->expected(0, 1)
          ->default_str("point")
          ->check(CLI::IsMember({"point", "area"}))
          ->excludes("--fast");
  command
      .add_option("--tolerance", flags.truth_options.tolerance,
                  "of --truth area: a pixel's error, as estimated")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1.0))
      ->needs(truth);
}

void run(const RenderFlags& flags) {
  check_image_extension(flags.output, "--output");
  check_writable(flags.output, "--output");
  const SceneInput input = read_scene(flags.scene);
  check_not_input(flags.output, input, "--output");
  const auto start = std::chrono::steady_clock::now();
  const auto [image, error] = draw(input, flags);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  write_image(flags.output, image, "--output");
  if (flags.out.json) {
    nlohmann::ordered_json json{{"output", flags.output},
                                {"width", image.width},
                                {"height", image.height},
                                {"seconds", seconds.count()}};
    if (error) json["largest_error"] = *error;
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
  add_truth_flags(*command, *flags);
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot render scene.json -o knot.exr\n"
      "  lumaknot render figure1-back -o back.png\n"
      "  lumaknot render figure2 --fast --multisample 8 --filter trilinear -o fast.png\n"
      "  lumaknot render figure2 --truth -o truth.exr\n"
      "  lumaknot render figure2 --truth area -o smooth.exr");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
