#pragma once
/// \file
/// Ticks at 1, 2 or 5 times a power of ten, and curves thinned to the smallest and the largest
/// value of each pixel column. So peaks of impacts are kept, which drawing every n-th point would
/// lose.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace dynamy {

/// Ticks of an axis: `values` inside [lo, hi], all multiples of `step`.
struct Ticks {
  double step = 1;
  std::vector<double> values;
};

/// At most `most` (≥ 2) ticks inside [lo, hi] with the smallest step of the form 1, 2, 5 · 10^k.
Ticks niceTicks(double lo, double hi, int most);

/// `value`, a multiple of `step`, with the decimals that distinguish neighbours: "0.25", "1e6",
/// "-3".
std::string tickLabel(double value, double step);

/// Indices, in order, of the points that are drawn when t is cut into `columns` equal intervals: of
/// each interval the first, smallest, largest and last point. If there are few points, all are
/// drawn. Points that are not finite are kept, as gaps of the curve.
std::vector<std::size_t> thinned(std::span<const double> t, std::span<const double> y,
                                 std::size_t columns);

}  // namespace dynamy
