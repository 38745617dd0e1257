/// Formulas given as text: values and exact first and second directional derivatives.
///
/// Texts → tokens → graph without duplicates → tape. The tape is a row of instructions on registers
///   [ inputs x | constants | one result per instruction ]
/// run from the first to the last, on plain numbers or on Taylor numbers (dual.hpp):
///   f(x),   f′(x) v,   vᵀ f″(x) w
/// Theory, grammar and functions: doc/theory/05_expressions.md. Rejected: symbolic differentiation,
/// whose results grow with the depth of the formula; and reverse mode, which needs a stored tape
/// for a gain that begins at many variables.
///
/// No function that evaluates allocates or throws. A set is constant after its construction; each
/// thread brings its own ExpressionWorkspace. Results may be infinite or NaN; the caller checks.
#pragma once

#include <cstdint>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/core/expression/expression_graph.hpp>
#include <dynamy/core/expression/symbol_table.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace dynamy {

class ExpressionSet;

/// Registers for one ExpressionSet, filled with its constants.
class ExpressionWorkspace {
 public:
  explicit ExpressionWorkspace(const ExpressionSet& set);

 private:
  friend class ExpressionSet;
  std::vector<double> values_;
  std::vector<double> derivatives1_;  // along v
  std::vector<double> derivatives2_;  // along w
  std::vector<double> derivatives12_;
};

/// m formulas of n variables on one tape; common parts are evaluated once.
class ExpressionSet {
 public:
  int inputCount() const { return inputCount_; }                         ///< n
  int outputCount() const { return static_cast<int>(outputs_.size()); }  ///< m
  int instructionCount() const { return static_cast<int>(tape_.size()); }

  /// out = f(x). x: n numbers, out: m numbers.
  void eval(const double* x, double* out, ExpressionWorkspace& work) const noexcept;

  /// out = f(x), dout = f′(x) v. v: n numbers, dout: m numbers.
  void evalD(const double* x, const double* v, double* out, double* dout,
             ExpressionWorkspace& work) const noexcept;

  /// out = f(x), dout1 = f′(x) v, dout2 = f′(x) w, ddout = vᵀ f″(x) w, m numbers each.
  void evalDD(const double* x, const double* v, const double* w, double* out, double* dout1,
              double* dout2, double* ddout, ExpressionWorkspace& work) const noexcept;

  /// out = f(x) and J = ∂f/∂(x_j, j in variables), m × variables.size() numbers by columns.
  void gradient(const double* x, std::span<const int> variables, double* out, double* J,
                ExpressionWorkspace& work) const noexcept;

  /// Does the formula, after simplification, contain the variable?
  bool dependsOn(int output, int variable) const;

  bool isConstant(int output) const;

  /// Is the formula c + Σ a_j x_j over the listed variables, with c and a_j free of them? Decided
  /// by the form of the formula: true is certain, false means "not seen". With all variables
  /// listed, true says that the gradient is constant.
  bool isAffine(int output, std::span<const int> variables) const;

  /// First value of x[variable] beyond `after` at which step, clamp, abs, a condition, floor … of
  /// any formula changes its branch; infinity: none. A change is found only if the compared values
  /// are, on the present branch, affine in this variable and free of the others.
  double nextInstant(double after, int variable) const;

 private:
  friend class ExpressionCompiler;
  friend class ExpressionWorkspace;
  ExpressionSet() = default;

  template <int N>
  void run(ExpressionWorkspace& work) const noexcept;
  std::uint32_t firstResult() const {
    return static_cast<std::uint32_t>(inputCount_) + static_cast<std::uint32_t>(constants_.size());
  }

  int inputCount_ = 0;
  std::vector<double> constants_;
  std::vector<Instruction> tape_;
  std::vector<std::uint32_t> outputs_;  // registers
};

/// Collects formulas and makes the set.
class ExpressionCompiler {
 public:
  /// `simplifies` = false: results are, bit by bit, those of evaluateConstant with the variables'
  /// values as constants. Powers are then not products, and derivatives at a power of 0 differ.
  explicit ExpressionCompiler(SymbolTable symbols, bool simplifies = true);

  /// Adds a formula and returns the index of its output. Raises ExpressionError; the compiler can
  /// still be used afterwards.
  int add(std::string_view text);

  /// The set of all formulas added so far; parts that no output needs are left out.
  ExpressionSet finish() const;

 private:
  SymbolTable symbols_;
  ExpressionGraph graph_;
  std::vector<ExpressionGraph::Node> outputs_;
};

/// One formula with its own workspace, for users that hold a single one. Not to be shared between
/// threads.
class Expression {
 public:
  /// Raises ExpressionError.
  static Expression compile(std::string_view text, const SymbolTable& symbols);

  double value(const double* x);
  /// f′(x) v
  double derivative(const double* x, const double* v);
  /// vᵀ f″(x) w
  double secondDerivative(const double* x, const double* v, const double* w);

  bool dependsOn(int variable) const { return set_.dependsOn(0, variable); }
  bool isConstant() const { return set_.isConstant(0); }
  const ExpressionSet& set() const { return set_; }

 private:
  explicit Expression(ExpressionSet set);
  ExpressionSet set_;
  ExpressionWorkspace work_;
};

/// Value of a formula of constants only, as in mass="{2*rho*V}". Raises ExpressionError, also if a
/// variable occurs.
double evaluateConstant(std::string_view text, const SymbolTable& symbols);

}  // namespace dynamy
