/// The kernel for the instruction set `A`.
#pragma once

#include "render/fast/kernel.h"
#include "render/fast/kernels/lists.h"
#include "render/fast/kernels/tile.h"
#include "render/fast/kernels/vertices.h"

namespace lumaknot::fast {

template <class A>
class PacketKernel final : public Kernel {
 public:
  explicit PacketKernel(FrameData& data) : data_(data), lighting_(packed<A>(data.lighting)) {}

  bool transform(std::size_t begin, std::size_t end) override {
    return transform_vertices<A>(data_, begin, end);
  }
  void light(std::size_t begin, std::size_t end) override {
    light_vertices<A>(data_, lighting_, begin, end);
  }
  void list(Run& run) override {
    run.found = 0;
    find_candidates<A>(data_, run, run.first, run.last);
  }
  void draw(int tile, TileMemory& memory) override {
    TilePainter<A>(data_, lighting_, memory, tile).paint(tile);
  }

 private:
  FrameData& data_;
  Lighting<Floats<A>> lighting_;
};

}  // namespace lumaknot::fast
