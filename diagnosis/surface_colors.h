/// The colours of points of the surface.
#pragma once

#include "diagnosis/drawing.h"

namespace lumaknot::diagnosis {

/// What the setup shows at each fragment, before anything is done to the picture's colours.
Drawn surface_colors(const Setup& setup, const Grid<Fragment>& fragments);

}  // namespace lumaknot::diagnosis
