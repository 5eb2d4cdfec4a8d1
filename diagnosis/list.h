/// The causes, in order: each is a function of this name, in a file of this name.
#pragma once

// clang-format off
#define LUMAKNOT_CAUSES(CAUSE) \
  /* placement */ CAUSE(shift) CAUSE(mirror) CAUSE(fov) CAUSE(camera) CAUSE(aspect) \
    CAUSE(mesh_size) CAUSE(mesh_place) CAUSE(mesh_axes) CAUSE(knot) CAUSE(size) \
  /* surface */ CAUSE(normals) CAUSE(frequency) \
  /* texture */ CAUSE(uv_direction) CAUSE(tiles) CAUSE(texel_filter) CAUSE(texel_color) \
    CAUSE(untextured) \
  /* light */ CAUSE(lamp) CAUSE(falloff) CAUSE(extra_lamp) CAUSE(weights) CAUSE(model) \
    CAUSE(space) CAUSE(shadow) \
  /* encoding */ CAUSE(gamma) CAUSE(exposure) CAUSE(hue) CAUSE(primaries) CAUSE(tone_curve) \
    CAUSE(channels) CAUSE(range) CAUSE(coverage) CAUSE(sharpness)
// clang-format on
