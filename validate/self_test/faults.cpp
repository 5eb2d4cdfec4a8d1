#include "validate/self_test/faults.h"

#include "validate/self_test/planting.h"

namespace lumaknot::validate {

std::vector<Fault> planted_faults(const Scene& scene, const KnotSpec* knot) {
  Faults all;
  add_color_faults(all);
  add_place_faults(all);
  add_foreign_faults(all);
  add_placement_faults(all, scene, knot);
  add_surface_faults(all, scene);
  add_light_faults(all, scene);
  return all;
}

}  // namespace lumaknot::validate
