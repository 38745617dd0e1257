#include <algorithm>
#include <cmath>
#include <dynamy_elements/bodies/packing.hpp>
#include <numbers>
#include <numeric>
#include <unordered_map>

namespace dynamy {

double SeededNumbers::uniform() {
  state_ ^= state_ >> 12, state_ ^= state_ << 25, state_ ^= state_ >> 27;
  return static_cast<double>((state_ * 0x2545F4914F6CDD1Du) >> 11) * 0x1p-53;
}

double SeededNumbers::normal() {
  const double r = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return r * std::cos(2.0 * std::numbers::pi * uniform());
}

void SeededNumbers::attitude(double* p) {
  const double s = uniform(), a = 2.0 * std::numbers::pi * uniform(),
               b = 2.0 * std::numbers::pi * uniform();
  p[0] = std::sqrt(1.0 - s) * std::sin(a), p[1] = std::sqrt(1.0 - s) * std::cos(a);
  p[2] = std::sqrt(s) * std::sin(b), p[3] = std::sqrt(s) * std::cos(b);
}

std::optional<std::vector<Vec3>> latticePlaces(std::size_t count, const Region& region,
                                               double pitch, double jitter,
                                               SeededNumbers& numbers) {
  // A width that is up to rounding a whole number of cells holds all of these cells.
  const Vec3 width = region.high - region.low;
  const double nx = std::floor(width.x() / pitch + 1e-9), ny = std::floor(width.y() / pitch + 1e-9);
  if (nx < 1.0 || ny < 1.0) return std::nullopt;
  // Cells beyond the number of grains stay empty; their number may exceed the range of integers.
  const auto most = static_cast<double>(std::max<std::size_t>(count, 1));
  const auto x = static_cast<std::size_t>(std::min(nx, most)),
             y = static_cast<std::size_t>(std::min(ny, most));
  std::vector<Vec3> out;
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t column = i % x, row = i / x % y, layer = i / (x * y);
    const Vec3 cell(static_cast<double>(column), static_cast<double>(row),
                    static_cast<double>(layer));
    Vec3 c = region.low + pitch * (cell + Vec3::Constant(0.5));
    for (double& coordinate : c) coordinate += numbers.uniform(-jitter, jitter);
    out.push_back(c);
  }
  return out;
}

namespace {

/// Balls in cells whose edge is the largest diameter: balls that overlap a ball are in 27 cells.
class PlacedGrains {
 public:
  PlacedGrains(double edge, const std::vector<Vec3>& c, const std::vector<double>& radii)
      : edge_(edge), c_(c), radii_(radii) {}
  void add(std::size_t i) { cells_[key(c_[i], 0, 0, 0)].push_back(i); }
  bool isFree(const Vec3& c, double radius) const {
    for (int k = 0; k < 27; ++k) {
      const auto cell = cells_.find(key(c, k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1));
      if (cell == cells_.end()) continue;
      for (const std::size_t j : cell->second)
        if ((c_[j] - c).norm() < radius + radii_[j]) return false;
    }
    return true;
  }

 private:
  /// Key of a cell, 21 bits for each coordinate. Cells that share a key only cost time.
  std::uint64_t key(const Vec3& c, int dx, int dy, int dz) const {
    const auto at = [&](double x, int d) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / edge_)) + d) &
             0x1FFFFFu;
    };
    return at(c.x(), dx) << 42 | at(c.y(), dy) << 21 | at(c.z(), dz);
  }
  double edge_;
  const std::vector<Vec3>& c_;
  const std::vector<double>& radii_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

}  // namespace

std::optional<std::vector<Vec3>> randomPlaces(const std::vector<double>& radii,
                                              const Region& region, SeededNumbers& numbers) {
  constexpr int kTrials = 10000;
  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  std::vector<Vec3> out(radii.size());
  if (order.empty()) return out;
  PlacedGrains placed(2.0 * radii[order.front()], out, radii);
  for (const std::size_t i : order) {
    const Vec3 low = region.low + Vec3::Constant(radii[i]),
               high = region.high - Vec3::Constant(radii[i]);
    if ((low.array() > high.array()).any()) return std::nullopt;
    bool found = false;
    for (int trial = 0; trial < kTrials && !found; ++trial) {
      Vec3 c;
      for (int k = 0; k < 3; ++k) c[k] = numbers.uniform(low[k], high[k]);
      if (!placed.isFree(c, radii[i])) continue;
      out[i] = c, found = true;
      placed.add(i);
    }
    if (!found) return std::nullopt;
  }
  return out;
}

}  // namespace dynamy
