/// The cause of a difference, found from the picture alone: the least change of the scene, or of
/// how it is drawn, that makes our picture theirs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/hypothesis.h"
#include "diagnosis/score.h"
#include "meshgen/knot_mesh.h"
#include "system/progress.h"

namespace lumaknot::diagnosis {

/// What is to be explained.
struct Case {
  const Scene& scene;
  const Shot& shot;              ///< the stage and the material
  const Image& theirs;           ///< of any size
  std::optional<KnotSpec> knot;  ///< what the scene's mesh was made from
  bool limited = false;          ///< the renderer can't keep colours outside [0, 1]
  bool expects_alpha = false;    ///< its pictures have coverage as alpha
  Progress progress = {};
};

/// A cause's number.
struct NamedNumber {
  std::string name;
  double value = 0;
  double scene = 0;  ///< the scene's own
};

struct NamedCause {
  std::string id;
  std::string sentence;  ///< with its numbers, to follow "is ours with "
  std::vector<NamedNumber> numbers;
  Rung rung = Rung::kEncoding;
};

/// An explanation: one cause, or two that act together.
struct Explained {
  std::vector<NamedCause> causes;
  Score score;
};

struct Diagnosis {
  enum class Verdict { kAgrees, kNamed, kUnknown };
  Verdict verdict = Verdict::kUnknown;
  Facts facts;
  Score as_given;                      ///< with nothing changed
  Explained cause;                     ///< if named; if unknown the nearest, which is not the cause
  std::vector<Explained> equivalents;  ///< that can't be told apart from it in this picture
};

/// Throws nothing that drawing does not.
Diagnosis diagnose(const Case& given);

/// "gamma 2.2 (residual 8e-06)", "unknown; nearest: ...", or "nothing: they agree".
std::string sentence_of(const Diagnosis& diagnosis);

}  // namespace lumaknot::diagnosis
