#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/terminal.h"
#include "exporters/mesh_file.h"
#include "meshgen/knot_mesh.h"
#include "meshgen/measure.h"
#include "scene/check.h"
#include "scene/fields.h"

namespace lumaknot {
namespace {

struct MeshFlags {
  KnotSpec knot;
  std::string output;
  Output out;
};

/// Makes a flag of every field of the knot.
struct FlagVisitor {
  CLI::App& command;

  template <class T>
  void add(std::string_view key, T& value, std::string_view about) {
    std::string flag = fmt::format("--{}", key);
    std::ranges::replace(flag, '_', '-');
    command.add_option(flag, value, std::string(about))->capture_default_str();
  }
  void integer(std::string_view key, int& value, IntRange, std::string_view about) {
    add(key, value, about);
  }
  void number(std::string_view key, double& value, Bound, std::string_view about) {
    add(key, value, about);
  }
};

void run(const MeshFlags& flags) {
  check_knot(flags.knot, "--");
  check_mesh_output(flags.output, {}, "--output");
  const ClosedMesh closed = knot_mesh(flags.knot);
  const TriangleMesh mesh = flat_mesh(closed);
  write_mesh(flags.output, mesh, {}, "--output");
  if (flags.out.json) {
    const nlohmann::ordered_json json{{"output", flags.output},
                                      {"vertices", mesh.positions.size()},
                                      {"triangles", mesh.triangles.size()},
                                      {"genus", genus(closed)},
                                      {"boundary_edges", boundary_edges(closed)},
                                      {"volume", volume(closed)}};
    fmt::print("{}\n", json.dump(2));
  }
  flags.out.say(fmt::format("{}: {} vertices, {} triangles", flags.output, mesh.positions.size(),
                            mesh.triangles.size()));
}

}  // namespace

void add_mesh_command(CLI::App& program) {
  auto flags = std::make_shared<MeshFlags>();
  CLI::App* command = program.add_subcommand("mesh", "Write the mesh of a (p,q) torus knot");
  FlagVisitor visitor{*command};
  visit_fields(visitor, flags->knot);
  command->add_option("-o,--output", flags->output, "the mesh file: .obj or .ply")->required();
  add_output_flags(*command, flags->out);
  command->footer(
      "Examples:\n"
      "  lumaknot mesh --p 2 --q 3 --segments 768 --sides 40 -o knot.obj\n"
      "  lumaknot mesh --p 3 --q 5 --tube 0.1 --repeat-u 16 -o knot.ply");
  command->callback([flags] { run(*flags); });
}

}  // namespace lumaknot
