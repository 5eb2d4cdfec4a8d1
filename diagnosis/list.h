/// The causes, in order: each is a function of this name, in a file of this name.
#pragma once

#define LUMAKNOT_CAUSES(CAUSE)                                                              \
  CAUSE(shift)                                                                              \
  CAUSE(mirror)                                                                             \
  CAUSE(fov)                                                                                \
  CAUSE(camera)                                                                             \
  CAUSE(aspect) CAUSE(mesh_size) CAUSE(mesh_place) CAUSE(mesh_axes) CAUSE(knot) CAUSE(size) \
      CAUSE(normals) CAUSE(frequency) CAUSE(texture_direction) CAUSE(texture_tiles)         \
          CAUSE(texture_filter) CAUSE(texture_color) CAUSE(texture_missing) CAUSE(lamp)     \
              CAUSE(falloff) CAUSE(extra_light) CAUSE(weights) CAUSE(model) CAUSE(space)    \
                  CAUSE(shadow) CAUSE(gamma) CAUSE(exposure) CAUSE(hue) CAUSE(tone_curve)   \
                      CAUSE(channels) CAUSE(range) CAUSE(coverage) CAUSE(sharpness)
