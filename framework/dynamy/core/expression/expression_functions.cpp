#include <array>
#include <dynamy/core/expression/expression_functions.hpp>
#include <vector>

namespace dynamy {
namespace {

using Graph = ExpressionGraph;
using Node = ExpressionGraph::Node;
using Arguments = std::span<const Node>;

template <Op op>
Node unary(Graph& graph, Arguments x) {
  return graph.unary(op, x[0]);
}

/// op of all arguments from the left: min(a, b, c) = min(min(a, b), c).
template <Op op>
Node reduce(Graph& graph, Arguments x) {
  Node result = x[0];
  for (const Node next : x.subspan(1)) result = graph.binary(op, result, next);
  return result;
}

/// 1 for x ≥ 0, else 0: continuous from the right.
Node step(Graph& graph, Arguments x) {
  return graph.binary(Op::lessEqual, graph.constant(0.0), x[0]);
}

/// min(max(x, low), high)
Node clamp(Graph& graph, Arguments x) {
  return graph.binary(Op::min, graph.binary(Op::max, x[0], x[1]), x[2]);
}

/// y0 for x ≤ x0, y1 for x ≥ x1, between them the cubic y0 + (y1 − y0) s² (3 − 2s) of
/// s = (x − x0)/(x1 − x0), whose slope is 0 at both ends.
Node smoothStep(Graph& graph, Arguments a) {
  const Node width = graph.binary(Op::subtract, a[3], a[1]);
  const Node part = graph.binary(Op::divide, graph.binary(Op::subtract, a[0], a[1]), width);
  const std::array<Node, 3> limits{part, graph.constant(0.0), graph.constant(1.0)};
  const Node s = clamp(graph, limits);
  const Node twice = graph.binary(Op::multiply, graph.constant(2.0), s);
  const Node rest = graph.binary(Op::subtract, graph.constant(3.0), twice);
  const Node share = graph.binary(Op::multiply, graph.binary(Op::multiply, s, s), rest);
  const Node rise = graph.binary(Op::multiply, graph.binary(Op::subtract, a[4], a[2]), share);
  return graph.binary(Op::add, a[2], rise);
}

constexpr auto kFunctions = std::to_array<ExpressionFunction>({
    {"sin", 1, 1, unary<Op::sin>},
    {"cos", 1, 1, unary<Op::cos>},
    {"tan", 1, 1, unary<Op::tan>},
    {"asin", 1, 1, unary<Op::asin>},
    {"acos", 1, 1, unary<Op::acos>},
    {"atan", 1, 1, unary<Op::atan>},
    {"atan2", 2, 2, reduce<Op::atan2>},
    {"sinh", 1, 1, unary<Op::sinh>},
    {"cosh", 1, 1, unary<Op::cosh>},
    {"tanh", 1, 1, unary<Op::tanh>},
    {"exp", 1, 1, unary<Op::exp>},
    {"log", 1, 1, unary<Op::log>},
    {"log10", 1, 1, unary<Op::log10>},
    {"sqrt", 1, 1, unary<Op::sqrt>},
    {"abs", 1, 1, unary<Op::abs>},
    {"sign", 1, 1, unary<Op::sign>},
    {"min", 2, kAnyNumber, reduce<Op::min>},
    {"max", 2, kAnyNumber, reduce<Op::max>},
    {"floor", 1, 1, unary<Op::floor>},
    {"ceil", 1, 1, unary<Op::ceil>},
    {"mod", 2, 2, reduce<Op::mod>},
    {"hypot", 2, 3, reduce<Op::hypot>},
    {"pow", 2, 2, reduce<Op::power>},
    {"step", 1, 1, step},
    {"clamp", 3, 3, clamp},
    {"smoothstep", 5, 5, smoothStep},
});

std::vector<std::string> tableNames() {
  std::vector<std::string> names;
  for (const ExpressionFunction& f : kFunctions) names.emplace_back(f.name);
  return names;
}

}  // namespace

const ExpressionFunction* findFunction(std::string_view name) {
  for (const ExpressionFunction& f : kFunctions) {
    if (f.name == name) return &f;
  }
  return nullptr;
}

std::span<const std::string> functionNames() {
  static const std::vector<std::string> kNames = tableNames();
  return kNames;
}

}  // namespace dynamy
