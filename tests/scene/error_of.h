/// What a call has to say when it refuses.
#pragma once

#include <string>

#include "scene/error.h"

namespace lumaknot {

/// The message of the Error that `call` throws; empty when it throws none.
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
