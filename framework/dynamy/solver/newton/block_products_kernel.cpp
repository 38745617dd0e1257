#include <cstddef>
#include <dynamy/solver/newton/block_products.hpp>

namespace dynamy {
namespace {

// Functions of registers are always inlined: how registers would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

constexpr int kBlock = 6;
constexpr std::ptrdiff_t kColumn = 2 * kBlock, kNumbers = kColumn * kBlock;

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
template <int n>
[[gnu::always_inline]] inline void subtractProducts(double* blocks, const int* place,
                                                    const int* row, int count, const double* Y,
                                                    const double* K) {
  using Numbers = typename NumbersOf<n>::Type;
  constexpr int kParts = kColumn / n;
  for (int f = 0; f < count; ++f, Y += kNumbers) {
    auto* X = reinterpret_cast<Numbers*>(blocks + place[row[f]] * kNumbers);
    const auto* y = reinterpret_cast<const Numbers*>(Y);
    for (int c = 0; c < kBlock; ++c) {
      Numbers factor[kBlock];
      for (int k = 0; k < kBlock; ++k)
        for (int i = 0; i < n; ++i) factor[k][i] = K[c * kColumn + 2 * k + i % 2];
      for (int r = 0; r < kParts; ++r) {
        Numbers sum = y[r] * factor[0];
        for (int k = 1; k < kBlock; ++k) sum += y[k * kParts + r] * factor[k];
        X[c * kParts + r] -= sum;
      }
    }
  }
}

void subtractPlain(double* blocks, const int* place, const int* row, int count, const double* Y,
                   const double* K) {
  subtractProducts<2>(blocks, place, row, count, Y, K);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void subtractAvx2(double* blocks, const int* place, const int* row,
                                          int count, const double* Y, const double* K) {
  subtractProducts<4>(blocks, place, row, count, Y, K);
}
constexpr SubtractProducts kLevels[] = {subtractPlain, subtractAvx2};
std::size_t productLevelCount() { return __builtin_cpu_supports("avx2") ? 2 : 1; }
#else
constexpr SubtractProducts kLevels[] = {subtractPlain};
std::size_t productLevelCount() { return 1; }
#endif

}  // namespace

std::span<const SubtractProducts> productLevels() { return {kLevels, productLevelCount()}; }

}  // namespace dynamy
