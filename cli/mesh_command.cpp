#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/knot_flags.h"
#include "cli/mesh_report.h"
#include "cli/terminal.h"
#include "exporters/mesh_file.h"
#include "meshgen/lean_grid.h"
#include "meshgen/tangents.h"
#include "scene/check.h"
#include "scene/error.h"
#include "scene/presets.h"
#include "scene/scene_json.h"

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;

struct MeshFlags {
  std::shared_ptr<Json> knot;
  std::string output;
  MeshFileOptions file;
  std::optional<double> max_error;
  bool measure = false, strict = false;
  Output out;
};

/// The grid of fewest triangles, instead of segments and sides.
void choose_grid(KnotSpec& knot, const MeshFlags& flags) {
  if (flags.knot->contains("segments") || flags.knot->contains("sides")) {
    throw Error("--max-error chooses --segments and --sides: leave them out");
  }
  check_number("--max-error", *flags.max_error, kPositive);
  if (has_fixed_winding(knot.convention) || knot.frames != FrameRule::kRotationMinimizing) {
    throw Error(
        "--max-error needs rings that are exact: leave out --frames, and --convention three "
        "or babylon");
  }
  const Spine spine(components(knot).front());
  const LeanGrid grid = lean_grid(TubeSurface(spine, knot.tube_radius), *flags.max_error,
                                  progress_bar(flags.out, "choosing a grid"));
  knot.segments = grid.segments;
  knot.sides = grid.sides;
  check_knot(knot, "--");
}

/// Says when the tube passes through itself, or refuses it.
void check_clearance(const KnotSpec& knot, const MeshFlags& flags) {
  const Clearance most = clearance(components(knot));
  if (knot.tube_radius <= most.radius) return;
  const std::string message =
      fmt::format("--tube {} passes through itself; it must be <= {:.6g}, where {}",
                  knot.tube_radius, most.radius, limit_text(most));
  if (flags.strict) throw Error(message);
  if (!flags.out.quiet) fmt::print(stderr, "lumaknot: warning: {}\n", message);
}

void tell(const KnotSpec& knot, const TriangleMesh& mesh, const MeshFlags& flags) {
  Json json = Json::object();
  if (!flags.output.empty()) {
    json.update({{"output", flags.output},
                 {"vertices", mesh.positions.size()},
                 {"triangles", mesh.triangles.size()}});
    flags.out.say(fmt::format("{}: {} vertices, {} triangles", flags.output, mesh.positions.size(),
                              mesh.triangles.size()));
  }
  if (flags.measure) {
    const Certificate certificate = certify(knot, mesh);
    json.update(certificate_json(knot, certificate));
    flags.out.say(certificate_table(knot, certificate));
  }
  if (flags.out.json) fmt::print("{}\n", json.dump(2));
}

void run(const MeshFlags& flags) {
  KnotSpec knot = knot_from_json(*flags.knot, "--");
  if (flags.output.empty() && !flags.measure) {
    throw Error("--output is needed: where to write the mesh; or --measure, to measure it");
  }
  if (!flags.output.empty()) check_mesh_output(flags.output, flags.file, "--output");
  check_clearance(knot, flags);
  if (flags.max_error) choose_grid(knot, flags);
  TriangleMesh mesh = knot_mesh(knot);
  if (flags.file.tangents) mesh.tangents = tangents(mesh);
  if (!flags.output.empty()) write_mesh(flags.output, mesh, flags.file, "--output");
  tell(knot, mesh, flags);
}

}  // namespace

void add_mesh_command(CLI::App& program) {
  auto flags = std::make_shared<MeshFlags>();
  CLI::App* command =
      program.add_subcommand("mesh", "Write or measure the mesh of a (p,q) torus knot or link");
  flags->knot = add_knot_flags(*command);
  command->add_option("--max-error", flags->max_error,
                      "the fewest triangles within this distance of the exact tube");
  command->add_flag("--measure", flags->measure, "tell what is true of the mesh");
  command->add_flag("--strict", flags->strict, "refuse a tube that passes through itself");
  command->add_option("-o,--output", flags->output,
                      "the mesh file: .obj .ply .stl .off .om .glb .gltf .inc");
  command->add_flag("--ascii", flags->file.ascii, ".ply and .stl as text");
  command->add_flag("--quads", flags->file.quads, "keep quads: .obj .ply .off");
  command->add_flag("--tangents", flags->file.tangents, "tangents for normal mapping: .glb .gltf");
  add_output_flags(*command, flags->out);
  command->footer(
      "Defaults are lumaknot's; other conventions have their own.\n"
      "Examples:\n"
      "  lumaknot mesh --p 3 --q 5 --tube 0.1 -o knot.glb\n"
      "  lumaknot mesh --p 4 --q 6 -o link.obj                     a link of 2 components\n"
      "  lumaknot mesh --p 2 --q 3 --convention three -o three.ply three.js's vertices\n"
      "  lumaknot mesh --max-error 0.001 -o lean.ply               the fewest triangles\n"
      "  lumaknot mesh --measure                                   what is true of the default");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
