/// Packing: places for many balls in a box without overlaps, and random numbers that are the same
/// on every machine.
#pragma once
#include <cstdint>
#include <dynamy/core/types.hpp>
#include <optional>
#include <vector>

namespace dynamy {

/// xorshift64*: the same numbers for a seed on every machine, which the distributions of the
/// standard library do not promise [Vigna, ACM TOMS 42 (2016) 30].
class SeededNumbers {
 public:
  explicit SeededNumbers(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 1u) {}
  /// Uniform in [0, 1).
  double uniform();
  double uniform(double a, double b) { return a + (b - a) * uniform(); }
  /// Standard normal distribution, by Box and Muller.
  double normal();
  /// Unit quaternion w x y z, uniform over all attitudes [Shoemake, Graphics Gems III].
  void attitude(double* p);

 private:
  std::uint64_t state_;
};

/// An upright box.
struct Region {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

/// Places in the middles of cells of edge `pitch`, off by up to `jitter` in each
/// direction. The cells begin at `region.low` and follow row by row along x, then y, in
/// layers along z. There are as many layers as needed: `region.high.z` is no limit.
/// Returns nothing if not one cell fits into a layer.
std::optional<std::vector<Vec3>> latticePlaces(std::size_t count, const Region& region,
                                               double pitch, double jitter, SeededNumbers& numbers);

/// Random places, the largest balls first; each is tried until it overlaps no other and is inside.
/// Returns nothing if a ball finds no place in 10 000 trials: about from 0.35 of the volume on.
std::optional<std::vector<Vec3>> randomPlaces(const std::vector<double>& radii,
                                              const Region& region, SeededNumbers& numbers);

}  // namespace dynamy
