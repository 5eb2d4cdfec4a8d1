/// The regions, one file per chapter.
#pragma once

#include <vector>

#include "study/stability/region.h"

namespace lumaknot::stability {

std::vector<Region> frame_regions();
std::vector<Region> grid_regions();
std::vector<Region> texture_regions();
std::vector<Region> float_regions();
std::vector<Region> half_regions();
std::vector<Region> highlight_regions();
std::vector<Region> light_regions();
std::vector<Region> model_regions();
std::vector<Region> color_regions();
std::vector<Region> energy_regions();

/// All of them, in the page's order.
std::vector<Region> all_regions();

}  // namespace lumaknot::stability
