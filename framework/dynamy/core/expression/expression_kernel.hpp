/// One operation of the tape on numbers with 0, 1 or 2 derivatives.
#pragma once

#include <cmath>
#include <cstddef>
#include <dynamy/core/dual.hpp>
#include <dynamy/core/expression/expression_graph.hpp>

namespace dynamy {

/// Registers of a tape: one array for values and one for each derivative. Rejected: an array of
/// Jets, measured up to two times slower with one derivative, since compilers join its two doubles
/// into one load that waits for two stores.
template <int N>
struct Registers {
  double* v;
  double* d1;
  double* d2;
  double* d12;

  Jet<N> load(std::size_t i) const {
    if constexpr (N == 0) return {v[i]};
    if constexpr (N == 1) return {v[i], d1[i]};
    if constexpr (N == 2) return {v[i], d1[i], d2[i], d12[i]};
  }

  void store(std::size_t i, const Jet<N>& x) const {
    v[i] = x.v;
    if constexpr (N >= 1) d1[i] = x.d1;
    if constexpr (N == 2) d2[i] = x.d2;
    if constexpr (N == 2) d12[i] = x.d12;
  }
};

/// Value of a condition: 1 or 0, derivatives 0.
template <int N>
Jet<N> truth(bool condition) {
  return constantJet<N>(condition ? 1.0 : 0.0);
}

template <int N>
Jet<N> signOf(const Jet<N>& x) {
  return constantJet<N>(x.v > 0.0 ? 1.0 : x.v < 0.0 ? -1.0 : x.v);
}

/// Result of an instruction on its operands.
template <int N>
inline Jet<N> applyInstruction(const Instruction& k, const Registers<N>& registers) {
  const auto a = [&] { return registers.load(k.a); };
  const auto b = [&] { return registers.load(k.b); };
  const auto c = [&] { return registers.load(k.c); };
  // clang-format off
  switch (k.op) {
    case Op::negate:        return -a();
    case Op::sin:           return sin(a());
    case Op::cos:           return cos(a());
    case Op::tan:           return tan(a());
    case Op::asin:          return asin(a());
    case Op::acos:          return acos(a());
    case Op::atan:          return atan(a());
    case Op::sinh:          return sinh(a());
    case Op::cosh:          return cosh(a());
    case Op::tanh:          return tanh(a());
    case Op::exp:           return exp(a());
    case Op::log:           return log(a());
    case Op::log10:         return log10(a());
    case Op::sqrt:          return sqrt(a());
    case Op::abs:           return abs(a());
    case Op::sign:          return signOf(a());
    case Op::floor:         return constantJet<N>(std::floor(a().v));
    case Op::ceil:          return constantJet<N>(std::ceil(a().v));
    case Op::logicalNot:    return truth<N>(a().v == 0.0);
    case Op::add:           return a() + b();
    case Op::subtract:      return a() - b();
    case Op::multiply:      return a() * b();
    case Op::divide:        return a() / b();
    case Op::power:         return pow(a(), b());
    case Op::powerConstant: return powConstant(a(), b().v);
    case Op::atan2:         return atan2(a(), b());
    case Op::min:           return min(a(), b());
    case Op::max:           return max(a(), b());
    case Op::mod:           return mod(a(), b());
    case Op::hypot:         return hypot(a(), b());
    case Op::less:          return truth<N>(a().v < b().v);
    case Op::lessEqual:     return truth<N>(a().v <= b().v);
    case Op::equal:         return truth<N>(a().v == b().v);
    case Op::notEqual:      return truth<N>(a().v != b().v);
    case Op::logicalAnd:    return truth<N>(a().v != 0.0 && b().v != 0.0);
    case Op::logicalOr:     return truth<N>(a().v != 0.0 || b().v != 0.0);
    case Op::select:        return a().v != 0.0 ? b() : c();
    case Op::variable:
    case Op::constant:      break;
  }
  // clang-format on
  return a();
}

}  // namespace dynamy
