#include <fmt/format.h>
#include <gtest/gtest.h>
#include <chrono>
#include "study/stability/atlas.h"
#include "study/stability/regions.h"
namespace lumaknot {
TEST(Survey, all) {
  for (const Region& r : all_regions()) {
    const auto t = std::chrono::steady_clock::now();
    std::string line;
    try {
      const Entry e = examine(r, {.pictures = false}, [](double) {});
      line = fmt::format("{:.7g} {:.7g} | {:.4g} {:.4g} limit {:.4g} guard {:.4g}", e.boundary.holds.x, e.boundary.fails.x, e.boundary.holds.error, e.boundary.fails.error, r.limit, e.guarded_worst);
    } catch (const std::exception& ex) {
      line = ex.what();
      for (double x : swept_values(r.sweep, 10)) { try { line += fmt::format("\n    {:.5g}: {:.5g} {:.5g}", x, r.error(x), r.guarded ? r.guarded(x) : -1);} catch (const std::exception& e2) { line += fmt::format("\n {:.5g} {}", x, e2.what()); } }
    }
    fmt::print("{:28} {} [{:.1f}s]\n", r.name, line, std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count());
    std::fflush(stdout);
  }
}
}
