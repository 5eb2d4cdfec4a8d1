/// A table of frame rates as text, JSON and a picture.
#pragma once

#include <string>

#include "study/bench/frame_rates.h"

namespace lumaknot::bench {

/// A row of the paper's Table 2.
struct PaperRow {
  std::string_view machine;
  int side = 720, samples = 1;
  double classical = 0, yiq = 0;  ///< frames per second
};

/// The paper's Table 2.
std::span<const PaperRow> paper_rows();

/// Text for a terminal: frames per second and what YIQ costs, the paper's rows below ours.
std::string rates_text(const RateTable& table);

/// JSON, two spaces deep, ending in a newline.
std::string rates_json(const RateTable& table);

/// A bar chart as SVG: each row's classical and YIQ frames per second, the paper's among them.
std::string rates_svg(const RateTable& table);

}  // namespace lumaknot::bench
