#include "shaders/graph/record.h"

#include <algorithm>

#include "shaders/formulas/lighting.h"

namespace lumaknot {
namespace {

/// Turns each number of the scene into a parameter.
struct RecordedNumbers {
  Keep keep;

  Scalar number(const std::string& name, double value) const {
    if (keep == Keep::kNeeded && (value == 0 || value == 1)) return value;
    return scalar_parameter(name, value);
  }
  ScalarVec vector(const std::string& name, const Vec3d& value) const {
    return vector_parameter(name, value);
  }
  ScalarVec color(const std::string& name, const Vec3d& value) const {
    const bool is_grey = value.x == value.y && value.y == value.z;
    return keep == Keep::kNeeded && is_grey ? grey(number(name, value.x)) : vector(name, value);
  }
};

/// `value` as a varying that the fragment stage reads; a constant stays one.
ScalarVec interpolated(const char* name, const ScalarVec& value, std::vector<Varying>& varyings) {
  if (value.node->op == Op::kConstant) return value;
  if (value.node->op != Op::kGrey) {
    varyings.push_back({name, value.node});
    return vector_input(name);
  }
  varyings.push_back({name, value.node->arguments[0]});
  return grey(scalar_input(name));
}

ScalarVec texture_of(const Material& material, const std::optional<Vec3d>& color) {
  const bool baked = material.form == Form::kBaked;
  if (!color) return vector_input(baked ? "texture_axes" : "texture");
  return vector_parameter(baked ? "base_axes" : "base_color", texture_value(*color, material));
}

/// Moves the lighting terms that the final formula needs to varyings.
Terms<Scalar> at_vertices(const Terms<Scalar>& terms, std::vector<Varying>& varyings) {
  return {interpolated("diffuse_light", terms.diffuse, varyings),
          interpolated("specular_light", terms.specular, varyings)};
}

/// Removes the varyings that `color` does not read.
void drop_unread(std::vector<Varying>& varyings, const NodePtr& color) {
  const std::vector<const Node*> nodes = in_order({color});
  std::erase_if(varyings, [&](const Varying& varying) {
    return std::ranges::none_of(nodes, [&](const Node* node) {
      return node->op == Op::kInput && node->name == varying.name;
    });
  });
}

}  // namespace

Recorded record_shot(const View& view, const Shot& shot, Keep keep,
                     const std::optional<Vec3d>& color) {
  const auto lighting = lighting_of<Scalar>(view, shot.material, RecordedNumbers{keep});
  const SurfacePoint<Scalar> point{vector_input("position"), vector_input("normal")};
  const ScalarVec texture = texture_of(shot.material, color);
  Terms<Scalar> terms = surface_terms(point, lighting.eye_position, lighting.lights,
                                      lighting.parameters, shot.material);
  Recorded recorded;
  if (shot.material.rate == ShadingFrequency::kVertex)
    terms = at_vertices(terms, recorded.varyings);
  recorded.color = stage_color(texture, terms, lighting, shot).node;
  drop_unread(recorded.varyings, recorded.color);
  return recorded;
}

}  // namespace lumaknot
