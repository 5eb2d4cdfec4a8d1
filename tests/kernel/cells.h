/// The cells that kernel runs cover: each formula, at each rate, and its variants by scene.
#pragma once

#include <string>
#include <vector>

#include "shaders/graph/shader.h"
#include "shaders/languages/backend.h"

namespace lumaknot::testing {

/// One shader to run.
struct KernelCell {
  std::string formula, variant;
  ShaderJob job;
};

/// The prefixes of formulas, a space and how it is used: "rgb", "yiq-table1", ...
std::vector<std::string> space_uses();

/// The cell of a formula at rate pixel, all its numbers parameters.
KernelCell plain_cell(const std::string& formula);

/// The cells of a space. Every model at rate pixel, and where `vertex_stage` says so at rate
/// vertex; and each variant with some of the models, so that over all spaces each variant meets
/// each model twice. Gamuts act on the space alone and lights on the model alone.
std::vector<KernelCell> cells_of(const std::string& space_use, bool vertex_stage);

/// "glsl_330_yiq_table1": the language and the space as the name of a test.
std::string cell_test_name(Language language, const std::string& space_use);

}  // namespace lumaknot::testing
