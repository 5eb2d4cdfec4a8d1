#include "diagnosis/hypothesis.h"

#include <fmt/format.h>

#include "diagnosis/cause.h"
#include "diagnosis/list.h"

namespace lumaknot::diagnosis {

#define LUMAKNOT_CAUSE(name) std::vector<Hypothesis> name(const Situation& situation);
LUMAKNOT_CAUSES(LUMAKNOT_CAUSE)
#undef LUMAKNOT_CAUSE

std::string number(double value) {
  return fmt::format("{:.5g}", std::abs(value) < 5e-7 ? 0 : value);
}

std::string point(const Vec3d& p) {
  return fmt::format("({}, {}, {})", number(p.x), number(p.y), number(p.z));
}

bool has_image(const Situation& situation) {
  return std::holds_alternative<TextureImage>(*situation.setup.texture);
}

Vec3d* position_of(Light& light) {
  if (auto* point = std::get_if<PointLight>(&light)) return &point->position;
  auto* spot = std::get_if<SpotLight>(&light);
  return spot ? &spot->position : nullptr;
}

Falloff* falloff_of(Light& light) {
  if (auto* point = std::get_if<PointLight>(&light)) return &point->falloff;
  auto* spot = std::get_if<SpotLight>(&light);
  return spot ? &spot->falloff : nullptr;
}

LightColor& color_of(Light& light) {
  return std::visit([](auto& l) -> LightColor& { return l.color; }, light);
}

Hypothesis discrete(std::string id, Rung rung, std::string sentence,
                    std::function<void(Setup&)> apply) {
  return {
      .id = std::move(id),
      .rung = rung,
      .parameters = {},
      .apply = [apply = std::move(apply)](Setup& s, std::span<const double>) { apply(s); },
      .sentence = [sentence = std::move(sentence)](std::span<const double>) { return sentence; }};
}

Hypothesis continuous(std::string id, Rung rung, Parameter parameter, std::string format,
                      std::function<void(Setup&, double)> apply) {
  return {
      .id = std::move(id),
      .rung = rung,
      .parameters = {std::move(parameter)},
      .apply = [apply = std::move(apply)](Setup& s, std::span<const double> p) { apply(s, p[0]); },
      .sentence =
          [format = std::move(format)](std::span<const double> p) {
            return fmt::format(fmt::runtime(format), p[0]);
          }};
}

void change_mesh(Setup& setup, const std::function<void(TriangleMesh&)>& change) {
  auto mesh = std::make_shared<TriangleMesh>(*setup.mesh);
  change(*mesh);
  setup.mesh = std::move(mesh);
}

std::vector<Hypothesis> hypotheses(const Situation& situation) {
  std::vector<Hypothesis> all;
  const auto add = [&](std::vector<Hypothesis> some) {
    for (Hypothesis& one : some) all.push_back(std::move(one));
  };
#define LUMAKNOT_CAUSE(name) add(name(situation));
  LUMAKNOT_CAUSES(LUMAKNOT_CAUSE)
#undef LUMAKNOT_CAUSE
  return all;
}

}  // namespace lumaknot::diagnosis
