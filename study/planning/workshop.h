/// Methods drawn, judged and timed.
#pragma once

#include <map>
#include <memory>
#include <span>

#include "study/method.h"
#include "study/planning/choices.h"
#include "study/planning/notebook.h"

namespace lumaknot {

/// One scene's methods; what was measured stays in a notebook.
class Workshop {
 public:
  /// `lean` is what methods draw, `scene` what times are taken beside: with its own mesh, as
  /// `lumaknot render --fast` draws it. All are kept by reference, but `lean`.
  Workshop(const Lean& lean, const KnotSpec& knot, const Scene& scene, const Judge& judge,
           Notebook& notebook);
  ~Workshop();

  /// The scene that the method draws: the lean one with its grid's mesh.
  const Scene& scene_of(const Method& method);

  Image draw(const Method& method);

  const ToleranceResult& judgement(const Method& method);

  /// The scene as --fast draws it.
  Image draw_beside() const;

  /// Times the methods until each has so many rounds, each round all in turns.
  void time(std::span<const Method> methods, int rounds);

  /// The median of the rounds' ratios; infinite before the first.
  double ratio(const Method& method) { return ratio(method_name(method)); }
  double ratio(const std::string& name);

  /// The least of them: a disturbed round makes no method slow.
  double least_ratio(const Method& method);

  /// Milliseconds a frame: the ratio times what the frames beside take.
  double milliseconds(const std::string& name);

  /// Times the scene as it is drawn before, by the reference in double.
  void time_reference(int rounds);
  static constexpr const char* kReference = "before: reference";

  /// Milliseconds of the frames beside: the scene as --fast draws it.
  double milliseconds_beside() const;

 private:
  void round(const std::string& name, const DrawFrame& frame);

  Lean lean_;
  const KnotSpec& knot_;
  const Scene& scene_;
  const Judge& judge_;
  Notebook& notebook_;
  std::map<std::pair<int, int>, Scene> scenes_;
  class Beside;
  std::unique_ptr<Beside> beside_;
};

}  // namespace lumaknot
