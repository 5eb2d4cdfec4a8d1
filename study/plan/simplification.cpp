#include "study/plan/simplification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "render/texture.h"
#include "scene/fields.h"
#include "shaders/formulas/lighting.h"
#include "study/plan/bounds.h"

namespace lumaknot::plan {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

std::optional<double> known(double bound) {
  return std::isfinite(bound) ? std::optional(bound) : std::nullopt;
}

/// The largest contribution of a light of strength one to a colour.
double max_of_light(const Material& m, double peak) {
  return times(diffuse_weight(m, peak), max_diffuse(m)) +
         times(specular_weight(m), max_specular(m));
}

void leave_out(SimplifiedScene& simplified, std::size_t i) {
  simplified.view.lights.erase(simplified.view.lights.begin() + std::ptrdiff_t(i));
  simplified.lights.erase(simplified.lights.begin() + std::ptrdiff_t(i));
}

/// Collects the list.
class Listing {
 public:
  Listing(const SimplifiedScene& simplified, std::span<const Fragment> seen)
      : simplified_(simplified), seen_(seen), bounds_(texture_bounds(simplified.texture)) {
    for (std::size_t i = 0; i < simplified.view.lights.size(); ++i) {
      arrivals_.push_back(arrival_of(simplified.view, i, seen));
    }
  }

  std::vector<Simplification> all() {
    leave_out_lights();
    leave_out_terms();
    leave_out_rules();
    simplify_models();
    simplify_texture();
    for (std::size_t i = 0; i < simplified_.view.lights.size(); ++i) simplify_light(i);
    simplify_colors();
    simplify_space();
    return std::move(all_);
  }

 private:
  void add(std::string what, double bound, std::function<void(SimplifiedScene&)> apply) {
    all_.push_back({std::move(what), std::move(apply), known(bound)});
  }

  double max_of(std::size_t i) const {
    return times(strength(simplified_.view.lights[i]) * arrivals_[i].max,
                 max_of_light(simplified_.view.material, bounds_.peak));
  }

  std::string name_of(std::size_t i) const {
    return fmt::format("light {}", simplified_.lights[i]);
  }

  /// The weakest first.
  void leave_out_lights() {
    std::vector<std::size_t> order(simplified_.view.lights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
      return strength(simplified_.view.lights[i]) * arrivals_[i].max;
    });
    for (const std::size_t i : order) {
      add(name_of(i) + " left out", max_of(i),
          [i](SimplifiedScene& simplified) { leave_out(simplified, i); });
    }
  }

  /// Sums over all lights.
  double sum_of_lights(double weight, double max) const {
    double sum = 0;
    for (std::size_t i = 0; i < arrivals_.size(); ++i) {
      sum += times(weight, max) * strength(simplified_.view.lights[i]) * arrivals_[i].max;
    }
    return sum;
  }

  void leave_out_terms() {
    const View& view = simplified_.view;
    const Material& m = view.material;
    if (m.luma_offset != 0) {
      add("luma offset left out", sensitivity(m) * std::abs(m.luma_offset),
          [](SimplifiedScene& simplified) { simplified.view.material.luma_offset = 0; });
    }
    if (largest_component(m.emissive) > 0) {
      add("emission left out", sensitivity(m) * largest_component(m.emissive),
          [](SimplifiedScene& simplified) { simplified.view.material.emissive = {}; });
    }
    const double ambient =
        view.ambient * largest_component(view.ambient_color) * largest_component(m.ambient_color);
    if (ambient > 0) {
      add("ambient light left out", sensitivity(m) * ambient * bounds_.peak,
          [](SimplifiedScene& simplified) { simplified.view.ambient = 0; });
    }
    if (m.diffuse > 0) {
      add("diffuse term left out",
          sum_of_lights(diffuse_weight(simplified_.view.material, bounds_.peak), max_diffuse(m)),
          [](SimplifiedScene& simplified) { simplified.view.material.diffuse = 0; });
    }
    if (m.specular > 0) {
      add("highlights left out",
          sum_of_lights(specular_weight(simplified_.view.material), max_specular(m)),
          [](SimplifiedScene& simplified) { simplified.view.material.specular = 0; });
    }
  }

  void leave_out_rules() {
    const Material& m = simplified_.view.material;
    if (m.gamut == Gamut::kClamp) {  // a display clamps anyway
      add("gamut rule clamp left out", 0,
          [](SimplifiedScene& simplified) { simplified.view.material.gamut = Gamut::kFree; });
    }
    if (m.gamut == Gamut::kChroma) {
      add("gamut rule chroma left out", kNone,
          [](SimplifiedScene& simplified) { simplified.view.material.gamut = Gamut::kFree; });
    }
    if (m.clamp == Clamp::kTable1) {
      add("Table 1's clamps left out", kNone,
          [](SimplifiedScene& simplified) { simplified.view.material.clamp = Clamp::kFree; });
    }
    if (m.highlights == Highlights::kGated) {
      add("gate of highlights left out",
          sum_of_lights(specular_weight(simplified_.view.material), max_specular(m)),
          [](SimplifiedScene& simplified) {
            simplified.view.material.highlights = Highlights::kFree;
          });
    }
  }

  /// Phong, if what sets the model apart is absent or hardly matters.
  void simplify_models() {
    const Material& m = simplified_.view.material;
    if (m.model == Model::kPhong) return;
    const bool idle = with_model(m.model, [&]<class M>(M) {
      return (std::is_same_v<typename M::Diffuse, Phong::Diffuse> || m.diffuse == 0) &&
             (std::is_same_v<typename M::Highlight, Phong::Highlight> || m.specular == 0);
    });
    add(fmt::format("{} as phong", kModelNames[std::size_t(m.model)]), idle ? 0 : kNone,
        [](SimplifiedScene& simplified) { simplified.view.material.model = Model::kPhong; });
  }

  void simplify_texture() {
    if (!std::holds_alternative<TextureImage>(simplified_.texture) || seen_.empty()) return;
    Vec3d sum;
    for (const Fragment& point : seen_) sum = sum + texture_color(simplified_.texture, point.uv);
    const Vec3d mean = sum / double(seen_.size());
    const Material& m = simplified_.view.material;
    const double light = simplified_.view.ambient + sum_of_lights(m.diffuse, max_diffuse(m));
    const bool bounded = m.space == Space::kRgb && std::isfinite(sensitivity(m));
    add("texture as its mean colour", bounded ? bounds_.contrast * light : kNone,
        [mean](SimplifiedScene& simplified) { simplified.texture = mean; });
  }

  void simplify_light(std::size_t i) {
    const Light& light = simplified_.view.lights[i];
    if (const auto* spot = std::get_if<SpotLight>(&light)) {
      const PointLight point{spot->position, spot->color, spot->falloff};
      add(name_of(i) + ": spot as point", times(1 - cone_share(i), max_of(i)),
          [i, point](SimplifiedScene& simplified) { simplified.view.lights[i] = point; });
    }
    if (const auto* point = std::get_if<PointLight>(&light)) simplify_point(i, *point);
  }

  /// The smallest share that the cone leaves of the light at a visible point.
  double cone_share(std::size_t i) const {
    SimplifiedScene steady = simplified_;
    std::get<SpotLight>(steady.view.lights[i]).falloff = {};
    return arrival_of(steady.view, i, seen_).min;
  }

  void simplify_point(std::size_t i, const PointLight& point) {
    const Arrival& arrival = arrivals_[i];
    const double middle = (arrival.min + arrival.max) / 2;
    const double either_way = times(strength(point) * (arrival.max - arrival.min) / 2,
                                    max_of_light(simplified_.view.material, bounds_.peak));
    PointLight steady = point;
    steady.falloff = {};
    steady.color.intensity *= middle;
    if (arrival.max > arrival.min || point.falloff.constant != 1) {
      add(name_of(i) + ": falloff as a constant", either_way,
          [i, steady](SimplifiedScene& simplified) { simplified.view.lights[i] = steady; });
    }
    Vec3d sum;
    for (const Fragment& f : seen_) sum = sum + f.position;
    const DirectionalLight far{
        sum / double(std::max(seen_.size(), std::size_t{1})) - point.position, steady.color};
    if (length(far.direction) == 0) return;
    add(name_of(i) + ": point as directional", kNone,
        [i, far](SimplifiedScene& simplified) { simplified.view.lights[i] = far; });
  }

  /// White instead of coloured, at the same brightness: identical in a space of brightness.
  void simplify_colors() {
    const Space space = simplified_.view.material.space;
    const auto whiten = [&](const std::string& what, const Vec3d& rgb, auto apply) {
      if (rgb == Vec3d{1, 1, 1}) return;
      const double grey = relative_brightness(rgb, space == Space::kRgb ? Space::kYiq : space);
      add(what + " as white", space == Space::kRgb ? kNone : 0,
          [grey, apply](SimplifiedScene& simplified) { apply(simplified, grey); });
    };
    for (std::size_t i = 0; i < simplified_.view.lights.size(); ++i) {
      whiten(name_of(i) + "'s colour", color_of(simplified_.view.lights[i]).rgb,
             [i](SimplifiedScene& simplified, double grey) {
               LightColor& color = color_of(simplified.view.lights[i]);
               color = {{1, 1, 1}, color.intensity * grey};
             });
    }
    const Material& m = simplified_.view.material;
    whiten("ambient colour", modulate(simplified_.view.ambient_color, m.ambient_color),
           [](SimplifiedScene& simplified, double grey) {
             simplified.view.ambient_color = simplified.view.material.ambient_color = {1, 1, 1};
             simplified.view.ambient *= grey;
           });
    whiten("surface's diffuse colour", m.diffuse_color,
           [](SimplifiedScene& simplified, double grey) {
             simplified.view.material.diffuse_color = {1, 1, 1};
             simplified.view.material.diffuse *= grey;
           });
    whiten("surface's specular colour", m.specular_color,
           [](SimplifiedScene& simplified, double grey) {
             simplified.view.material.specular_color = {1, 1, 1};
             simplified.view.material.specular *= grey;
           });
  }

  void simplify_space() {
    const Material& m = simplified_.view.material;
    const auto name = [&] { return std::string(kSpaceNames[std::size_t(m.space)]); };
    if (m.space != Space::kRgb && m.luma_offset == 0) {
      add(fmt::format("space {} as rgb", name()), kNone,
          [](SimplifiedScene& simplified) { simplified.view.material.space = Space::kRgb; });
    }
    if (m.space != Space::kRgb && !is_linear(m.space)) {
      add(fmt::format("space {} as yiq", name()), kNone,
          [](SimplifiedScene& simplified) { simplified.view.material.space = Space::kYiq; });
    }
  }

  const SimplifiedScene& simplified_;
  std::span<const Fragment> seen_;
  TextureBounds bounds_;
  std::vector<Arrival> arrivals_;
  std::vector<Simplification> all_;
};

}  // namespace

SimplifiedScene whole(const Scene& scene) {
  SimplifiedScene simplified{scene.view, scene.texture, {}};
  for (std::size_t i = 0; i < scene.view.lights.size(); ++i)
    simplified.lights.push_back(int(i) + 1);
  return simplified;
}

std::vector<Simplification> simplifications(const SimplifiedScene& simplified,
                                            std::span<const Fragment> seen) {
  return Listing(simplified, seen).all();
}

}  // namespace lumaknot::plan
