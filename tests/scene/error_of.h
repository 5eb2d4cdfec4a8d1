/// The message of a call that refuses.
#pragma once

#include <string>

#include "system/error.h"

namespace lumaknot {

/// The message of the Error that `call` throws; empty if none.
template <class F>
std::string error_of(F call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace lumaknot
