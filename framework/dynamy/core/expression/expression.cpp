#include <algorithm>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/core/expression/expression_kernel.hpp>
#include <dynamy/core/expression/expression_parser.hpp>
#include <utility>

namespace dynamy {

ExpressionWorkspace::ExpressionWorkspace(const ExpressionSet& set)
    : values_(set.firstResult() + set.tape_.size(), 0.0),
      derivatives1_(values_),
      derivatives2_(values_),
      derivatives12_(values_) {
  std::copy(set.constants_.begin(), set.constants_.end(), values_.begin() + set.inputCount_);
}

template <int N>
void ExpressionSet::run(ExpressionWorkspace& work) const noexcept {
  const Registers<N> registers{work.values_.data(), work.derivatives1_.data(),
                               work.derivatives2_.data(), work.derivatives12_.data()};
  std::size_t result = firstResult();
  for (const Instruction& k : tape_) registers.store(result++, applyInstruction(k, registers));
}

void ExpressionSet::eval(const double* x, double* out, ExpressionWorkspace& work) const noexcept {
  std::copy_n(x, inputCount_, work.values_.begin());
  run<0>(work);
  for (const std::uint32_t o : outputs_) *out++ = work.values_[o];
}

void ExpressionSet::evalD(const double* x, const double* v, double* out, double* dout,
                          ExpressionWorkspace& work) const noexcept {
  std::copy_n(x, inputCount_, work.values_.begin());
  std::copy_n(v, inputCount_, work.derivatives1_.begin());
  run<1>(work);
  for (const std::uint32_t o : outputs_) {
    *out++ = work.values_[o];
    *dout++ = work.derivatives1_[o];
  }
}

void ExpressionSet::evalDD(const double* x, const double* v, const double* w, double* out,
                           double* dout1, double* dout2, double* ddout,
                           ExpressionWorkspace& work) const noexcept {
  // The inputs are linear along v and w: their registers of second derivatives stay 0.
  std::copy_n(x, inputCount_, work.values_.begin());
  std::copy_n(v, inputCount_, work.derivatives1_.begin());
  std::copy_n(w, inputCount_, work.derivatives2_.begin());
  run<2>(work);
  for (const std::uint32_t o : outputs_) {
    *out++ = work.values_[o];
    *dout1++ = work.derivatives1_[o];
    *dout2++ = work.derivatives2_[o];
    *ddout++ = work.derivatives12_[o];
  }
}

void ExpressionSet::gradient(const double* x, std::span<const int> variables, double* out,
                             double* J, ExpressionWorkspace& work) const noexcept {
  std::copy_n(x, inputCount_, work.values_.begin());
  std::fill_n(work.derivatives1_.begin(), inputCount_, 0.0);
  if (variables.empty()) run<0>(work);
  for (const int j : variables) {
    // One sweep along the unit vector e_j gives column j.
    double& seed = work.derivatives1_[static_cast<std::size_t>(j)];
    seed = 1.0;
    run<1>(work);
    for (const std::uint32_t o : outputs_) *J++ = work.derivatives1_[o];
    seed = 0.0;
  }
  for (const std::uint32_t o : outputs_) *out++ = work.values_[o];
}

bool ExpressionSet::dependsOn(int output, int variable) const {
  // Everything reachable from the variable, found by one pass forward.
  std::vector<bool> reached(firstResult() + tape_.size(), false);
  if (variable < 0 || variable >= inputCount_) return false;
  reached[static_cast<std::size_t>(variable)] = true;
  std::size_t result = firstResult();
  for (const Instruction& k : tape_) {
    const int n = operandCount(k.op);
    reached[result++] = reached[k.a] || (n > 1 && reached[k.b]) || (n > 2 && reached[k.c]);
  }
  return reached[outputs_[static_cast<std::size_t>(output)]];
}

bool ExpressionSet::isConstant(int output) const {
  const std::uint32_t o = outputs_[static_cast<std::size_t>(output)];
  return o >= static_cast<std::uint32_t>(inputCount_) && o < firstResult();
}

namespace {

/// Degree of an operation in the listed variables from those of its operands: 0 free, 1 affine, 2
/// anything else.
int degreeOf(Op op, int a, int b, int c) {
  switch (op) {
    case Op::negate:
      return a;
    case Op::add:
    case Op::subtract:
      return std::max(a, b);
    case Op::multiply:
      return std::min(a + b, 2);
    case Op::divide:
      return b == 0 ? a : 2;
    case Op::select:
      return a == 0 ? std::max(b, c) : 2;
    default:
      return a == 0 && b == 0 && c == 0 ? 0 : 2;
  }
}

}  // namespace

bool ExpressionSet::isAffine(int output, std::span<const int> variables) const {
  std::vector<int> degree(firstResult() + tape_.size(), 0);
  for (const int j : variables) degree[static_cast<std::size_t>(j)] = 1;
  std::size_t result = firstResult();
  for (const Instruction& k : tape_) {
    const int n = operandCount(k.op);
    degree[result++] =
        degreeOf(k.op, degree[k.a], n > 1 ? degree[k.b] : 0, n > 2 ? degree[k.c] : 0);
  }
  return degree[outputs_[static_cast<std::size_t>(output)]] < 2;
}

ExpressionCompiler::ExpressionCompiler(SymbolTable symbols, bool simplifies)
    : symbols_(std::move(symbols)), graph_(simplifies) {}

int ExpressionCompiler::add(std::string_view text) {
  outputs_.push_back(parseExpression(text, symbols_, graph_, ConstantParts::finite));
  return static_cast<int>(outputs_.size()) - 1;
}

ExpressionSet ExpressionCompiler::finish() const {
  const std::vector<Instruction>& nodes = graph_.nodes();

  // Mark what the outputs need, from the last node to the first.
  std::vector<bool> needed(nodes.size(), false);
  for (const ExpressionGraph::Node o : outputs_) needed[o] = true;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const int n = needed[i] ? operandCount(nodes[i].op) : 0;
    if (n > 0) needed[nodes[i].a] = true;
    if (n > 1) needed[nodes[i].b] = true;
    if (n > 2) needed[nodes[i].c] = true;
  }

  // Registers: inputs, then constants, then results in order.
  ExpressionSet set;
  set.inputCount_ = symbols_.variableCount();
  std::vector<std::uint32_t> place(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].op == Op::variable) place[i] = nodes[i].a;
    if (nodes[i].op != Op::constant || !needed[i]) continue;
    place[i] = set.firstResult();
    set.constants_.push_back(graph_.value(static_cast<ExpressionGraph::Node>(i)));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int n = operandCount(nodes[i].op);
    if (n == 0 || !needed[i]) continue;
    place[i] = set.firstResult() + static_cast<std::uint32_t>(set.tape_.size());
    set.tape_.push_back({nodes[i].op, place[nodes[i].a], n > 1 ? place[nodes[i].b] : 0,
                         n > 2 ? place[nodes[i].c] : 0});
  }
  for (const ExpressionGraph::Node o : outputs_) set.outputs_.push_back(place[o]);
  return set;
}

Expression::Expression(ExpressionSet set) : set_(std::move(set)), work_(set_) {}

Expression Expression::compile(std::string_view text, const SymbolTable& symbols) {
  ExpressionCompiler compiler(symbols);
  compiler.add(text);
  return Expression(compiler.finish());
}

double Expression::value(const double* x) {
  double out = 0.0;
  set_.eval(x, &out, work_);
  return out;
}

double Expression::derivative(const double* x, const double* v) {
  double out = 0.0;
  double dout = 0.0;
  set_.evalD(x, v, &out, &dout, work_);
  return dout;
}

double Expression::secondDerivative(const double* x, const double* v, const double* w) {
  double out = 0.0;
  double dout1 = 0.0;
  double dout2 = 0.0;
  double ddout = 0.0;
  set_.evalDD(x, v, w, &out, &dout1, &dout2, &ddout, work_);
  return ddout;
}

double evaluateConstant(std::string_view text, const SymbolTable& symbols) {
  ExpressionGraph graph;
  const ExpressionGraph::Node node = parseExpression(text, symbols, graph);
  if (!graph.isConstant(node)) {
    throw ExpressionError("the value must be constant, but the expression contains a variable", 0,
                          text.size());
  }
  return graph.value(node);
}

}  // namespace dynamy
