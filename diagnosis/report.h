/// A diagnosis for people and for programs.
#pragma once

#include <string>

#include "diagnosis/diagnose.h"

namespace lumaknot::diagnosis {

/// Lines, the last without a newline: the cause, what can't be told apart from it, and what the
/// file says; `name` is the picture's.
std::string report_text(const Diagnosis& diagnosis, const std::string& name);

/// An object of JSON: verdict ("agrees", "named" or "unknown"), causes, equivalents, nearest,
/// facts, as_given, residual.
std::string report_json(const Diagnosis& diagnosis);

}  // namespace lumaknot::diagnosis
