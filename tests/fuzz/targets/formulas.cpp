/// Formulas: any text gives a formula, or an ExpressionError that points into the text. What is
/// compiled can be evaluated, with its derivatives and its next instant.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <string_view>

namespace dynamy {
namespace {

void promise(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

SymbolTable symbols() {
  SymbolTable table;
  for (const char* name : {"t", "phi", "toy.z"}) table.variable(name);
  table.constant("a", 2.0), table.constant("µ", 0.3);
  return table;
}

template <class Call>
void tried(std::string_view text, const Call& call) {
  try {
    call();
  } catch (const ExpressionError& e) {
    promise(e.offset() <= text.size() && e.length() <= text.size() - e.offset(),
            "an error points into the text");
    promise(!e.message().empty() && !e.report(text).empty(), "an error says what is wrong");
  }
}

void formula(std::string_view text) {
  static const SymbolTable table = symbols();
  Expression f = Expression::compile(text, table);
  const std::array<double, 3> x{0.5, -1.25, 3.0}, v{1.0, 0.5, -2.0}, w{0.0, 1.0, 1.0};
  f.value(x.data()), f.derivative(x.data(), v.data());
  f.secondDerivative(x.data(), v.data(), w.data());
  const std::array<int, 2> affine{0, 1};
  f.set().isAffine(0, affine);
  promise(!(f.set().nextInstant(0.25, 0) <= 0.25), "the next instant is later");
}

}  // namespace
}  // namespace dynamy

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  dynamy::tried(text, [&] { dynamy::formula(text); });
  dynamy::tried(text, [&] { dynamy::evaluateConstant(text, dynamy::SymbolTable()); });
  dynamy::tried(text, [&] { dynamy::parseQuantity(text); });
  return 0;
}
