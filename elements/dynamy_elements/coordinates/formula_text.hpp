/// Formulas of an attribute with their places in the file, and a tape with its registers.
///
///   text "a ; b ; c" → parts → ExpressionCompiler → ExpressionSet
///
/// Formulas of contacts are compiled in connect(), when the names of the coordinates are known and
/// the file is already closed. The places are therefore looked up once, when the element is made.
/// Keeping the document alive was rejected: elements would then depend on what created them.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/expression/expression.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// The formulas of one attribute, separated by ';', in rows separated by '|'; not yet compiled.
class FormulaText {
 public:
  FormulaText() = default;
  /// The value of attribute `attribute` of the element that is being made.
  FormulaText(const Parameters& x, std::string_view attribute);

  bool empty() const { return parts_.empty(); }
  int size() const { return static_cast<int>(parts_.size()); }
  int rows() const { return static_cast<int>(rowEnd_.size()); }  ///< 0 if empty
  /// All rows have n formulas.
  bool rowsHave(int n) const;
  /// Adds formula i to the compiler and returns its output; a fault goes to `faults` and gives −1.
  int compile(int i, ExpressionCompiler& compiler, Diagnostics& faults) const;
  /// Adds all formulas in their order.
  void compileAll(ExpressionCompiler& compiler, Diagnostics& faults) const;
  /// Names of signals in formula i, with their places in the file.
  std::vector<std::pair<std::string, Place>> signals(int i) const;
  /// Fault that concerns formula i as a whole; i < 0: the whole attribute.
  Diagnostic fault(int i, std::string text, std::string hint = {}) const;

 private:
  Diagnostic faultAt(std::size_t offset, std::size_t length, std::string text,
                     std::string hint) const;
  void split();
  struct Spot {
    int line = 0, column = 0;
  };
  std::string element_, attribute_, text_, file_;
  std::vector<ValuePart> parts_;
  std::vector<int> rowEnd_;  // index behind the last part of each row
  std::vector<Spot> spots_;  // place of every byte in the file; empty: made in C++
};

/// Names that formulas of one system may use, and their slots in the input array
/// x = (t, q, u, signals).
class FormulaNames {
 public:
  std::vector<std::string> q, u;  ///< names of positions and velocities, in their order
  std::vector<std::pair<std::string, double>> parameters;  ///< of the model
  std::vector<std::string> signals;                        ///< of other elements

  int n() const { return static_cast<int>(q.size()); }
  int inputs() const { return 1 + 2 * n() + static_cast<int>(signals.size()); }
  static constexpr int kTime = 0;
  int qSlot(int i) const { return 1 + i; }
  int uSlot(int i) const { return 1 + n() + i; }
  std::vector<int> qSlots() const;
  std::vector<int> uSlots() const;
  SymbolTable symbols() const;
};

/// A set of formulas with registers and results of its own. One thread at a time.
class Tape {
 public:
  Tape(ExpressionSet set, const FormulaNames& names);
  const ExpressionSet& set() const { return set_; }

  /// f(x); the result stays valid until the next call.
  const double* eval(const double* x);
  /// ∂f/∂x_slots, column after column.
  const double* gradient(const double* x, const std::vector<int>& slots);
  /// f′(x) v.
  const double* derivative(const double* x, const double* v);
  /// vᵀ f″(x) w.
  const double* second(const double* x, const double* v, const double* w);
  /// ∂f/∂x_slot.
  const double* partial(const double* x, int slot);
  /// ∂²f/∂x_i∂x_j.
  const double* secondPartial(const double* x, int i, int j);
  /// Does any output depend on one of the slots?
  bool dependsOn(const std::vector<int>& slots) const;
  /// First instant after t at which any formula jumps or has a kink, as
  /// far as time alone causes it.
  double nextInstant(double t) const { return set_.nextInstant(t, FormulaNames::kTime); }

  const double* value() const { return value_.data(); }            ///< f of the last call
  const double* firstDerivative() const { return first_.data(); }  ///< f′v of the last second()

 private:
  ExpressionSet set_;
  ExpressionWorkspace work_;
  std::vector<double> value_, first_, other_, second_, gradient_, v_, w_;
};

}  // namespace dynamy
