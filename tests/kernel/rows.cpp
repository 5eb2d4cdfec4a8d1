#include "tests/kernel/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "shaders/formulas/lighting.h"
#include "tests/kernel/samples.h"

namespace lumaknot::testing {
namespace {

/// Scenes allow a microfacet surface a roughness of 0.04 or more.
double roughness(const Sample& s, Model model) {
  return model == Model::kCookTorrance ? 0.04 + s.roughness * 1.46 : s.roughness * 1.57;
}

/// light2_cos_outer as 1, cos_outer.
struct LightName {
  std::size_t index = 0;
  std::string what;
};
LightName light_name(const std::string& name) {
  const std::string number = name.substr(5, name.find('_') - 5);
  return {number.empty() ? 0 : std::stoul(number) - 1, name.substr(name.find('_') + 1)};
}

Vec3d light_value(const Sample& s, const LightName& name, bool is_spot) {
  const LightSample& light = s.lights.at(name.index);
  if (name.what == "position") return light.position;
  if (name.what == "direction") return is_spot ? light.aim : -light.to_light;
  if (name.what == "color") return light.color;
  if (name.what == "constant") return {light.falloff.constant, 0, 0};
  if (name.what == "linear") return {light.falloff.linear, 0, 0};
  if (name.what == "quadratic") return {light.falloff.quadratic, 0, 0};
  if (name.what == "cos_outer") return {light.cos_outer, 0, 0};
  if (name.what == "cone_scale") return {light.cone_scale, 0, 0};
  throw std::logic_error("no numbers for a light's " + name.what);
}

Vec3d value(const Sample& s, const std::string& name, const Material& material) {
  if (name == "position") return s.position;
  if (name == "normal") return s.normal;
  if (name == "eye_position") return s.eye;
  if (name == "texture" || name.starts_with("base_")) return texture_value(s.texture, material);
  if (name == "ambient") return s.ambient;
  if (name == "diffuse") return s.diffuse;
  if (name == "specular") return s.specular;
  if (name == "emissive") return s.emissive;
  if (name == "shininess") return {s.shininess, 0, 0};
  if (name == "roughness") return {roughness(s, material.model), 0, 0};
  if (name == "reflectance") return {s.reflectance, 0, 0};
  if (name == "darkness") return {s.darkness, 0, 0};
  if (name == "luma_offset") return {s.luma_offset, 0, 0};
  throw std::logic_error("no numbers for " + name);
}

Vec3d to_floats(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// Provides a row's values to the formula by name.
struct RowNumbers {
  const KernelRows& rows;
  std::size_t row;

  double number(const std::string& name, double value) const {
    const KernelColumn* column = rows.find(name);
    return column ? column->values[row].x : value;
  }
  Vec3d vector(const std::string& name, const Vec3d& value) const {
    const KernelColumn* column = rows.find(name);
    return column ? column->values[row] : value;
  }
  /// A grey one may be a scalar.
  Vec3d color(const std::string& name, const Vec3d& value) const {
    const KernelColumn* column = rows.find(name);
    if (column && !column->is_vector) return grey(column->values[row].x);
    return vector(name, value);
  }
};

/// The surface's colour: the texture's, or the parameter instead.
Vec3d surface_color(const RowNumbers& numbers) {
  for (const char* plain : {"base_color", "base_axes"}) {
    if (numbers.rows.find(plain)) return numbers.vector(plain, {});
  }
  return numbers.vector("texture", {});
}

}  // namespace

KernelRows::KernelRows(std::vector<KernelColumn> columns) : columns_(std::move(columns)) {
  for (const KernelColumn& column : columns_) index_.emplace(column.name, index_.size());
}

const KernelColumn* KernelRows::find(const std::string& name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? nullptr : &columns_[found->second];
}

KernelRows kernel_rows(const ShaderJob& job) {
  const std::vector<KernelInput> inputs = kernel_inputs(make_shader(job));
  const auto has = [&](const std::string& name) {
    return std::ranges::count(inputs, name, &KernelInput::name) > 0;
  };
  std::vector<KernelColumn> columns;
  for (const KernelInput& input : inputs) {
    KernelColumn column{input.name, input.is_vector, {}};
    const bool of_light = input.name.starts_with("light");
    const LightName name = of_light ? light_name(input.name) : LightName{};
    const bool is_spot = of_light && has(input.name.substr(0, input.name.find('_')) + "_position");
    for (const Sample& s : kernel_samples()) {
      const Vec3d v =
          of_light ? light_value(s, name, is_spot) : value(s, input.name, job.shot.material);
      column.values.push_back(to_floats(input.is_vector ? v : Vec3d{v.x, 0, 0}));
    }
    columns.push_back(std::move(column));
  }
  return KernelRows(std::move(columns));
}

Vec3d expected_color(const ShaderJob& job, const KernelRows& rows, std::size_t row) {
  const RowNumbers numbers{rows, row};
  const auto lighting = lighting_of<double>(job.view, job.shot.material, numbers);
  const SurfacePoint<double> point{numbers.vector("position", {}), numbers.vector("normal", {})};
  return stage_color<double>(point, surface_color(numbers), lighting, job.shot);
}

std::string row_text(const KernelRows& rows, std::size_t row) {
  std::string text = fmt::format("row {}", row);
  for (const KernelColumn& column : rows.columns()) {
    const Vec3d& v = column.values[row];
    text += column.is_vector
                ? fmt::format(", {} ({:.9g}, {:.9g}, {:.9g})", column.name, v.x, v.y, v.z)
                : fmt::format(", {} {:.9g}", column.name, v.x);
  }
  return text;
}

}  // namespace lumaknot::testing
