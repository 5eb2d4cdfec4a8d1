/// The reference renderer: our own images.
#pragma once

#include "render/rasterizer.h"
#include "scene/image.h"
#include "scene/shot.h"
#include "scene/spec.h"
#include "system/progress.h"

namespace lumaknot {

/// The shot's colour where the fragment lies, in double. Black where nothing is seen.
Vec3d shade(const Scene& scene, const Shot& shot, const Fragment& fragment);

/// The fragment at every pixel's centre; `scene.view.image.samples` must be 1. On all cores.
Grid<Fragment> visible_fragments(const Scene& scene);

/// The shot drawn over fragments of `scene`, one per pixel. On all cores.
Image shade_all(const Scene& scene, const Shot& shot, const Grid<Fragment>& fragments);

/// A final shot composed, pixel by pixel, from images of its texture, diffuse and specular stages
/// that another renderer drew. All four have the same size.
Image compose(const Scene& scene, const Shot& shot, const Image& texture, const Image& diffuse,
              const Image& specular);

/// The scene as given: its material and its samples, box filtered. On all cores; the same bytes
/// whatever their number.
Image render(const Scene& scene, const Progress& progress = {});

/// The same with all light and colour computed in half precision (shaders/graph/half.h), as a
/// `mediump` fragment shader may: positions and normals arrive rounded. Infinite and undefined
/// colours are kept.
Image render_in_half(const Scene& scene, const Progress& progress = {});

}  // namespace lumaknot
