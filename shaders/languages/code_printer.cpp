#include "shaders/languages/code_printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <unordered_map>

namespace lumaknot {
namespace {

/// How tightly an expression binds.
enum Precedence { kTernary = 1, kSum = 3, kProduct = 4, kUnary = 5, kPrimary = 6 };

struct Text {
  std::string text;
  Precedence precedence = kPrimary;
};

std::string in_brackets(const Text& t, Precedence needed) {
  return t.precedence < needed ? fmt::format("({})", t.text) : t.text;
}

/// a op b, the right side in brackets when it binds no tighter: a - (b - c).
Text binary(const Text& a, std::string_view op, const Text& b, Precedence precedence) {
  return {fmt::format("{} {} {}", in_brackets(a, precedence), op,
                      in_brackets(b, Precedence(precedence + 1))),
          precedence};
}

bool is_leaf(const Node& node) {
  return node.op == Op::kInput || node.op == Op::kParameter || node.op == Op::kConstant;
}

/// Whether the language takes a component only of a variable.
bool needs_variable(const Node& user) {
  return user.op == Op::kX || user.op == Op::kY || user.op == Op::kZ;
}

class Printer {
 public:
  Printer(const Dialect& dialect, std::string_view indent) : dialect_(dialect), indent_(indent) {}

  PrintedCode print(const std::vector<NodePtr>& roots) {
    const std::vector<const Node*> order = in_order(roots);
    for (const Node* node : order) {
      for (const NodePtr& argument : node->arguments) {
        ++uses_[argument.get()];
        if (needs_variable(*node) || repeats(*node)) ++uses_[argument.get()];
      }
      if (is_leaf(*node)) taken_.insert(text_of(*node).text);
    }
    for (const Node* node : order) add(*node);
    for (const NodePtr& root : roots) code_.results.push_back(texts_.at(root.get()).text);
    return std::move(code_);
  }

 private:
  void add(const Node& node) {
    const Text text = text_of(node);
    const bool is_variable = !is_leaf(node) && (!node.name.empty() || uses_[&node] > 1) &&
                             !(needs_variable(node) && node.name.empty());
    if (!is_variable) {
      texts_[&node] = text;
      return;
    }
    const std::string name = unique(node.name.empty() ? "value" : node.name);
    const auto type = node.is_vector ? dialect_.vector_type : dialect_.scalar_type;
    code_.statements +=
        wrapped_line(fmt::format(fmt::runtime(dialect_.declaration), fmt::arg("type", type),
                                 fmt::arg("name", name), fmt::arg("value", text.text)),
                     indent_);
    texts_[&node] = {name};
  }

  /// Whether the language writes the node's argument more than once: HLSL's float3(x, x, x).
  bool repeats(const Node& node) const {
    return node.op == Op::kGrey && dialect_.grey_of.find("{0}") != dialect_.grey_of.rfind("{0}");
  }

  std::string unique(std::string_view name) {
    std::string candidate = identifier_of(name, dialect_);
    for (int i = 2; !taken_.insert(candidate).second; ++i) {
      candidate = identifier_of(fmt::format("{}{}", name, i), dialect_);
    }
    return candidate;
  }

  const Text& argument(const Node& node, std::size_t i) const {
    return texts_.at(node.arguments[i].get());
  }

  Text call(std::string_view function, const Node& node) const {
    std::string list;
    for (std::size_t i = 0; i < node.arguments.size(); ++i) {
      if (i > 0) list += ", ";
      list += argument(node, i).text;
    }
    return {fmt::format("{}({})", function, list)};
  }

  template <class... Args>
  static Text formatted(std::string_view format, const Args&... args) {
    return {fmt::format(fmt::runtime(format), args...)};
  }

  Text constant(const Node& node) const {
    const Vec3d& v = node.value;
    if (!node.is_vector) return {number_text(v.x), v.x < 0 ? kUnary : kPrimary};
    if (v.x == v.y && v.y == v.z) return formatted(dialect_.grey_of, number_text(v.x));
    return formatted(dialect_.vector_of, number_text(v.x), number_text(v.y), number_text(v.z));
  }

  Text select(const Node& node) const {
    const auto side = [&](std::size_t i) { return in_brackets(argument(node, i), kSum); };
    return formatted(dialect_.select, side(0), side(1), side(2), side(3));
  }

  Text text_of(const Node& node) const {
    const auto arg = [&](std::size_t i) { return argument(node, i); };
    const bool on_vectors = !node.arguments.empty() && node.arguments[0]->is_vector;
    switch (node.op) {
      case Op::kInput:
        return {identifier_of(node.name, dialect_)};
      case Op::kParameter:
        return {parameter_identifier(node.name, dialect_)};
      case Op::kConstant:
        return constant(node);
      case Op::kAdd:
        return binary(arg(0), "+", arg(1), kSum);
      case Op::kSubtract:
        return binary(arg(0), "-", arg(1), kSum);
      case Op::kMultiply:
      case Op::kScale:
        return binary(arg(0), "*", arg(1), kProduct);
      case Op::kDivide:
        return binary(arg(0), "/", arg(1), kProduct);
      case Op::kMaximum:
        return call(on_vectors ? dialect_.vector_max : "max", node);
      case Op::kMinimum:
        return call(on_vectors ? dialect_.vector_min : "min", node);
      case Op::kSaturate:
        return formatted(on_vectors ? dialect_.vector_saturate : dialect_.saturate, arg(0).text);
      case Op::kPower:
        return call(power_of(node), node);
      case Op::kExp:
        return call("exp", node);
      case Op::kLog:
        return call(dialect_.logarithm, node);
      case Op::kSqrt:
        return call("sqrt", node);
      case Op::kAbs:
        return call(dialect_.absolute, node);
      case Op::kSelectLess:
        return select(node);
      case Op::kDot:
        return call(dialect_.dot, node);
      case Op::kCross:
        return call(dialect_.cross, node);
      case Op::kUnit:
        return call(dialect_.unit, node);
      case Op::kCombine:
        return formatted(dialect_.vector_of, arg(0).text, arg(1).text, arg(2).text);
      case Op::kGrey:
        return formatted(dialect_.grey_of, arg(0).text);
      case Op::kX:
        return formatted(dialect_.component[0], arg(0).text);
      case Op::kY:
        return formatted(dialect_.component[1], arg(0).text);
      case Op::kZ:
        return formatted(dialect_.component[2], arg(0).text);
    }
    return {};
  }

  /// Languages agree on pow(x, y) for x > 0 alone.
  std::string_view power_of(const Node& node) const {
    return node.arguments[0]->min > 0 ? "pow" : dialect_.power;
  }

  const Dialect& dialect_;
  std::string indent_;
  std::unordered_map<const Node*, int> uses_;
  std::unordered_map<const Node*, Text> texts_;
  std::set<std::string> taken_;
  PrintedCode code_;
};

/// n_dot_l as N_Dot_L.
std::string capitalised(std::string name) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i == 0 || name[i - 1] == '_')
      name[i] = char(std::toupper(static_cast<unsigned char>(name[i])));
  }
  return name;
}

}  // namespace

PrintedCode print_code(const std::vector<NodePtr>& roots, const Dialect& dialect,
                       std::string_view indent) {
  return Printer(dialect, indent).print(roots);
}

std::string identifier_of(std::string_view name, const Dialect& dialect) {
  // What languages call their texture look-up.
  std::string result = name == "texture" ? "texture_color" : std::string(name);
  if (dialect.capitalised) result = capitalised(result);
  while (std::ranges::count(dialect.reserved, result) > 0) result += "_value";
  return result;
}

std::string parameter_identifier(std::string_view name, const Dialect& dialect) {
  return dialect.parameter_name ? dialect.parameter_name(name) : identifier_of(name, dialect);
}

std::string wrapped_line(const std::string& line, std::string_view indent) {
  constexpr std::size_t kWidth = 100;
  std::string result;
  std::string rest = std::string(indent) + line;
  while (rest.size() > kWidth) {
    std::size_t at = rest.rfind(' ', kWidth);
    if (at == rest.npos || at <= indent.size() + 4) break;
    result += fmt::format("{}\n", rest.substr(0, at));
    rest = fmt::format("{}    {}", indent, rest.substr(at + 1));
  }
  return fmt::format("{}{}\n", result, rest);
}

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return text;
}

}  // namespace lumaknot
