#include "study/planning/simplification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "render/texture.h"
#include "scene/fields.h"
#include "shaders/lighting.h"
#include "study/planning/bounds.h"

namespace lumaknot {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

std::optional<double> known(double bound) {
  return std::isfinite(bound) ? std::optional(bound) : std::nullopt;
}

/// The most that a colour owes to a light of strength one.
double most_of_light(const Material& m, double peak) {
  return times(diffuse_weight(m, peak), most_diffuse(m)) +
         times(specular_weight(m), most_specular(m));
}

void leave_out(Lean& lean, std::size_t i) {
  lean.view.lights.erase(lean.view.lights.begin() + std::ptrdiff_t(i));
  lean.lights.erase(lean.lights.begin() + std::ptrdiff_t(i));
}

/// The list being made.
class Listing {
 public:
  Listing(const Lean& lean, std::span<const Fragment> seen)
      : lean_(lean), seen_(seen), bounds_(texture_bounds(lean.texture)) {
    for (std::size_t i = 0; i < lean.view.lights.size(); ++i) {
      arrivals_.push_back(arrival_of(lean.view, i, seen));
    }
  }

  std::vector<Simplification> all() {
    leave_out_lights();
    leave_out_terms();
    leave_out_rules();
    simplify_models();
    simplify_texture();
    for (std::size_t i = 0; i < lean_.view.lights.size(); ++i) simplify_light(i);
    simplify_colors();
    simplify_space();
    return std::move(all_);
  }

 private:
  void add(std::string what, double bound, std::function<void(Lean&)> apply) {
    all_.push_back({std::move(what), std::move(apply), known(bound)});
  }

  double most_of(std::size_t i) const {
    return times(strength(lean_.view.lights[i]) * arrivals_[i].most,
                 most_of_light(lean_.view.material, bounds_.peak));
  }

  std::string name_of(std::size_t i) const { return fmt::format("light {}", lean_.lights[i]); }

  /// The weakest first.
  void leave_out_lights() {
    std::vector<std::size_t> order(lean_.view.lights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
      return strength(lean_.view.lights[i]) * arrivals_[i].most;
    });
    for (const std::size_t i : order) {
      add(name_of(i) + " left out", most_of(i), [i](Lean& lean) { leave_out(lean, i); });
    }
  }

  /// Sums over all lights.
  double sum_of_lights(double weight, double most) const {
    double sum = 0;
    for (std::size_t i = 0; i < arrivals_.size(); ++i) {
      sum += times(weight, most) * strength(lean_.view.lights[i]) * arrivals_[i].most;
    }
    return sum;
  }

  void leave_out_terms() {
    const View& view = lean_.view;
    const Material& m = view.material;
    if (m.luma_offset != 0) {
      add("luma offset left out", answer(m) * std::abs(m.luma_offset),
          [](Lean& lean) { lean.view.material.luma_offset = 0; });
    }
    if (largest_component(m.emissive) > 0) {
      add("emission left out", answer(m) * largest_component(m.emissive),
          [](Lean& lean) { lean.view.material.emissive = {}; });
    }
    const double ambient =
        view.ambient * largest_component(view.ambient_color) * largest_component(m.ambient_color);
    if (ambient > 0) {
      add("ambient light left out", answer(m) * ambient * bounds_.peak,
          [](Lean& lean) { lean.view.ambient = 0; });
    }
    if (m.diffuse > 0) {
      add("diffuse term left out",
          sum_of_lights(diffuse_weight(lean_.view.material, bounds_.peak), most_diffuse(m)),
          [](Lean& lean) { lean.view.material.diffuse = 0; });
    }
    if (m.specular > 0) {
      add("highlights left out",
          sum_of_lights(specular_weight(lean_.view.material), most_specular(m)),
          [](Lean& lean) { lean.view.material.specular = 0; });
    }
  }

  void leave_out_rules() {
    const Material& m = lean_.view.material;
    if (m.gamut == Gamut::kClamp) {  // a display clamps anyway
      add("gamut rule clamp left out", 0,
          [](Lean& lean) { lean.view.material.gamut = Gamut::kFree; });
    }
    if (m.gamut == Gamut::kChroma) {
      add("gamut rule chroma left out", kNone,
          [](Lean& lean) { lean.view.material.gamut = Gamut::kFree; });
    }
    if (m.clamp == Clamp::kTable1) {
      add("Table 1's clamps left out", kNone,
          [](Lean& lean) { lean.view.material.clamp = Clamp::kFree; });
    }
    if (m.highlights == Highlights::kGated) {
      add("gate of highlights left out",
          sum_of_lights(specular_weight(lean_.view.material), most_specular(m)),
          [](Lean& lean) { lean.view.material.highlights = Highlights::kFree; });
    }
  }

  /// Phong, where what sets the model apart isn't there or hardly matters.
  void simplify_models() {
    const Material& m = lean_.view.material;
    if (m.model == Model::kPhong) return;
    const bool own_diffuse = m.model == Model::kMinnaert || m.model == Model::kOrenNayar;
    const bool idle = own_diffuse ? m.diffuse == 0 : m.specular == 0;
    add(fmt::format("{} as phong", kModelNames[std::size_t(m.model)]), idle ? 0 : kNone,
        [](Lean& lean) { lean.view.material.model = Model::kPhong; });
  }

  void simplify_texture() {
    if (!std::holds_alternative<TextureImage>(lean_.texture) || seen_.empty()) return;
    Vec3d sum;
    for (const Fragment& point : seen_) sum = sum + texture_color(lean_.texture, point.uv);
    const Vec3d mean = sum / double(seen_.size());
    const Material& m = lean_.view.material;
    const double light = lean_.view.ambient + sum_of_lights(m.diffuse, most_diffuse(m));
    const bool bounded = m.space == Space::kRgb && std::isfinite(answer(m));
    add("texture as its mean colour", bounded ? bounds_.contrast * light : kNone,
        [mean](Lean& lean) { lean.texture = mean; });
  }

  void simplify_light(std::size_t i) {
    const Light& light = lean_.view.lights[i];
    if (const auto* spot = std::get_if<SpotLight>(&light)) {
      const PointLight point{spot->position, spot->color, spot->falloff};
      add(name_of(i) + ": spot as point", times(1 - cone_share(i), most_of(i)),
          [i, point](Lean& lean) { lean.view.lights[i] = point; });
    }
    if (const auto* point = std::get_if<PointLight>(&light)) simplify_point(i, *point);
  }

  /// The least that the cone leaves where something is seen.
  double cone_share(std::size_t i) const {
    Lean steady = lean_;
    std::get<SpotLight>(steady.view.lights[i]).falloff = {};
    return arrival_of(steady.view, i, seen_).least;
  }

  void simplify_point(std::size_t i, const PointLight& point) {
    const Arrival& arrival = arrivals_[i];
    const double middle = (arrival.least + arrival.most) / 2;
    const double either_way = times(strength(point) * (arrival.most - arrival.least) / 2,
                                    most_of_light(lean_.view.material, bounds_.peak));
    PointLight steady = point;
    steady.falloff = {};
    steady.color.intensity *= middle;
    if (arrival.most > arrival.least || point.falloff.constant != 1) {
      add(name_of(i) + ": falloff as a constant", either_way,
          [i, steady](Lean& lean) { lean.view.lights[i] = steady; });
    }
    Vec3d sum;
    for (const Fragment& f : seen_) sum = sum + f.position;
    const DirectionalLight far{
        sum / double(std::max(seen_.size(), std::size_t{1})) - point.position, steady.color};
    if (length(far.direction) == 0) return;
    add(name_of(i) + ": point as directional", kNone,
        [i, far](Lean& lean) { lean.view.lights[i] = far; });
  }

  /// White for coloured, at the same brightness: the very same in a space of brightness.
  void simplify_colors() {
    const Space space = lean_.view.material.space;
    const auto whiten = [&](const std::string& what, const Vec3d& rgb, auto apply) {
      if (rgb == Vec3d{1, 1, 1}) return;
      const double grey = relative_brightness(rgb, space == Space::kRgb ? Space::kYiq : space);
      add(what + " as white", space == Space::kRgb ? kNone : 0,
          [grey, apply](Lean& lean) { apply(lean, grey); });
    };
    for (std::size_t i = 0; i < lean_.view.lights.size(); ++i) {
      whiten(name_of(i) + "'s colour", color_of(lean_.view.lights[i]).rgb,
             [i](Lean& lean, double grey) {
               LightColor& color = color_of(lean.view.lights[i]);
               color = {{1, 1, 1}, color.intensity * grey};
             });
    }
    const Material& m = lean_.view.material;
    whiten("ambient colour", modulate(lean_.view.ambient_color, m.ambient_color),
           [](Lean& lean, double grey) {
             lean.view.ambient_color = lean.view.material.ambient_color = {1, 1, 1};
             lean.view.ambient *= grey;
           });
    whiten("surface's diffuse colour", m.diffuse_color, [](Lean& lean, double grey) {
      lean.view.material.diffuse_color = {1, 1, 1};
      lean.view.material.diffuse *= grey;
    });
    whiten("surface's specular colour", m.specular_color, [](Lean& lean, double grey) {
      lean.view.material.specular_color = {1, 1, 1};
      lean.view.material.specular *= grey;
    });
  }

  void simplify_space() {
    const Material& m = lean_.view.material;
    const auto name = [&] { return std::string(kSpaceNames[std::size_t(m.space)]); };
    if (m.space != Space::kRgb && m.luma_offset == 0) {
      add(fmt::format("space {} as rgb", name()), kNone,
          [](Lean& lean) { lean.view.material.space = Space::kRgb; });
    }
    if (m.space != Space::kRgb && !is_linear(m.space)) {
      add(fmt::format("space {} as yiq", name()), kNone,
          [](Lean& lean) { lean.view.material.space = Space::kYiq; });
    }
  }

  const Lean& lean_;
  std::span<const Fragment> seen_;
  TextureBounds bounds_;
  std::vector<Arrival> arrivals_;
  std::vector<Simplification> all_;
};

}  // namespace

Lean whole(const Scene& scene) {
  Lean lean{scene.view, scene.texture, {}};
  for (std::size_t i = 0; i < scene.view.lights.size(); ++i) lean.lights.push_back(int(i) + 1);
  return lean;
}

std::vector<Simplification> simplifications(const Lean& lean, std::span<const Fragment> seen) {
  return Listing(lean, seen).all();
}

}  // namespace lumaknot
