/// Reports of a knot's certificate.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "meshgen/certificate.h"

namespace lumaknot::cli {

/// The certificate as a human-readable table, without a trailing newline.
std::string certificate_table(const KnotSpec& knot, const Certificate& certificate);

/// The certificate as JSON: lengths in scene units, angles in degrees.
nlohmann::ordered_json certificate_json(const KnotSpec& knot, const Certificate& certificate);

/// What keeps the tube from growing beyond `clearance`: "the centre line bends", ...
std::string limit_text(const Clearance& clearance);

}  // namespace lumaknot::cli
