#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/budget/stages.h"

namespace lumaknot::budget {
namespace {

std::string line(const BudgetPart& part) {
  return fmt::format("  {:<22}{:>11.2e}{:>11.2e}   {}\n", part.name, part.rmse, part.max,
                     part.exact);
}

nlohmann::ordered_json to_json(const BudgetPart& part) {
  return {{"name", part.name}, {"exact", part.exact}, {"rmse", part.rmse}, {"max", part.max}};
}

void paste(const measure::ErrorMap& map, int x0, int y0, Image& image) {
  constexpr double kGain = 16;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const auto [r, g, b] = components(map.at(x, y));
      const Vec3d shown = Vec3d{std::abs(r), std::abs(g), std::abs(b)} * kGain;
      image.at(x0 + x, y0 + y) = {to_rgb(shown), 1};
    }
  }
}

}  // namespace

std::string budget_text(const ErrorBudget& budget) {
  std::string text =
      fmt::format("{} pixels, the fast renderer's picture in 8 bits\n", budget.pixels);
  text += fmt::format("  {:<22}{:>11}{:>11}   {}\n", "stage", "rmse", "max", "its exact form");
  for (const BudgetPart& part : budget.parts) text += line(part);
  text += line(budget.whole) + line(budget.left);
  text += fmt::format("  {:.1f} % of the whole is left over\n", 100 * budget.share_left());
  return text +
         fmt::format("  the truth's own error is estimated to be {:.1e}\n", budget.truth_error);
}

std::string budget_json(const ErrorBudget& budget) {
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for (const BudgetPart& part : budget.parts) parts.push_back(to_json(part));
  const nlohmann::ordered_json json{
      {"pixels", budget.pixels},           {"parts", parts},
      {"whole", to_json(budget.whole)},    {"left_over", to_json(budget.left)},
      {"share_left", budget.share_left()}, {"truth_error", budget.truth_error}};
  return json.dump(2) + "\n";
}

Image budget_picture(const ErrorBudget& budget) {
  constexpr int kColumns = 4;
  std::vector<const measure::ErrorMap*> maps{&budget.whole.map};
  for (const BudgetPart& part : budget.parts) maps.push_back(&part.map);
  maps.push_back(&budget.left.map);
  const int width = budget.whole.map.width, height = budget.whole.map.height;
  const int rows = (int(maps.size()) + kColumns - 1) / kColumns;
  Image image(kColumns * width, rows * height);
  for (int k = 0; k < int(maps.size()); ++k) {
    paste(*maps[std::size_t(k)], k % kColumns * width, k / kColumns * height, image);
  }
  return image;
}

}  // namespace lumaknot::budget
