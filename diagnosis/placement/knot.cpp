/// Another knot, or one of another resolution.
#include <fmt/format.h>

#include "diagnosis/cause.h"
#include "system/error.h"

namespace lumaknot::diagnosis {

namespace {

/// The mesh of `knot`; empty if there is none, as of a tube that is thicker than its knot.
std::shared_ptr<const TriangleMesh> mesh_of(const KnotSpec& knot) {
  try {
    return std::make_shared<const TriangleMesh>(knot_mesh(knot));
  } catch (const Error&) {
    return std::make_shared<const TriangleMesh>();
  }
}

Hypothesis other_knot(std::string id, std::string sentence, const KnotSpec& knot) {
  return discrete(std::move(id), Rung::kPlacement, std::move(sentence),
                  [knot](Setup& s) { s.mesh = mesh_of(knot); });
}

Hypothesis with(const KnotSpec& own, int p, int q) {
  KnotSpec knot = own;
  knot.p = p;
  knot.q = q;
  return other_knot(fmt::format("knot-{}-{}", p, q),
                    fmt::format("the ({}, {}) knot, not the ({}, {})", p, q, own.p, own.q), knot);
}

Hypothesis with_grid(const KnotSpec& own, int segments, int sides) {
  KnotSpec knot = own;
  knot.segments = segments;
  knot.sides = sides;
  return other_knot(
      fmt::format("grid-{}x{}", segments, sides),
      fmt::format("a mesh of {} x {}, not {} x {}", segments, sides, own.segments, own.sides),
      knot);
}

/// One length of the knot, fitted.
Hypothesis length_of(const KnotSpec& own, const std::string& name, double KnotSpec::* member) {
  const double start = own.*member;
  return {.id = name,
          .rung = Rung::kPlacement,
          .parameters = {{name, start, 0.01 * start, 0.05 * start, 20 * start}},
          .apply =
              [own, member](Setup& s, std::span<const double> p) {
                KnotSpec knot = own;
                knot.*member = p[0];
                s.mesh = mesh_of(knot);
              },
          .sentence =
              [name, start](std::span<const double> p) {
                return fmt::format("{} {}, not {}", name, number(p[0]), number(start));
              }};
}

}  // namespace

std::vector<Hypothesis> knot(const Situation& situation) {
  if (!situation.knot) return {};
  const KnotSpec& own = *situation.knot;
  std::vector<Hypothesis> all{length_of(own, "tube_radius", &KnotSpec::tube_radius),
                              length_of(own, "minor_radius", &KnotSpec::minor_radius),
                              length_of(own, "major_radius", &KnotSpec::major_radius)};
  if (own.p != own.q) all.push_back(with(own, own.q, own.p));
  for (const int step : {-1, 1}) {
    if (own.p + step > 0) all.push_back(with(own, own.p + step, own.q));
    if (own.q + step > 0) all.push_back(with(own, own.p, own.q + step));
  }
  all.push_back(with(own, own.p, -own.q));
  for (const int divisor : {2, 4}) {
    if (own.segments / divisor < 3 || own.sides / divisor < 3) continue;
    all.push_back(with_grid(own, own.segments / divisor, own.sides));
    all.push_back(with_grid(own, own.segments, own.sides / divisor));
    all.push_back(with_grid(own, own.segments / divisor, own.sides / divisor));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
