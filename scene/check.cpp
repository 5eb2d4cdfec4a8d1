#include "scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "scene/presets.h"
#include "system/error.h"

namespace lumaknot {
namespace {

constexpr long long kMaxVertices = 100'000'000;  // 9 GB with their triangles
constexpr long long kMaxPixels = 1LL << 28;      // 4 GB of RGBA float
constexpr long long kMaxSamples = 1LL << 34;

// Lengths whose squares are still far from the ends of double precision.
constexpr double kMinLength = 1e-100, kMaxLength = 1e100;

/// Visits a struct's fields and checks each number against its range.
struct RangeVisitor {
  std::string prefix;

  std::string label(std::string_view key) const { return field_label(prefix, key); }
  void integer(std::string_view key, int value, Interval<int> range, std::string_view) const {
    check_integer(label(key), value, range);
  }
  void number(std::string_view key, double value, Interval<double> range, std::string_view) const {
    check_number(label(key), value, range);
  }
  template <class Enum, class Names>
  void choice(std::string_view, Enum, const Names&, std::string_view) const {}
};

/// Checks what three.js and Babylon.js don't support or have no name for.
void check_convention(const KnotSpec& knot, const std::string& prefix) {
  const auto label = [&](std::string_view key) { return field_label(prefix, key); };
  const std::string_view name = kConventionNames[std::size_t(knot.convention)];
  const bool babylon = knot.convention == Convention::kBabylon;
  if (!has_fixed_winding(knot.convention)) return;
  if (knot.p == 0) {
    throw Error(fmt::format("{} must not be 0 in convention {}, which {}", label("p"), name,
                            babylon ? "takes 0 as 2" : "divides by it"));
  }
  if (babylon && knot.q == 0) {
    throw Error(
        fmt::format("{} must not be 0 in convention {}, which takes 0 as 3", label("q"), name));
  }
  if (knot.minor_radius != knot.major_radius / 2) {
    throw Error(fmt::format("{} must be half of {} in convention {}, {}, got {}; leave it out",
                            label("winding"), label("ring"), name, knot.major_radius / 2,
                            knot.minor_radius));
  }
  if (knot.frames != FrameRule::kThree || knot.unwrap != Unwrap::kParameter) {
    throw Error(
        fmt::format("{} and {} must be \"three\" and \"parameter\" in convention {}; leave "
                    "them out",
                    label("frames"), label("unwrap"), name));
  }
}

void check_camera(const Camera& camera) {
  const auto text = [](const Vec3d& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); };
  const Vec3d sight = camera.position - camera.target;
  if (sight == Vec3d{}) {
    throw Error(fmt::format("camera.target must differ from camera.position, got {} for both",
                            text(camera.target)));
  }
  if (camera.up == Vec3d{}) throw Error("camera.up must not be [0, 0, 0]; try [0, 0, 1]");
  for (const double size : {length(sight), length(camera.up)}) {
    if (size >= kMinLength && size <= kMaxLength) continue;
    throw Error(fmt::format(
        "camera.position {}, target {} and up {} need a distance and a length of "
        "{} to {}; bring them nearer to 1",
        text(camera.position), text(camera.target), text(camera.up), kMinLength, kMaxLength));
  }
  if (!(length(cross(normalize(camera.up), normalize(sight))) > 1e-9)) {
    throw Error(fmt::format("camera.up must not lie along the line of sight, got {}; try [0, 1, 0]",
                            text(camera.up)));
  }
}

/// The checks of one light that involve more than one number.
class LightCheck {
 public:
  explicit LightCheck(std::size_t index) : path_(fmt::format("lights[{}]", index)) {}

  void operator()(const PointLight& l) const { check_falloff("point", l.falloff); }
  void operator()(const DirectionalLight& l) const { check_direction("directional", l.direction); }
  void operator()(const SpotLight& l) const {
    check_direction("spot", l.direction);
    check_falloff("spot", l.falloff);
    constexpr double kMinEdge = 0.1;   // narrower, and the two cosines are equal in float
    constexpr double kRounded = 1e-9;  // 10.1 - 10 is less than 0.1 in double
    if (l.outer_degrees - l.inner_degrees >= kMinEdge - kRounded) return;
    throw Error(fmt::format(
        "{}.spot.outer_degrees must be at least {} more than inner_degrees, got {} and {}", path_,
        kMinEdge, l.outer_degrees, l.inner_degrees));
  }

 private:
  void check_direction(std::string_view kind, const Vec3d& direction) const {
    const double size = length(direction);
    if (size >= kMinLength && size <= kMaxLength) return;
    throw Error(fmt::format("{}.{}.direction must be a vector of length {} to {}, got [{}, {}, {}]",
                            path_, kind, kMinLength, kMaxLength, direction.x, direction.y,
                            direction.z));
  }
  void check_falloff(std::string_view kind, const Falloff& f) const {
    constexpr double kMin = 1e-6;  // the lower limit of the formula's division
    if (f.constant + f.linear + f.quadratic >= kMin) return;
    throw Error(fmt::format("{}.{}: constant, linear and quadratic must not all be 0 (sum >= {})",
                            path_, kind, kMin));
  }
  std::string path_;
};

/// Checks the numbers that the model reads: another one may allow more.
void check_parameters(const Material& material) {
  const auto check = [&](auto term, auto... numbers) {
    const std::array<double, sizeof...(numbers)> values{numbers...};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Parameter& p = term.kParameters[i];
      check_number(fmt::format("material.{}", p.name), values[i], p.range,
                   fmt::format(" for {}", kModelNames[std::size_t(material.model)]));
    }
  };
  with_diffuse(material.model, material.parameters, check);
  with_highlight(material.model, material.parameters, check);
}

void check_material(const Material& material) {
  const auto quoted = [](Space space) { return kSpaceNames[std::size_t(space)]; };
  if (material.space == Space::kRgb && material.luma_offset != 0) {
    throw Error(fmt::format(
        "material.luma_offset must be 0 in space \"rgb\", got {}; or set material.space to \"yiq\"",
        material.luma_offset));
  }
  if (material.form != Form::kMatrices && !is_linear(material.space)) {
    throw Error(
        fmt::format("material.form \"{}\" needs a linear space of brightness (yiq, yuv601, "
                    "yuv709), got \"{}\"; "
                    "or set material.form to \"matrices\"",
                    kFormNames[std::size_t(material.form)], quoted(material.space)));
  }
  check_parameters(material);
}

}  // namespace

void check_integer(const std::string& label, long long value, Interval<int> range) {
  if (value >= range.min && value <= range.max) return;
  throw Error(fmt::format("{} must be an integer from {} to {}, got {}", label, range.min,
                          range.max, value));
}

void check_number(const std::string& label, double value, Interval<double> range,
                  std::string_view why) {
  if (!std::isfinite(value)) {
    throw Error(fmt::format("{} must be a finite number, got {}", label, value));
  }
  if (value < range.min || (range.open_min && value == range.min)) {
    throw Error(fmt::format("{} must be {} {}{}, got {}", label,
                            range.open_min ? ">" : ">=", range.min, why, value));
  }
  if (value > range.max || (range.open_max && value == range.max)) {
    throw Error(fmt::format("{} must be {} {}{}, got {}", label,
                            range.open_max ? "<" : "<=", range.max, why, value));
  }
}

std::string field_label(const std::string& prefix, std::string_view key) {
  std::string name(key);
  if (prefix == "--") std::ranges::replace(name, '_', '-');
  return prefix + name;
}

void check_knot(const KnotSpec& knot, const std::string& prefix) {
  const RangeVisitor ranges{prefix};
  KnotSpec copy = knot;
  visit_fields(ranges, copy);
  if (knot.p == 0 && knot.q == 0) {
    throw Error(fmt::format("{} and {} must not both be 0; try 2 and 3", ranges.label("p"),
                            ranges.label("q")));
  }
  check_convention(knot, prefix);
  if (knot.frames == FrameRule::kThree && knot.p == 0) {
    throw Error(fmt::format("{} \"three\" needs {} other than 0; use \"rotation-minimizing\"",
                            ranges.label("frames"), ranges.label("p")));
  }
  if (knot.tube_radius >= knot.major_radius) {
    throw Error(fmt::format("{} must be < {}, {}, got {}", ranges.label("tube"),
                            ranges.label("ring"), knot.major_radius, knot.tube_radius));
  }
  const long long vertices = (knot.segments + 1LL) * (knot.sides + 1LL) * std::gcd(knot.p, knot.q);
  if (vertices > kMaxVertices) {
    throw Error(fmt::format("{} x {} make {} vertices, more than {}; lower one of them",
                            ranges.label("segments"), ranges.label("sides"), vertices,
                            kMaxVertices));
  }
}

void check_samples(const ImageSpec& image, long long limit) {
  const long long samples = 1LL * image.width * image.height * image.samples * image.samples;
  if (samples <= limit) return;
  throw Error(fmt::format(
      "image.width x image.height x image.samples^2 is {} samples, more than {}; lower one of them",
      samples, limit));
}

void check_scene(const SceneSpec& spec) {
  if (const auto* knot = std::get_if<KnotSpec>(&spec.mesh)) check_knot(*knot, "mesh.knot.");
  check_camera(spec.view.camera);
  check_material(spec.view.material);
  for (std::size_t i = 0; i < spec.view.lights.size(); ++i) {
    std::visit(LightCheck(i), spec.view.lights[i]);
  }
  const ImageSpec& image = spec.view.image;
  check_samples({image.width, image.height, 1}, kMaxPixels);
  check_samples(image, kMaxSamples);
}

}  // namespace lumaknot
