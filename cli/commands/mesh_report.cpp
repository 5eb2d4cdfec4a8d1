#include "cli/commands/mesh_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/fields.h"

namespace lumaknot::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The sum of one count over all components.
long long total(const Certificate& c, long long ConnectedComponent::* count) {
  long long sum = 0;
  for (const ConnectedComponent& component : c.connected_components) sum += component.*count;
  return sum;
}

long long euler_characteristic(const Certificate& c) {
  long long sum = 0;
  for (const ConnectedComponent& component : c.connected_components)
    sum += component.euler_characteristic();
  return sum;
}

/// "0" if all components have genus 0, "1, 1, 2" if they differ.
std::string genera(const Certificate& c) {
  const long long first = c.connected_components.front().genus();
  const bool alike = std::ranges::all_of(
      c.connected_components,
      [&](const ConnectedComponent& component) { return component.genus() == first; });
  if (alike) return std::to_string(first);
  std::string text;
  for (const ConnectedComponent& component : c.connected_components) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", component.genus());
  }
  return text;
}

/// "1.4985, exact 1.5040 (-0.37 %)".
std::string compared(double measured, double exact) {
  return fmt::format("{:.7g}, exact {:.7g} ({:+.2g} %)", measured, exact,
                     100 * (measured / exact - 1));
}

std::string range(const Interval<double>& r) {
  return fmt::format("{:.4g} ... {:.4g}", r.min, r.max);
}

Json range_json(const Interval<double>& r) { return {{"least", r.min}, {"most", r.max}}; }

Json deviation_json(const Deviation& d) {
  return {{"chord", d.chord}, {"normal_degrees", d.normal_degrees}};
}

/// Rows of a name and a text.
class Table {
 public:
  void row(std::string_view name, const std::string& text) {
    text_ += fmt::format("\n  {:<21} {}", name, text);
  }
  std::string text_;
};

void add_counts(Table& table, const Certificate& c) {
  table.row("components", std::to_string(c.connected_components.size()));
  table.row("vertices", fmt::format("{}; {} in a file, with its seams",
                                    total(c, &ConnectedComponent::vertices), c.file_vertices));
  table.row("triangles", std::to_string(total(c, &ConnectedComponent::faces)));
  table.row("Euler characteristic", std::to_string(euler_characteristic(c)));
  table.row("genus", fmt::format("{} per component", genera(c)));
  table.row("boundary edges", std::to_string(total(c, &ConnectedComponent::boundary_edges)));
}

void add_sizes(Table& table, const KnotSpec& knot, const Certificate& c) {
  table.row("volume", compared(c.volume, c.exact_volume));
  table.row("area", compared(c.area, c.exact_area));
  table.row("length", fmt::format("{:.9g}", c.length));
  table.row("largest tube",
            fmt::format("{:.9g}, where {}", c.clearance.radius, limit_text(c.clearance)));
  table.row(
      "clearance",
      fmt::format("{:.6g}{}", c.clearance.radius - knot.tube_radius,
                  knot.tube_radius > c.clearance.radius ? ": the tube passes through itself" : ""));
}

void add_errors(Table& table, const Certificate& c) {
  table.row("holonomy", fmt::format("{:.6f} degrees", c.holonomy));
  table.row("twist", fmt::format("{:.6f} degrees per loop", c.twist));
  table.row("closing error", fmt::format("{:.2g} degrees", c.closing_error));
  table.row("ring tilt", fmt::format("at most {:.2g} degrees", c.ring_tilt));
  const auto bound = [&](double Deviation::* of) {
    return c.bound ? fmt::format(", bound {:.4g}", (*c.bound).*of) : "";
  };
  table.row("chord error",
            fmt::format("{:.4g} measured{}", c.measured.chord, bound(&Deviation::chord)));
  table.row("normal error", fmt::format("{:.4g} degrees measured{}", c.measured.normal_degrees,
                                        bound(&Deviation::normal_degrees)));
  table.row("texture stretch", fmt::format("{} along the centre line", range(c.stretch.along)));
  table.row("", fmt::format("{} along the surface", range(c.stretch.surface)));
  table.row("", fmt::format("{} around", range(c.stretch.around)));
}

}  // namespace

std::string limit_text(const Clearance& clearance) {
  if (clearance.bends) return fmt::format("the centre line bends at t = {:.4f}", clearance.t_a);
  if (clearance.component_a == clearance.component_b) {
    return fmt::format("strands pass at t = {:.4f} and {:.4f}", clearance.t_a, clearance.t_b);
  }
  return fmt::format("components {} and {} pass at t = {:.4f} and {:.4f}",
                     clearance.component_a + 1, clearance.component_b + 1, clearance.t_a,
                     clearance.t_b);
}

std::string certificate_table(const KnotSpec& knot, const Certificate& certificate) {
  Table table;
  table.text_ = fmt::format(
      "({},{}) torus {}, {} x {}, convention {}, frames {}", knot.p, knot.q,
      certificate.connected_components.size() > 1 ? "link" : "knot", knot.segments, knot.sides,
      kConventionNames[std::size_t(knot.convention)], kFrameNames[std::size_t(knot.frames)]);
  add_counts(table, certificate);
  add_sizes(table, knot, certificate);
  add_errors(table, certificate);
  return table.text_;
}

Json certificate_json(const KnotSpec& knot, const Certificate& c) {
  Json genus = Json::array();
  for (const ConnectedComponent& component : c.connected_components)
    genus.push_back(component.genus());
  return {
      {"p", knot.p},
      {"q", knot.q},
      {"segments", knot.segments},
      {"sides", knot.sides},
      {"components", c.connected_components.size()},
      {"vertices", c.file_vertices},
      {"sewn_vertices", total(c, &ConnectedComponent::vertices)},
      {"triangles", total(c, &ConnectedComponent::faces)},
      {"euler_characteristic", euler_characteristic(c)},
      {"genus", genus},
      {"boundary_edges", total(c, &ConnectedComponent::boundary_edges)},
      {"volume", c.volume},
      {"exact_volume", c.exact_volume},
      {"area", c.area},
      {"exact_area", c.exact_area},
      {"length", c.length},
      {"largest_tube", c.clearance.radius},
      {"largest_tube_limit", limit_text(c.clearance)},
      {"clearance", c.clearance.radius - knot.tube_radius},
      {"holonomy_degrees", c.holonomy},
      {"twist_degrees", c.twist},
      {"closing_error_degrees", c.closing_error},
      {"ring_tilt_degrees", c.ring_tilt},
      {"error_measured", deviation_json(c.measured)},
      {"error_bound", c.bound ? deviation_json(*c.bound) : Json()},
      {"texture_stretch",
       {{"along", range_json(c.stretch.along)},
        {"surface", range_json(c.stretch.surface)},
        {"around", range_json(c.stretch.around)}}},
  };
}

}  // namespace lumaknot::cli
