/// The atlas as text, JSON and a page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/stability/atlas.h"
#include "study/stability/energy.h"

namespace lumaknot::stability {

struct Atlas {
  std::vector<Entry> entries;
  std::vector<Energy> energies;
};

/// A table for a terminal: a line per region, then the energies.
std::string atlas_text(const Atlas& atlas);

/// JSON with the program's version, two spaces deep, ending in a newline. What is not a number
/// is null.
std::string atlas_json(const Atlas& atlas);

/// The atlas that atlas_json() wrote, its pictures read from `folder`/NAME/; a region with a
/// missing picture is left out. Throws Error, calling the text `label`, if it is not an atlas or by
/// another version of the program.
Atlas read_atlas(const std::string& json, const std::filesystem::path& folder,
                 std::string_view label);

/// One HTML page that needs nothing else.
std::string atlas_html(const Atlas& atlas);

/// "holds again from 150 to 1000": the swept values beyond the boundary that do, rounded into
/// their intervals; empty if none does.
std::string again_text(const Entry& entry);

/// "0.38 -> 0.37", the boundary from holding to failing: each side rounded away from the other,
/// with enough digits to stay between them.
std::string boundary_text(const Boundary& boundary);

}  // namespace lumaknot::stability
