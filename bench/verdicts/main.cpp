// lumaknot_bench_verdicts agreeing SCENES RENDERERS [SEED]   random scenes: is anyone accused?
// lumaknot_bench_verdicts pairs COUNT [SEED] [--8]           two faults at once: are both named?
// RENDERERS are flags of lumaknot validate, with commas. Exit code 1: a verdict was false.
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>

#include "bench/verdicts/agreeing.h"
#include "bench/verdicts/pairs.h"

namespace lumaknot::verdicts {
namespace {

constexpr int kExitFalse = 1, kExitBadUsage = 2;

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts{""};
  for (const char c : list) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

int agreeing(long long scenes, const std::string& renderers, std::uint64_t seed) {
  bool all_right = true;
  fmt::print(
      "| renderer | scenes | skipped | failed | differed | explained | pictures | known | accused "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const AgreeingCounts& c : count_agreeing(scenes, seed, split(renderers))) {
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", c.renderer, c.scenes, c.skipped,
               c.failed, c.differed, c.explained, c.diagnosed, c.known, c.accused);
    all_right = all_right && c.differed == 0 && c.accused == 0 && c.failed == 0;
  }
  return all_right ? 0 : kExitFalse;
}

int pairs(long long count, std::uint64_t seed, bool eight_bits) {
  const PairCounts c = count_pairs(count, seed, eight_bits);
  fmt::print("{} pairs, {}: both named {}, named wrongly {}, unknown {}; {:.1f} s each\n", c.pairs,
             eight_bits ? "8 bits" : "float", c.both_named, c.wrong, c.unknown,
             c.seconds / double(c.pairs));
  return c.wrong == 0 ? 0 : kExitFalse;
}

int run(int argc, char** argv) {
  const auto is = [&](int i, const char* word) { return argc > i && !std::strcmp(argv[i], word); };
  const auto number = [&](int i, long long otherwise) {
    return argc > i ? std::atoll(argv[i]) : otherwise;
  };
  if (is(1, "agreeing") && argc > 3) {
    return agreeing(number(2, 1), argv[3], std::uint64_t(number(4, 1)));
  }
  if (is(1, "pairs") && argc > 2) {
    return pairs(number(2, 1), std::uint64_t(number(3, 1)), is(argc - 1, "--8"));
  }
  fmt::print(stderr,
             "usage: lumaknot_bench_verdicts agreeing SCENES RENDERERS [SEED]\n"
             "       lumaknot_bench_verdicts pairs COUNT [SEED] [--8]\n");
  return kExitBadUsage;
}

}  // namespace
}  // namespace lumaknot::verdicts

int main(int argc, char** argv) { return lumaknot::verdicts::run(argc, argv); }
