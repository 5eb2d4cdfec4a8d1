#include "render/fast/kernels/drawing.h"

namespace lumaknot::fast {

std::unique_ptr<Kernel> make_avx512_kernel(FrameData& data) {
  return std::unique_ptr<Kernel>(new PacketKernel<xsimd::avx512bw>(data));
}

}  // namespace lumaknot::fast
