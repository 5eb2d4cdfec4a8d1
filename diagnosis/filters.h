/// What may be done to a finished picture.
#pragma once

#include "diagnosis/drawing.h"

namespace lumaknot::diagnosis {

/// The pixels of `grid` after the placement, if it is resampled, the blur and the median of
/// `picture`; `all` holds every pixel.
Drawn filtered(Drawn all, const PixelGrid& all_pixels, const PictureUse& picture,
               const PixelGrid& grid);

}  // namespace lumaknot::diagnosis
