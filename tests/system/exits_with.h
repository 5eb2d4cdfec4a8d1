/// Exit codes of programs in tests: failures print what the program said.
#pragma once

#include <gmock/gmock.h>

#include "system/process.h"

namespace lumaknot {

/// How failed expectations print a result.
inline void PrintTo(const ProcessResult& result, std::ostream* stream) {
  *stream << "exit code " << result.exit_code
          << (result.timed_out ? ", killed at its deadline" : "") << ", after printing:\n"
          << result.log;
}

// NOLINTNEXTLINE(readability-identifier-naming): as gMock's own are
MATCHER_P(ExitsWith, code, "") { return arg.exit_code == code && !arg.timed_out; }

}  // namespace lumaknot
