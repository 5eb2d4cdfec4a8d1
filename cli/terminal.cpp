#include "cli/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace lumaknot::cli {

void Output::say(const std::string& line) const {
  if (!quiet && !json) fmt::print("{}\n", line);
}

std::function<void(double)> progress_bar(const Output& output, std::string label) {
  using Clock = std::chrono::steady_clock;
  if (output.quiet || !isatty(STDERR_FILENO)) return {};
  return [label = std::move(label), start = Clock::now()](double share) {
    if (Clock::now() - start < std::chrono::seconds(1)) return;
    constexpr int kWidth = 40;
    const int filled = int(share * kWidth);
    fmt::print(stderr, "\r{} [{:<{}}] {:3.0f} %", label, std::string(std::size_t(filled), '='),
               kWidth, 100 * share);
    if (share >= 1) fmt::print(stderr, "\n");
    std::fflush(stderr);
  };
}

}  // namespace lumaknot::cli
