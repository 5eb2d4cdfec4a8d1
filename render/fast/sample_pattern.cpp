#include "render/fast/sample_pattern.h"

namespace lumaknot::fast {

std::span<const SamplePlace> sample_pattern(int samples) {
  static constexpr SamplePlace k1[] = {{0, 0}};
  static constexpr SamplePlace k2[] = {{4, 4}, {-4, -4}};
  static constexpr SamplePlace k4[] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
  static constexpr SamplePlace k6[] = {{-7, -1}, {-4, 6}, {-1, -4}, {1, 4}, {4, -6}, {7, 1}};
  static constexpr SamplePlace k8[] = {{1, -3}, {-1, 3},  {5, 1}, {-3, -5},
                                       {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
  static constexpr SamplePlace k16[] = {{1, 1},  {-1, -3}, {-3, 2}, {4, -1}, {-5, -2}, {2, 5},
                                        {5, 3},  {3, -5},  {-2, 6}, {0, -7}, {-4, -6}, {-6, 4},
                                        {-8, 0}, {7, -4},  {6, 7},  {-7, -8}};
  for (const std::span<const SamplePlace> pattern :
       {std::span<const SamplePlace>(k1), {k2}, {k4}, {k6}, {k8}, {k16}}) {
    if (pattern.size() == std::size_t(samples)) return pattern;
  }
  return {};
}

}  // namespace lumaknot::fast
