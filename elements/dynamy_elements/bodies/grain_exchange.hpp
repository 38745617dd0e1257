/// GrainExchange: which grains of a population are present; a feeder
/// adds them, a sink removes them.
///
///   present   |p| = 1;  absent   p = 0, u = 0, r at the feeder        (38.8)
///   fed in (tA, tE]      floor(ν tE) − floor(ν tA)   of them, the lowest numbers that are absent
///   taken at tE          those whose centre is in the sink's box
///
/// Presence is part of q, so that it is restored with a checkpoint and with a rejected step. Where
/// the k-th grain of the feeder appears depends on the seed and k alone; if other grains are in the
/// way in all of several tries, it is not fed.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/renewable.hpp>
#include <dynamy_elements/bodies/packing.hpp>

namespace dynamy {

class GrainExchange final : public Renewable {
 public:
  static void declare(Attributes& a);
  /// `grain`: radius of the ball around each grain [m].
  GrainExchange(const Parameters& x, std::vector<double> grain);
  bool any() const { return rate_ > 0.0 || sink_.has_value(); }
  /// Number of grains that are present at the start.
  int present() const { return present_; }
  /// Makes a grain absent; `q`, `u`: coordinates and velocities of this grain.
  void remove(double* q, double* u) const;
  static bool absent(const double* q) {
    return q[3] == 0.0 && q[4] == 0.0 && q[5] == 0.0 && q[6] == 0.0;
  }
  /// Instant of the feeder's next grain after t [s]; infinity: never.
  double nextFeed(double t) const;
  /// Can grains still be fed? With a sink always. `q`: of all grains, or empty if unknown.
  bool mayFeed(ConstVec q) const;
  bool renew(double tA, double tE, Vec q, Vec u) const override;

 private:
  void feed(std::uint64_t number, Vec q, Vec u, bool& changed) const;
  bool isFree(const Vec3& c, double radius, ConstVec q) const;
  std::vector<double> radius_;
  int present_ = 0;
  double rate_ = 0.0;  // [1/s]
  Region feeder_;
  std::optional<Region> sink_;
  bool turned_ = false;
  std::uint64_t seed_ = 0;
  Vec3 velocity_;
};

}  // namespace dynamy
