/// The page's matrix of renderers and stages, and what its scripts need to show a cell large.
#pragma once

#include <string>

#include "validate/report/page_kit.h"
#include "validate/run.h"

namespace lumaknot::validate {

/// How a shot is called on the page: a final by its name, a stage as "texture alone".
std::string shot_title(const Shot& shot);

/// Sets the matrix' `stages`, `own_cells` and `rows` on `page`.
void set_matrix(const Validation& validation, PageData& page);

/// What the scripts read, as JSON that may stand in a script element.
std::string viewer_json(const Validation& validation);

}  // namespace lumaknot::validate
