#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command_table.h"
#include "cli/commands/scene_input.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "exporters/image/file.h"
#include "render/exact/truth.h"
#include "render/fast/renderer.h"
#include "render/reference.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot::cli {
namespace {

/// Indexed by SimdLevel.
constexpr std::array<std::string_view, 3> kSimdNames{"baseline", "avx2", "avx512"};

struct RenderFlags {
  std::string scene = "figure2", output;
  bool fast = false;
  std::string truth;
  exact::TruthOptions truth_options;
  std::string filter = "bilinear", wrap = "repeat", simd;
  fast::Options options;
  bool multisampled = false;
  Output out;
};

/// The knot whose exact surface is drawn.
KnotSpec exact_knot(const MeshSpec& mesh) {
  if (const auto* knot = std::get_if<KnotSpec>(&mesh)) return *knot;
  throw Error("--truth needs mesh.knot: a mesh file has no exact surface; leave out --truth");
}

/// A rendered image and, for --truth, its largest estimated error.
struct RenderedImage {
  Image image;
  std::optional<double> error;
};

RenderedImage draw_truth(const SceneInput& input, const RenderFlags& flags) {
  const KnotSpec knot = exact_knot(input.spec.mesh);
  const Scene scene{{}, load_texture(input), input.spec.view};
  exact::TruthOptions options = flags.truth_options;
  options.sampling =
      flags.truth == "area" ? exact::TruthSampling::kArea : exact::TruthSampling::kPoint;
  exact::Truth truth = exact::draw_truth(scene, knot, options, progress_bar(flags.out, "render"));
  return {std::move(truth.image), std::ranges::max(truth.error.pixels)};
}

RenderedImage draw(const SceneInput& input, const RenderFlags& flags) {
  if (!flags.truth.empty()) return draw_truth(input, flags);
  Scene scene = load_scene(input);
  if (!flags.fast) return {render(scene, progress_bar(flags.out, "render")), {}};
  if (flags.multisampled) scene.view.image.samples = 1;
  fast::Options options = flags.options;
  options.filter = flags.filter == "trilinear" ? Filter::kTrilinear : Filter::kBilinear;
  if (!flags.simd.empty()) {
    options.level = fast::SimdLevel(std::ranges::find(kSimdNames, flags.simd) - kSimdNames.begin());
  }
  options.wrapping = flags.wrap == "clamp" ? Wrapping::kClamp : Wrapping::kRepeat;
  Image image;
  fast::Renderer(scene, options).draw(image);
  return {std::move(image), {}};
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

constexpr std::string_view kFastHeading = "Fast rendering";

/// A flag of --fast, without its target.
Argument fast_argument(std::string names, std::string meaning) {
  return {.names = std::move(names),
          .meaning = std::move(meaning),
          .needs = "--fast",
          .heading = kFastHeading};
}

Argument multisample_argument(RenderFlags& flags) {
  const auto take = [&flags](int samples) {
    flags.options.samples = samples;
    flags.multisampled = true;
  };
  return {.names = "--multisample",
          .target = Take<int>(take),
          .meaning = "coverage and depth samples per pixel, instead of image.samples",
          .default_text = std::to_string(flags.options.samples),
          .choices = {"1", "2", "4", "6", "8", "16"},
          .checked = false,
          .needs = "--fast",
          .heading = kFastHeading};
}

std::vector<Argument> fast_arguments(RenderFlags& flags) {
  Argument filter = fast_argument("--filter", "texture filter");
  filter.target = &flags.filter;
  filter.choices = {"bilinear", "trilinear"};
  Argument wrap = fast_argument("--wrap", "texture wrapping outside [0, 1]");
  wrap.target = &flags.wrap;
  wrap.choices = {"repeat", "clamp"};
  Argument cull = fast_argument("--cull", "skip triangles seen from behind");
  cull.target = &flags.options.cull_back_faces;
  Argument simd = fast_argument("--simd", "instruction set, for comparing pictures");
  simd.target = &flags.simd;
  simd.default_text = "the widest the processor has";
  simd.choices = {kSimdNames.begin(), kSimdNames.end()};
  Argument threads = fast_argument("--threads", "number of threads; 0 means one per core");
  threads.target = &flags.options.threads;
  threads.range = Interval<double>{0, 1024};
  return {multisample_argument(flags), filter, wrap, cull, simd, threads};
}

std::vector<Argument> truth_arguments(RenderFlags& flags) {
  return {
      {.names = "--truth",
       .target = &flags.truth,
       .meaning = "draw the exact tube instead of its mesh, at pixel centres (point) or averaged "
                  "over each pixel (area)",
       .value = "MODE",
       .choices = {"point", "area"},
       .when_alone = "point",
       .excludes = {"--fast"},
       .heading = "Exact tube"},
      {.names = "--tolerance",
       .target = &flags.truth_options.tolerance,
       .meaning = "estimated error per pixel of --truth area",
       .range = Interval<double>{1e-6, 1.0},
       .needs = "--truth",
       .heading = "Exact tube"}};
}

std::vector<Argument> render_arguments(RenderFlags& flags) {
  std::vector<Argument> all{scene_argument(flags.scene),
                            {.names = "-o,--output",
                             .target = &flags.output,
                             .meaning = "image to write: .exr (float) or .png (16 bits)",
                             .value = kFile,
                             .required = true}};
  append(all, output_arguments(flags.out));
  all.push_back({.names = "--fast",
                 .target = &flags.fast,
                 .meaning = "draw at full speed, in single instead of double precision",
                 .heading = kFastHeading});
  append(all, fast_arguments(flags));
  append(all, truth_arguments(flags));
  return all;
}

}  // namespace

Subcommand render_command() {
  const auto flags = std::make_shared<RenderFlags>();
  return {.name = "render",
          .group = Group::kDraw,
          .about = "Draw a scene with the software renderer",
          .arguments = render_arguments(*flags),
          .examples = {{"lumaknot render scene.json -o knot.exr"},
                       {"lumaknot render figure1-back -o back.png"},
                       {"lumaknot render --fast --multisample 8 --filter trilinear -o fast.png"},
                       {"lumaknot render figure2 --truth -o truth.exr"},
                       {"lumaknot render figure2 --truth area -o smooth.exr"}},
          .run = [flags] {
            run(*flags);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
