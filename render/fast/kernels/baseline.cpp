#include "render/fast/kernels/drawing.h"

namespace lumaknot::fast {

std::unique_ptr<Kernel> make_baseline_kernel(FrameData& data) {
  return std::unique_ptr<Kernel>(new PacketKernel<xsimd::default_arch>(data));
}

}  // namespace lumaknot::fast
