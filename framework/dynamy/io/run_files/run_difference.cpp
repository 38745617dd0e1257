#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/io/run_files/run_difference.hpp>
#include <limits>
#include <utility>

namespace dynamy {
namespace {

/// Signals that vary by less than this part of the largest number of all are rounding.
constexpr double kRounding = 1e-14;
constexpr double kChaotic = 6.0;  ///< growth rate times duration, above which a run is chaotic

/// Pairs of rows at equal instants; of several rows at one instant the last one is taken.
std::vector<std::pair<std::size_t, std::size_t>> common(const std::vector<double>& a,
                                                        const std::vector<double>& b) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] < b[j]) {
      ++i;
    } else if (b[j] < a[i]) {
      ++j;
    } else {
      while (i + 1 < a.size() && a[i + 1] == a[i]) ++i;
      while (j + 1 < b.size() && b[j + 1] == b[j]) ++j;
      out.emplace_back(i++, j++);
    }
  }
  return out;
}

/// Least-squares slope of ln d over t in the rows [first, last).
double slope(const std::vector<double>& t, const std::vector<double>& d, std::size_t first,
             std::size_t last) {
  double n = 0.0, st = 0.0, sy = 0.0, stt = 0.0, sty = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    if (!(d[i] > 0.0)) continue;
    const double y = std::log(d[i]), at = t[i] - t[first];
    n += 1.0, st += at, sy += y, stt += at * at, sty += at * y;
  }
  const double D = n * stt - st * st;
  return n > 2.0 && D > 0.0 ? (n * sty - st * sy) / D : 0.0;
}

/// Whether the value a[i] lies in the range of b in the rows first … last around the same instant:
/// then a jump is only shifted in time.
bool onlyShifted(const std::vector<double>& a, std::size_t i, const std::vector<double>& b,
                 std::size_t first, std::size_t last) {
  const auto [low, high] = std::minmax_element(b.begin() + static_cast<std::ptrdiff_t>(first),
                                               b.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  return *low <= a[i] && a[i] <= *high;
}

}  // namespace

RunDifference runDifference(const SignalTable& a, const SignalTable& b, double noise) {
  RunDifference out;
  out.horizon = kInfinity;
  const auto rows = common(a.t, b.t);
  const std::size_t columns = std::min(a.columns.size(), b.columns.size());
  std::vector<double> t, d(rows.size(), 0.0);
  for (const auto& [i, j] : rows) t.push_back(a.t[i]);
  double largest = 0.0;
  for (std::size_t c = 0; c < columns; ++c)
    for (const double x : a.columns[c])
      if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
  for (std::size_t c = 0; c < columns; ++c) {
    SignalDifference s;
    s.name = a.signals[c].name;
    const auto [low, high] = std::minmax_element(a.columns[c].begin(), a.columns[c].end());
    const double range = a.columns[c].empty() ? 0.0 : *high - *low;
    const auto shifted = [&](std::size_t k) {
      const auto& [i0, j0] = rows[k - std::min<std::size_t>(k, 1)];
      const auto& [i1, j1] = rows[std::min(k + 1, rows.size() - 1)];
      return onlyShifted(a.columns[c], rows[k].first, b.columns[c], j0, j1) ||
             onlyShifted(b.columns[c], rows[k].second, a.columns[c], i0, i1);
    };
    for (std::size_t k = 0; k < rows.size(); ++k) {
      s.end = a.columns[c][rows[k].first];
      s.difference = std::abs(s.end - b.columns[c][rows[k].second]);
      if (s.difference > s.largest) s.largest = s.difference, s.t = t[k];
      if (!(range > kRounding * largest) || !(s.difference > noise * range)) continue;
      if (s.difference < RunDifference::kLost * range || !shifted(k))
        d[k] = std::max(d[k], s.difference / range);
    }
    out.signals.push_back(s);
  }
  for (std::size_t k = 1; k < d.size(); ++k) d[k] = std::max(d[k], d[k - 1]);
  if (t.size() < 3 || !(d.back() > 0.0)) return out;
  const auto lost =
      std::find_if(d.begin(), d.end(), [](double x) { return x >= RunDifference::kLost; });
  // Differences as large as the signals stop growing, so only rows before are used.
  const auto told = static_cast<std::size_t>(lost - d.begin());
  out.growth = slope(t, d, told / 2, told);
  out.chaotic = told > 0 && out.growth * (t[told - 1] - t.front()) > kChaotic;
  if (lost != d.end())
    out.horizon = t[static_cast<std::size_t>(lost - d.begin())];
  else if (out.chaotic)
    out.horizon = t.back() + std::log(RunDifference::kLost / d.back()) / out.growth;
  return out;
}

}  // namespace dynamy
