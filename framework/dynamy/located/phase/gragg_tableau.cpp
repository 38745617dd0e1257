#include <dynamy/located/phase/gragg_tableau.hpp>
#include <stdexcept>
#include <vector>

namespace dynamy {
namespace {

/// A tableau that owns its coefficients.
struct Gragg {
  explicit Gragg(std::size_t columns) {
    const std::size_t stages = 1 + columns * columns;
    nodes.assign(stages + 1, 0.0), a.assign((stages + 1) * stages, 0.0);
    error.assign(stages + 1, 0.0);
    std::size_t first = 0;  // η₁ of the column is stage first + 1
    for (std::size_t j = 1; j <= columns; ++j) {
      column(j, columns, first);
      first += 2 * j - 1;
    }
    if (columns == 1) error[0] = -1.0;  // error estimate: difference to Euler's rule
    nodes[stages] = 1.0;
    table = {.order = static_cast<int>(2 * columns),
             .stages = static_cast<int>(stages),
             .denseStages = 0,
             .denseRows = 0,
             .stride = static_cast<int>(stages),
             .nodes = nodes.data(),
             .a = a.data(),
             .error = error.data(),
             .error3 = nullptr,
             .dense = nullptr};
  }
  void column(std::size_t j, std::size_t columns, std::size_t first) {
    const std::size_t n = 2 * j, stages = nodes.size() - 1;
    const double h = 1.0 / static_cast<double>(n);
    const auto stage = [&](std::size_t k) { return k == 0 ? 0 : first + k; };
    // η_k − y: all odd stages before an even k, all even ones before an odd k; f(y) counts once.
    for (std::size_t k = 1; k < n; ++k) {
      nodes[stage(k)] = static_cast<double>(k) * h;
      for (std::size_t i = (k + 1) % 2; i < k; i += 2)
        a[stage(k) * stages + stage(i)] = i == 0 ? h : 2.0 * h;
    }
    const double best = weight(j, 1, columns), less = weight(j, 2, columns);
    for (std::size_t i = 1; i < n; i += 2) {
      a[stages * stages + stage(i)] = best * 2.0 * h;
      error[stage(i)] = (best - less) * 2.0 * h;
    }
  }
  /// Share of T_{j,1} in what columns from … to extrapolate to: Π n_j²/(n_j² − n_i²).
  static double weight(std::size_t j, std::size_t from, std::size_t to) {
    if (j < from) return 0.0;
    double w = 1.0;
    const auto square = [](std::size_t n) { return static_cast<double>(n * n); };
    for (std::size_t i = from; i <= to; ++i)
      if (i != j) w *= square(j) / (square(j) - square(i));
    return w;
  }

  std::vector<double> nodes, a, error;
  ButcherTableau table{};
};

}  // namespace

const ButcherTableau& graggTableau(int order) {
  static const Gragg kTwo(1), kFour(2), kSix(3), kEight(4);
  switch (order) {
    case 2:
      return kTwo.table;
    case 4:
      return kFour.table;
    case 6:
      return kSix.table;
    case 8:
      return kEight.table;
    default:
      throw std::invalid_argument("Gragg's extrapolation: order is 2, 4, 6 or 8");
  }
}

}  // namespace dynamy
