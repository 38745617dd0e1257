// Random points and metrics for the tests of convex sets; every test names its seed.
#pragma once

#include <dynamy/law/convex_sets.hpp>
#include <iostream>
#include <random>
#include <vector>

namespace dynamy::convex {

using P2 = Point<2>;
using P3 = Point<3>;
inline constexpr double kEps = std::numeric_limits<double>::epsilon();
inline constexpr int kTrials = 300;

// Normally distributed; positive numbers are their exponentials.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) { std::cout << "seed " << seed << '\n'; }
  template <int n>
  Point<n> point(double size = 1.0) {
    Point<n> x;
    for (int i = 0; i < n; ++i) x[i] = size * normal_(engine_);
    return x;
  }
  template <int n>
  Matrix<n> metric() {  // condition about 10 to 100
    Matrix<n> A;
    for (int i = 0; i < n * n; ++i) A(i) = normal_(engine_);
    return A * A.transpose() + 0.2 * Matrix<n>::Identity();
  }
  double positive() { return std::exp(normal_(engine_)); }
  template <int n>
  Point<n> positives() {
    Point<n> a;
    for (int i = 0; i < n; ++i) a[i] = positive();
    return a;
  }

 private:
  std::mt19937 engine_;
  std::normal_distribution<double> normal_;
};

inline std::vector<P2> pentagon() {
  std::vector<P2> corners;
  for (int i = 0; i < 5; ++i) corners.push_back(P2(2 * std::cos(1.2566 * i), std::sin(1.2566 * i)));
  return corners;
}
}  // namespace dynamy::convex
