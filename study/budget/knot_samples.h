/// Points of a knot's mesh and of its exact tube, each with the normals of both.
#pragma once

#include <vector>

#include "meshgen/knot_mesh.h"
#include "render/exact/tube.h"

namespace lumaknot::budget {

/// A sample's fragment with its parameters on the tube.
struct KnotSample {
  Fragment seen;            ///< the normal as interpolated between the mesh's vertices
  double t = 0, theta = 0;  ///< radians
};

/// The grid of a knot's mesh as a map of its parameters.
class KnotGrid {
 public:
  /// `mesh` is knot_mesh(knot), kept by reference.
  KnotGrid(const KnotSpec& knot, const TriangleMesh& mesh);

  /// A fragment of the mesh.
  KnotSample of_mesh(const Fragment& fragment) const;

  /// A fragment of the exact tube, its normal as the mesh interpolates it there.
  KnotSample of_tube(const exact::ExactFragment& fragment) const;

  /// The exact normal at the sample's parameters.
  Vec3d exact_normal(const KnotSample& sample) const;

  /// The exact tube's point there.
  Vec3d exact_position(const KnotSample& sample) const;

 private:
  RingFrame frame_of(const KnotSample& sample) const;
  Vec3d interpolated_normal(std::size_t component, double t, double theta) const;

  KnotSpec knot_;
  const TriangleMesh& mesh_;
  GridLayout layout_;
  std::vector<Spine> spines_;
};

}  // namespace lumaknot::budget
