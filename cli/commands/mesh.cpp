#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command_table.h"
#include "cli/commands/knot_flags.h"
#include "cli/commands/mesh_report.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "exporters/mesh/format.h"
#include "meshgen/lean_grid.h"
#include "meshgen/tangents.h"
#include "scene/check.h"
#include "scene/json.h"
#include "scene/presets.h"
#include "system/error.h"
#include "system/listing.h"

namespace lumaknot::cli {
namespace {

using Json = nlohmann::ordered_json;

struct MeshFlags {
  std::shared_ptr<Json> knot = std::make_shared<Json>(Json::object());  ///< the flags given
  std::string output;
  MeshFileOptions file;
  std::optional<double> max_error;
  bool measure = false, strict = false;
  Output out;
};

/// Chooses the segments and sides with the fewest triangles within `max_error`.
void choose_grid(KnotSpec& knot, double max_error, const MeshFlags& flags) {
  if (flags.knot->contains("segments") || flags.knot->contains("sides")) {
    throw Error("--max-error can't be used with --segments or --sides, which it chooses");
  }
  check_number("--max-error", max_error, kPositive);
  if (has_fixed_winding(knot.convention) || knot.frames != FrameRule::kRotationMinimizing) {
    throw Error("--max-error needs exact rings; drop --frames, or --convention three or babylon");
  }
  const Spine spine(components(knot).front());
  const LeanGrid grid = lean_grid(TubeSurface(spine, knot.tube_radius), max_error,
                                  progress_bar(flags.out, "choosing a grid"));
  knot.segments = grid.segments;
  knot.sides = grid.sides;
  check_knot(knot, "--");
}

/// Warns if the tube passes through itself; an error with --strict.
void check_clearance(const KnotSpec& knot, const MeshFlags& flags) {
  const Clearance max = clearance(components(knot));
  if (knot.tube_radius <= max.radius) return;
  const std::string message =
      fmt::format("--tube {} passes through itself; it must be <= {:.6g}, where {}",
                  knot.tube_radius, max.radius, limit_text(max));
  if (flags.strict) throw Error(message);
  if (!flags.out.quiet) fmt::print(stderr, "lumaknot: warning: {}\n", message);
}

void report_mesh(const KnotSpec& knot, const TriangleMesh& mesh, const MeshFlags& flags) {
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
    throw Error("nothing to do; give --output FILE to write the mesh or --measure to measure it");
  }
  if (!flags.output.empty()) check_mesh_output(flags.output, flags.file, "--output");
  check_clearance(knot, flags);
  if (flags.max_error) choose_grid(knot, *flags.max_error, flags);
  TriangleMesh mesh = knot_mesh(knot);
  if (flags.file.tangents) mesh.tangents = tangents(mesh);
  if (!flags.output.empty()) write_mesh(flags.output, mesh, flags.file, "--output");
  report_mesh(knot, mesh, flags);
}

/// ".obj, .ply or .inc (POV-Ray)": all that can be written.
std::string written_files() {
  std::vector<std::string> files;
  for (const std::string& ending : mesh_endings(&MeshFormat::write)) {
    files.push_back(described_ending(ending, find_mesh_format(ending, &MeshFormat::write)->remark));
  }
  return listing(files, "or");
}

/// ".ply and .stl": the files that are text only when asked for it.
std::string files_with_a_choice() {
  const auto has_choice = [](const MeshFormat& f) { return f.has_text && f.has_binary; };
  return listing(mesh_endings(has_choice), "and");
}

std::vector<Argument> mesh_arguments(MeshFlags& flags) {
  const auto files_with = [](bool MeshFormat::* feature) {
    return fmt::format("{}", fmt::join(mesh_endings(feature), ", "));
  };
  std::vector<Argument> all{
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "mesh file to write: " + written_files(),
       .value = kFile},
      {.names = "--max-error",
       .target = &flags.max_error,
       .meaning = "use the fewest triangles within this distance of the exact tube",
       .range = kPositive,
       .checked = false},
      {.names = "--measure", .target = &flags.measure, .meaning = "report the mesh's properties"},
      {.names = "--strict",
       .target = &flags.strict,
       .meaning = "reject a tube that passes through itself"},
      {.names = "--ascii",
       .target = &flags.file.ascii,
       .meaning = fmt::format("write {} as text", files_with_a_choice())},
      {.names = "--quads",
       .target = &flags.file.quads,
       .meaning = fmt::format("keep quads ({})", files_with(&MeshFormat::has_quads))},
      {.names = "--tangents",
       .target = &flags.file.tangents,
       .meaning = fmt::format("add tangents for normal mapping ({})",
                              files_with(&MeshFormat::has_tangents))}};
  append(all, output_arguments(flags.out));
  append(all, knot_arguments(flags.knot));
  return all;
}

}  // namespace

Subcommand mesh_command() {
  const auto flags = std::make_shared<MeshFlags>();
  return {
      .name = "mesh",
      .group = Group::kMake,
      .about = "Write or measure the mesh of a (p,q) torus knot or link",
      .arguments = mesh_arguments(*flags),
      .notes = "The defaults shown are those of --convention lumaknot; the others have their own.",
      .examples = {{"lumaknot mesh --p 3 --q 5 --tube 0.1 -o knot.glb"},
                   {"lumaknot mesh --p 4 --q 6 -o link.obj", "a link of two components"},
                   {"lumaknot mesh --convention three -o three.ply", "three.js's vertices"},
                   {"lumaknot mesh --max-error 0.001 -o lean.ply", "the fewest triangles"},
                   {"lumaknot mesh --measure", "properties of the default mesh"}},
      .run = [flags] {
        run(*flags);
        return kExitAgreed;
      }};
}

}  // namespace lumaknot::cli
