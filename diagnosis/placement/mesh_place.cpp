/// A mesh that was moved.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> mesh_place(const Situation& situation) {
  const double step = 0.003 * situation.extent;
  return {{.id = "mesh-moved",
           .rung = Rung::kPlacement,
           .parameters = {{"x", 0, step}, {"y", 0, step}, {"z", 0, step}},
           .apply =
               [](Setup& s, std::span<const double> p) {
                 change_mesh(s, [by = Vec3d{p[0], p[1], p[2]}](TriangleMesh& mesh) {
                   for (Vec3d& position : mesh.positions) position = position + by;
                 });
               },
           .sentence =
               [](std::span<const double> p) {
                 return "the mesh moved by " + point({p[0], p[1], p[2]});
               }}};
}

}  // namespace lumaknot::diagnosis
