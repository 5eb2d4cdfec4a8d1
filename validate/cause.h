/// Why a renderer's pictures differ.
#pragma once

#include <optional>
#include <string>

#include "diagnosis/diagnose.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::validate {

/// The cause of a renderer's difference, and the shot that it was found in.
struct Cause {
  std::string shot;
  diagnosis::Diagnosis diagnosis;
};

/// From `drawn`, the renderer's picture of `shot`, which differs; `knot` is what the scene's mesh
/// was made from.
Cause find_cause(const Scene& scene, const std::optional<KnotSpec>& knot, const Shot& shot,
                 const Image& drawn, bool limited);

/// The first rung of which a renderer's pictures differ, as the pictures alone tell.
enum class FirstDifference { kCoverage, kTexture, kLight };

/// Of causes that can't be told apart in one picture, the one that this rung leaves: a texture
/// without light that differs is no fault of a lamp, and one that agrees none of the encoding.
void prefer_by_rung(diagnosis::Diagnosis& diagnosis, FirstDifference first);

/// "placement" or "encoding" if that is what differs, rungs before coverage and before texture that
/// no picture shows alone; otherwise empty.
std::string rung_of(const diagnosis::Diagnosis& diagnosis, FirstDifference first);

/// "POV-Ray's picture of phong is ours with gamma 2.2 (residual 8e-06)", or that it is unknown.
std::string cause_sentence(const std::string& renderer, const Cause& cause);

}  // namespace lumaknot::validate
