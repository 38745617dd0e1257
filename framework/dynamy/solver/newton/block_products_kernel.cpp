#include <cstddef>
#include <dynamy/solver/newton/block_products.hpp>

namespace dynamy {
namespace {

// Functions of registers are always inlined: how registers would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

template <int n>
struct NumbersOf;
template <>
struct NumbersOf<2> {
  using Type = double __attribute__((vector_size(16), aligned(16)));
};
template <>
struct NumbersOf<4> {
  using Type = double __attribute__((vector_size(32), aligned(16)));
};

/// n numbers of a column in a register.
template <int B, int n>
[[gnu::always_inline]] inline void subtractProducts(double* blocks, const int* place,
                                                    const int* row, int count, const double* Y,
                                                    const double* K) {
  using Numbers = typename NumbersOf<n>::Type;
  constexpr std::ptrdiff_t kColumn = 2 * B, kNumbers = kColumn * B;
  constexpr int kParts = kColumn / n;
  for (int f = 0; f < count; ++f, Y += kNumbers) {
    auto* X = reinterpret_cast<Numbers*>(blocks + place[row[f]] * kNumbers);
    const auto* y = reinterpret_cast<const Numbers*>(Y);
    for (int c = 0; c < B; ++c) {
      Numbers factor[B];
      for (int k = 0; k < B; ++k)
        for (int i = 0; i < n; ++i) factor[k][i] = K[c * kColumn + 2 * k + i % 2];
      for (int r = 0; r < kParts; ++r) {
        Numbers sum = y[r] * factor[0];
        for (int k = 1; k < B; ++k) sum += y[k * kParts + r] * factor[k];
        X[c * kParts + r] -= sum;
      }
    }
  }
}

template <int B>
void subtractPlain(double* blocks, const int* place, const int* row, int count, const double* Y,
                   const double* K) {
  subtractProducts<B, 2>(blocks, place, row, count, Y, K);
}
template <int B>
constexpr SubtractProducts kPlain[] = {subtractPlain<B>};

#if defined(__x86_64__)
[[gnu::target("avx2")]] void subtractAvx2(double* blocks, const int* place, const int* row,
                                          int count, const double* Y, const double* K) {
  subtractProducts<6, 4>(blocks, place, row, count, Y, K);
}
constexpr SubtractProducts kOfSix[] = {subtractPlain<6>, subtractAvx2};
std::size_t levelsOfSix() { return __builtin_cpu_supports("avx2") ? 2 : 1; }
#else
constexpr SubtractProducts kOfSix[] = {subtractPlain<6>};
std::size_t levelsOfSix() { return 1; }
#endif

}  // namespace

template <int B>
std::span<const SubtractProducts> productLevels() {
  if constexpr (B == 6)
    return {kOfSix, levelsOfSix()};
  else
    return kPlain<B>;
}
template std::span<const SubtractProducts> productLevels<2>();
template std::span<const SubtractProducts> productLevels<3>();
template std::span<const SubtractProducts> productLevels<6>();

}  // namespace dynamy
