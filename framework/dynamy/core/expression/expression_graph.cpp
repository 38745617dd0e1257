#include <bit>
#include <cmath>
#include <dynamy/core/expression/expression_graph.hpp>
#include <dynamy/core/expression/expression_kernel.hpp>
#include <utility>

namespace dynamy {

namespace {

/// Result of an operation on constants, computed by the same code that the tape runs.
double fold(Op op, double a, double b) {
  double values[2] = {a, b};
  return applyInstruction<0>({op, 0, 1, 0}, {values, nullptr, nullptr, nullptr}).v;
}

}  // namespace

int operandCount(Op op) {
  if (op <= Op::logicalNot) return 1;
  if (op <= Op::logicalOr) return 2;
  return op == Op::select ? 3 : 0;
}

ExpressionGraph::Node ExpressionGraph::intern(const Instruction& node, double value) {
  const Key key{static_cast<std::uint32_t>(node.op), node.a, node.b, node.c,
                std::bit_cast<std::uint64_t>(value)};
  const auto [it, isNew] = index_.try_emplace(key, static_cast<Node>(nodes_.size()));
  if (isNew) {
    nodes_.push_back(node);
    values_.push_back(value);
  }
  return it->second;
}

ExpressionGraph::Node ExpressionGraph::variable(int slot) {
  return intern({Op::variable, static_cast<std::uint32_t>(slot), 0, 0});
}

ExpressionGraph::Node ExpressionGraph::constant(double value) {
  return intern({Op::constant, 0, 0, 0}, value);
}

ExpressionGraph::Node ExpressionGraph::unary(Op op, Node a) {
  if (isConstant(a)) {
    return constant(fold(op, values_[a], 0.0));
  }
  if (simplifies_ && op == Op::negate && nodes_[a].op == Op::negate) return nodes_[a].a;
  return intern({op, a, 0, 0});
}

ExpressionGraph::Node ExpressionGraph::binary(Op op, Node a, Node b) {
  if (op == Op::power) return power(a, b);
  if (isConstant(a) && isConstant(b)) {
    return constant(fold(op, values_[a], values_[b]));
  }
  if (!simplifies_) return intern({op, a, b, 0});
  switch (op) {
    case Op::add:
      return add(a, b);
    case Op::subtract:
      return subtract(a, b);
    case Op::multiply:
      return multiply(a, b);
    case Op::divide:
      return isValue(b, 1.0) ? a : intern({op, a, b, 0});
    default:
      return intern({op, a, b, 0});
  }
}

ExpressionGraph::Node ExpressionGraph::add(Node a, Node b) {
  if (isValue(a, 0.0)) return b;
  if (isValue(b, 0.0)) return a;
  if (nodes_[b].op == Op::negate) return subtract(a, nodes_[b].a);
  if (nodes_[a].op == Op::negate) return subtract(b, nodes_[a].a);
  // Sums and products of two floating-point numbers commute exactly: operands are sorted, so that
  // a + b and b + a are shared.
  if (b < a) std::swap(a, b);
  return intern({Op::add, a, b, 0});
}

ExpressionGraph::Node ExpressionGraph::subtract(Node a, Node b) {
  if (isValue(b, 0.0)) return a;
  if (isValue(a, 0.0)) return unary(Op::negate, b);
  if (a == b) return constant(0.0);
  if (nodes_[b].op == Op::negate) return add(a, nodes_[b].a);
  return intern({Op::subtract, a, b, 0});
}

ExpressionGraph::Node ExpressionGraph::multiply(Node a, Node b) {
  if (isValue(a, 0.0) || isValue(b, 0.0)) return constant(0.0);
  if (isValue(a, 1.0)) return b;
  if (isValue(b, 1.0)) return a;
  if (isValue(a, -1.0)) return unary(Op::negate, b);
  if (isValue(b, -1.0)) return unary(Op::negate, a);
  if (b < a) std::swap(a, b);
  return intern({Op::multiply, a, b, 0});
}

ExpressionGraph::Node ExpressionGraph::select(Node condition, Node a, Node b) {
  if (isConstant(condition)) return values_[condition] != 0.0 ? a : b;
  return a == b ? a : intern({Op::select, condition, a, b});
}

ExpressionGraph::Node ExpressionGraph::integerPower(Node a, int n) {
  if (n == 1) return a;
  const Node half = integerPower(a, n / 2);
  const Node square = multiply(half, half);
  return n % 2 == 0 ? square : multiply(square, a);
}

ExpressionGraph::Node ExpressionGraph::power(Node a, Node b) {
  constexpr double kLargestProduct = 8.0;
  const bool constants = isConstant(a) && isConstant(b);
  if (!isConstant(b) || (!simplifies_ && !constants)) return intern({Op::power, a, b, 0});
  const double n = values_[b];
  if (constants) return constant(std::pow(values_[a], n));
  if (n == 0.0) return constant(1.0);
  if (n == 0.5) return unary(Op::sqrt, a);
  if (std::abs(n) > kLargestProduct || n != std::floor(n)) {
    return intern({Op::powerConstant, a, b, 0});
  }
  const Node product = integerPower(a, static_cast<int>(std::abs(n)));
  return n > 0.0 ? product : binary(Op::divide, constant(1.0), product);
}

}  // namespace dynamy
