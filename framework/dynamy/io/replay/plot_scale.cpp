#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <dynamy/io/replay/plot_scale.hpp>

namespace dynamy {

Ticks niceTicks(double lo, double hi, int most) {
  Ticks ticks;
  const double span = hi - lo;
  if (!(span > 0) || !std::isfinite(span)) {
    ticks.values.push_back(lo);
    return ticks;
  }
  double power = std::pow(10.0, std::floor(std::log10(span / most)));
  constexpr std::array factors{1.0, 2.0, 5.0, 10.0, 20.0};
  for (const double factor : factors) {
    ticks.step = factor * power;
    const double first = std::ceil(lo / ticks.step - 1e-9);
    const double last = std::floor(hi / ticks.step + 1e-9);
    if (last - first + 1 > most) continue;
    // multiples by counting, so that 0 is 0; 0.0 + … turns -0 into 0
    for (double k = first; k <= last; k += 1) ticks.values.push_back(0.0 + k * ticks.step);
    break;
  }
  return ticks;
}

std::string tickLabel(double value, double step) {
  std::array<char, 32> text{};
  const double size = std::max(std::abs(value), step);
  if (size >= 1e5 || size < 1e-3) {
    // digits of the mantissa: from the leading digit of the value down to that of the step
    const double leading = value == 0 ? 0 : std::floor(std::log10(std::abs(value)) + 1e-9);
    const int digits =
        value == 0 ? 0 : static_cast<int>(leading - std::floor(std::log10(step) + 1e-9));
    if (value == 0) return "0";
    std::snprintf(text.data(), text.size(), "%.*e", std::clamp(digits, 0, 12), value);
    // 1.5e-06 → 1.5e-6
    std::string label = text.data();
    const std::size_t e = label.find('e');
    const int exponent = std::atoi(label.c_str() + e + 1);
    return label.substr(0, e + 1) + std::to_string(exponent);
  }
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  std::snprintf(text.data(), text.size(), "%.*f", std::min(decimals, 12), value);
  return text.data();
}

std::vector<std::size_t> thinned(std::span<const double> t, std::span<const double> y,
                                 std::size_t columns) {
  const std::size_t n = std::min(t.size(), y.size());
  std::vector<std::size_t> kept;
  if (n <= 4 * columns) {
    for (std::size_t i = 0; i < n; ++i) kept.push_back(i);
    return kept;
  }
  const double width = (t[n - 1] - t[0]) / static_cast<double>(columns);
  std::size_t i = 0;
  for (std::size_t column = 0; column < columns && i < n; ++column) {
    const double end = t[0] + width * static_cast<double>(column + 1);
    std::array<std::size_t, 4> few{i, i, i, i};  // first, smallest, largest, last
    const bool lastColumn = column + 1 == columns;
    for (; i < n && (lastColumn || t[i] < end); ++i) {
      if (!std::isfinite(y[i])) few[1] = few[2] = i;
      if (y[i] < y[few[1]]) few[1] = i;
      if (y[i] > y[few[2]]) few[2] = i;
      few[3] = i;
    }
    if (i == few[0]) continue;  // no point in this column
    std::sort(few.begin(), few.end());
    for (const std::size_t k : few) {
      if (kept.empty() || k > kept.back()) kept.push_back(k);
    }
  }
  return kept;
}

}  // namespace dynamy
