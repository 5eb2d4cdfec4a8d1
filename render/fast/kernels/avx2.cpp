#include "render/fast/kernels/drawing.h"

namespace lumaknot::fast {

std::unique_ptr<Kernel> make_avx2_kernel(FrameData& data) {
  return std::unique_ptr<Kernel>(new PacketKernel<xsimd::fma3<xsimd::avx2>>(data));
}

}  // namespace lumaknot::fast
