/// Antialiasing, blur, denoising.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

Hypothesis averaged(int n, double width, std::string id, std::string sentence) {
  Hypothesis h =
      discrete(std::move(id), Rung::kEncoding, std::move(sentence), [n, width](Setup& s) {
        s.picture.samples = n;
        s.picture.filter = width;
      });
  h.costly = true;
  return h;
}

}  // namespace

std::vector<Hypothesis> sharpness(const Situation&) {
  std::vector<Hypothesis> all;
  for (const int n : {2, 3, 4, 8}) {
    all.push_back(averaged(n, 1, fmt::format("antialiased-{}", n),
                           fmt::format("{} x {} samples per pixel", n, n)));
  }
  Hypothesis blur = continuous("blur", Rung::kEncoding, {"sigma", 0.5, 0.02, 0.2, 20},
                               "a Gaussian blur of {:.3g} pixels",
                               [](Setup& s, double sigma) { s.picture.blur = sigma; });
  blur.starts = {{0.5}, {1}, {2}};
  blur.costly = true;
  Hypothesis denoised = discrete("median", Rung::kEncoding, "a median filter of 3 x 3 pixels",
                                 [](Setup& s) { s.picture.median = 1; });
  denoised.costly = true;
  all.push_back(blur);
  all.push_back(denoised);
  return all;
}

}  // namespace lumaknot::diagnosis
