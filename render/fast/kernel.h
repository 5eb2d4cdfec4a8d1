/// The steps of a frame that work in packets, one implementation per instruction set.
#pragma once

#include <memory>

#include "render/fast/frame_data.h"

namespace lumaknot::fast {

class Kernel {
 public:
  virtual ~Kernel() = default;

  /// Projects vertices [begin, end) of the mesh onto the image. Returns whether all are in front of
  /// the near plane and within the guard.
  virtual bool transform(std::size_t begin, std::size_t end) = 0;
  /// Computes the lighting terms of vertices [begin, end).
  virtual void light(std::size_t begin, std::size_t end) = 0;
  /// Fills the run's lists.
  virtual void list(Run& run) = 0;
  /// Draws a tile into the picture.
  virtual void draw(int tile, TileMemory& memory) = 0;
};

/// `data` must not move; its mesh, camera, material and lights are read now.
std::unique_ptr<Kernel> make_baseline_kernel(FrameData& data);
std::unique_ptr<Kernel> make_avx2_kernel(FrameData& data);
std::unique_ptr<Kernel> make_avx512_kernel(FrameData& data);

}  // namespace lumaknot::fast
