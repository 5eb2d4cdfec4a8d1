/// A possible cause of a difference.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diagnosis/setup.h"
#include "meshgen/knot_mesh.h"

namespace lumaknot::diagnosis {

/// Where in the making of a picture a cause acts. Causes are applied in this order.
enum class Rung { kPlacement, kSurface, kTexture, kLight, kEncoding };

/// A number of a cause. Fitting starts at `start` unless the cause says otherwise.
struct Parameter {
  std::string name;
  double start = 0;  ///< the scene's own value
  double step = 1;   ///< a change that is seen and small
  double min = -1e9, max = 1e9;
};

/// One thing that may be different, with the numbers that say by how much.
struct Hypothesis {
  std::string id;  ///< "fov", "channels-bgr"
  Rung rung = Rung::kEncoding;
  std::vector<Parameter> parameters;
  /// Draws with these values of the parameters.
  std::function<void(Setup&, std::span<const double>)> apply;
  /// The cause in words, with its numbers, to follow "their picture is drawn with ".
  std::function<std::string(std::span<const double>)> sentence;
  std::vector<std::vector<double>> starts{};  ///< where to begin the search; empty: at the scene's
  bool special = false;                       ///< a named case of another: preferred where both fit
  bool costly = false;  ///< drawn many times over: tried only when nothing else explains
};

/// What is known about a picture before anything is tried.
struct Situation {
  Setup setup;                                ///< the scene as given
  std::optional<KnotSpec> knot;               ///< what the mesh was made from
  ImageSpec asked;                            ///< the scene's own size
  std::vector<std::pair<Vec3d, Vec3d>> seen;  ///< our and their colours of pixels that both cover
  bool negative = false;                      ///< our picture has negative colours
  bool eight_bits = false;                    ///< a fact of their file, and no fault
  bool soft_edges = false;                    ///< some of their pixels are covered in part
  double extent = 1;                          ///< half the diagonal of the mesh's box, scene units
  Vec3d centre;                               ///< of that box
};

/// The colour of one light.
LightColor& color_of(Light& light);

/// A cause without numbers.
Hypothesis discrete(std::string id, Rung rung, std::string sentence,
                    std::function<void(Setup&)> apply);

/// A cause with one number; its sentence is `format` with the number in place of {}.
Hypothesis continuous(std::string id, Rung rung, Parameter parameter, std::string format,
                      std::function<void(Setup&, double)> apply);

/// `setup` drawn on another mesh, made of its own by `change`.
void change_mesh(Setup& setup, const std::function<void(TriangleMesh&)>& change);

/// The hypotheses of all causes that apply to the situation.
std::vector<Hypothesis> hypotheses(const Situation& situation);

}  // namespace lumaknot::diagnosis
