/// Operations of an expression as a graph without duplicates, which the parser writes and from
/// which the tape is made.
///
/// A node is a variable, a constant, or an operation on earlier nodes; equal nodes exist once.
/// Operations on constants are carried out at once, x + 0, x · 1, x · 0, −(−x) and small integer
/// powers are simplified. Rejected: a tree of objects with virtual functions, which costs a pointer
/// chase for every operation and cannot share common parts.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace dynamy {

enum class Op : std::uint32_t {
  negate,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  exp,
  log,
  log10,
  sqrt,
  abs,
  sign,
  floor,
  ceil,
  logicalNot,
  add,
  subtract,
  multiply,
  divide,
  power,
  powerConstant,
  atan2,
  min,
  max,
  mod,
  hypot,
  less,
  lessEqual,
  equal,
  notEqual,
  logicalAnd,
  logicalOr,
  select,
  variable,
  constant  // leaves, not on the tape
};

/// Number of operands of an operation.
int operandCount(Op op);

/// One operation; operands are indices of earlier results, unused operands are 0.
struct Instruction {
  Op op = Op::constant;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
};

class ExpressionGraph {
 public:
  using Node = std::uint32_t;

  ExpressionGraph() = default;
  /// `simplifies` = false: results of the tape equal, bit by bit, those with constants in place of
  /// the variables.
  explicit ExpressionGraph(bool simplifies) : simplifies_(simplifies) {}

  Node variable(int slot);
  Node constant(double value);
  Node unary(Op op, Node a);
  Node binary(Op op, Node a, Node b);
  /// condition ≠ 0 ? a : b
  Node select(Node condition, Node a, Node b);
  /// a^b; integer exponents up to 8 become products.
  Node power(Node a, Node b);

  bool isConstant(Node n) const { return nodes_[n].op == Op::constant; }
  double value(Node n) const { return values_[n]; }                 ///< of a constant
  const std::vector<Instruction>& nodes() const { return nodes_; }  ///< operands come first

 private:
  Node intern(const Instruction& node, double value = 0.0);
  bool isValue(Node n, double value) const { return isConstant(n) && values_[n] == value; }
  Node add(Node a, Node b);
  Node subtract(Node a, Node b);
  Node multiply(Node a, Node b);
  Node integerPower(Node a, int n);

  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint64_t>;
  std::vector<Instruction> nodes_;
  std::vector<double> values_;
  std::map<Key, Node> index_;
  bool simplifies_ = true;
};

}  // namespace dynamy
