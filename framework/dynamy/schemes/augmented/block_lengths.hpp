/// BlockLengths: how long the next block of AugmentedMoreau is (theory 51).
///
///   accepted    H ← 2H, at most Δt_max; halved down to Δt_min while a switch is bisected
///   failed      H ← H/2, at least Δt_min
///   switches    more than a few dozen within Δt_max: plain steps up to the end of that time
#pragma once
#include <dynamy/core/types.hpp>
#include <optional>

namespace dynamy {

class BlockLengths {
 public:
  /// order: N; dtMin: Δt_min [s], 0: (Δt_max in s)^N / 4 s.
  BlockLengths(int order, double dtMin) : order_(order), dtMin_(dtMin) {}
  /// Reads what store() wrote to the head of State::scheme. False: it is from another scheme.
  bool restore(const Eigen::VectorXd& data);
  void store(Eigen::VectorXd& data) const;
  static constexpr Eigen::Index kSize = 7;  ///< numbers of store()
  void forget() { plan_ = {}; }

  /// Starts a step at t that may take dt.
  void begin(double t, double dt);
  double next() const { return plan_.next; }
  /// Length of a plain step, nothing where blocks are tried.
  std::optional<double> plain() const;
  /// Δt_min at the beginning of this step [s].
  double shortest() const;
  /// A block of length H ended at t.
  void accepted(double t, double H);
  /// A block of length H failed.
  void failed(double H);
  /// A plain step of length h was taken.
  void stepped(double h) { plan_.bisecting = false, plan_.next = 2 * h; }
  /// Counts a switch. Returns where plain steps end if there were too many.
  std::optional<double> countSwitch();

 private:
  /// Data kept from step to step, in State::scheme.
  struct Plan {
    double dtMax = 0.0;      ///< the largest Δt required so far [s]
    double next = 0.0;       ///< length to be tried next [s]
    double failedEnd = 0.0;  ///< end of the shortest block that failed [s], while bisecting
    bool bisecting = false;
    double windowStart = 0.0;  ///< time since which switches are counted [s]
    int switches = 0;          ///< number of switches since then
    double plainUntil = 0.0;   ///< plain time-stepping up to here [s]
  };
  int order_;
  double dtMin_, t_ = 0.0;
  Plan plan_;
};

}  // namespace dynamy
