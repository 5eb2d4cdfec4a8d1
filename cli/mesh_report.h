/// A knot's certificate, told.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "meshgen/certificate.h"

namespace lumaknot {

/// The certificate as a table for people, without a newline at its end.
std::string certificate_table(const KnotSpec& knot, const Certificate& certificate);

/// The certificate for programs: lengths in scene units, angles in degrees.
nlohmann::ordered_json certificate_json(const KnotSpec& knot, const Certificate& certificate);

/// What keeps the tube from growing to `clearance` and beyond: "the centre line bends", ...
std::string limit_text(const Clearance& clearance);

}  // namespace lumaknot
