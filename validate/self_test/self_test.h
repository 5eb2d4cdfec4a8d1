/// Plants faults and proves that each is noticed and named, and that nothing else is accused.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "meshgen/knot_mesh.h"
#include "scene/spec.h"
#include "system/progress.h"
#include "validate/renderers/programs.h"
#include "validate/self_test/faults.h"

namespace lumaknot::validate {

struct SelfTestJob {
  Scene scene;
  std::optional<KnotSpec> knot;        ///< what its mesh was made from
  std::vector<std::string> renderers;  ///< flags: they draw the faults of scenes, and their own
  Programs programs;
  std::vector<std::string> only = {};  ///< plant the faults with these causes; empty: all
};

/// A picture with a planted fault, or with none.
struct PlantedResult {
  std::string fault = {};     ///< in words; empty: none was planted
  std::string drawn_by = {};  ///< "lumaknot" or a renderer
  std::string values = {};    ///< "float" or "8 bits"
  bool changes = true;        ///< some pixel; otherwise there is nothing to notice
  bool noticed = false;       ///< the comparison does not agree
  std::string expected = {};  ///< the cause's id; "unknown" of what no cause describes
  std::string named = {};     ///< the ids found; empty: unknown
  bool right = false;         ///< named, with the right numbers
  std::string sentence = {};  ///< the cause in words
  std::string why = {};       ///< not drawn
};

struct SelfTest {
  std::vector<PlantedResult> results;
  long long planted = 0, unseen = 0, noticed = 0, right = 0, wrong = 0, unknown = 0;
  long long unaltered = 0, accused = 0;
  long long failed = 0;  ///< pictures that a renderer should have drawn

  /// Every visible fault was noticed, 95 % were named, none wrongly, nothing else was accused, and
  /// no renderer failed.
  bool passed() const;
};

/// Throws Interrupted when the user asked to stop.
SelfTest run_self_test(const SelfTestJob& job, const Progress& progress = {});

/// A table in Markdown, with the counts above it.
std::string self_test_markdown(const SelfTest& test);

/// The same as an object of JSON.
std::string self_test_json(const SelfTest& test);

}  // namespace lumaknot::validate
