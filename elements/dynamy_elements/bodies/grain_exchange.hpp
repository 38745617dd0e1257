/// GrainExchange: which grains of a population are there; a feeder brings them, a sink takes them.
///
///   present   |p| = 1;  absent   p = 0, u = 0, r at the feeder        (38.8)
///   fed in (tA, tE]      floor(ν tE) − floor(ν tA)   of them, the lowest numbers that are absent
///   taken at tE          those whose centre is in the sink's box
///
/// The mask lies in q, so that a checkpoint and a step taken back know it without a word. Where the
/// k-th grain of the feeder appears depends on the seed and k alone; if others are in the way after
/// some tries it does not come.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/bodies/packing.hpp>

namespace dynamy {

class GrainExchange {
 public:
  static void declare(Attributes& a);
  /// `grain`: radius of the ball around each grain [m].
  GrainExchange(const Parameters& x, std::vector<double> grain);
  bool any() const { return rate_ > 0.0 || sink_.has_value(); }
  /// How many are there at the start.
  int present() const { return present_; }
  /// Makes grain i of q, u absent.
  void remove(double* q, double* u) const;
  static bool absent(const double* q) {
    return q[3] == 0.0 && q[4] == 0.0 && q[5] == 0.0 && q[6] == 0.0;
  }
  /// When the feeder brings the next one after t; infinity: never.
  double nextFeed(double t) const;
  /// Whether grains may still come: with a sink always. `q`: of all grains, or empty if unknown.
  bool mayFeed(ConstVec q) const;
  bool renew(double tA, double tE, Vec q, Vec u) const;

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
