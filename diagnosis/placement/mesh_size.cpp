/// A mesh of another scale.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> mesh_size(const Situation&) {
  Hypothesis h = continuous("mesh-scale", Rung::kPlacement, {"scale", 1, 0.005, 1e-6, 1e6},
                            "the mesh {:.4g} times as large", [](Setup& s, double scale) {
                              change_mesh(s, [scale](TriangleMesh& mesh) {
                                for (Vec3d& p : mesh.positions) p = p * scale;
                              });
                            });
  h.starts = {{1}, {0.7}, {1.4}, {0.5}, {2}, {0.35}, {2.8}};
  return {h};
}

}  // namespace lumaknot::diagnosis
