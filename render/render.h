/// Our own images.
#pragma once

#include "render/rasterizer.h"
#include "scene/image.h"
#include "scene/progress.h"
#include "scene/scene.h"
#include "scene/shot.h"

namespace lumaknot {

/// The shot's colour where the fragment lies, in double. Black where nothing is seen.
Vec3d shade(const Scene& scene, const Shot& shot, const Fragment& fragment);

/// What every pixel's centre sees; `scene.view.image.samples` must be 1. On all cores.
Grid<Fragment> visible_fragments(const Scene& scene);

/// The shot drawn over fragments of `scene`, one a pixel. On all cores.
Image shade_all(const Scene& scene, const Shot& shot, const Grid<Fragment>& fragments);

/// A final shot put together, pixel by pixel, from images of its texture, diffuse and specular
/// stages that another renderer drew. All four have one size.
Image compose(const Scene& scene, const Shot& shot, const Image& texture, const Image& diffuse,
              const Image& specular);

/// The scene as it stands: its material, its samples, box filtered. On all cores; the same bytes
/// whatever their number.
Image render(const Scene& scene, const Progress& progress = {});

/// The same with all light and colour computed in half precision (shaders/half.h), as a fragment
/// shader of `mediump` may: positions and normals reach it rounded. Infinite and undefined colours
/// stay.
Image render_in_half(const Scene& scene, const Progress& progress = {});

}  // namespace lumaknot
