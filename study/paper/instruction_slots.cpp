#include "study/paper/instruction_slots.h"

#include <algorithm>
#include <unordered_map>

namespace lumaknot::paper {
namespace {

using Uses = std::unordered_map<const Node*, int>;

bool is_product(const Node& node) { return node.op == Op::kMultiply || node.op == Op::kScale; }

bool is_free(const Node& node) {
  switch (node.op) {
    case Op::kInput:
    case Op::kParameter:
    case Op::kConstant:
    case Op::kCombine:
    case Op::kGrey:
    case Op::kX:
    case Op::kY:
    case Op::kZ:
      return true;
    default:
      return false;
  }
}

/// A product with -1 is a modifier of its reader.
bool is_negation(const Node& node) {
  return is_product(node) && std::ranges::any_of(node.arguments, [](const NodePtr& a) {
           return a->op == Op::kConstant && a->value.x == -1;
         });
}

int own_slots(const Node& node, const Uses& uses) {
  if (is_free(node) || is_negation(node)) return 0;
  switch (node.op) {
    case Op::kSaturate:
      return uses.at(node.arguments[0].get()) > 1 || is_free(*node.arguments[0]) ? 1 : 0;
    case Op::kPower:
    case Op::kUnit:
      return 3;
    case Op::kDivide:
    case Op::kSqrt:
    case Op::kExp:
    case Op::kLog:
    case Op::kSelectLess:
    case Op::kCross:
      return 2;
    default:
      return 1;
  }
}

/// Whether the sum and one of its products form a mad.
bool is_mad(const Node& node, const Uses& uses) {
  if (node.op != Op::kAdd && node.op != Op::kSubtract) return false;
  return std::ranges::any_of(node.arguments, [&](const NodePtr& a) {
    return is_product(*a) && !is_negation(*a) && uses.at(a.get()) == 1;
  });
}

}  // namespace

int pixel_slots(const Shader& shader) {
  const std::vector<const Node*> order = in_order({shader.recorded.color});
  Uses uses;
  for (const Node* node : order) {
    for (const NodePtr& argument : node->arguments) ++uses[argument.get()];
  }
  constexpr int kOutput = 2;
  int slots = kOutput + (shader.textured() ? 1 : 0);
  for (const Node* node : order) slots += own_slots(*node, uses) - (is_mad(*node, uses) ? 1 : 0);
  return slots;
}

}  // namespace lumaknot::paper
