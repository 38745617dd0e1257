/// ForceSearch: monitors of the forces that are held, and the first switch of them on a path:
///
///   closed    λ_N                         stick                   distance of λ_T from the bound
///   in the notch of a preloaded spring      distance of λ from the bounds
///   stick, in redundant rows                a small force less the one that is missing to hold them
///
/// Forces are known at the start, the middle and the end of a path; each further value takes an
/// evaluation. They are compared with the largest force on the whole path. For a single contact, λ_N
/// over the largest force of the same instant would be nothing but its sign.
#pragma once
#include <dynamy/located/phase/frozen_phase.hpp>
#include <dynamy/located/phase/phase_point.hpp>
#include <dynamy/located/switching/bracket.hpp>
#include <dynamy/located/switching/switch.hpp>
#include <limits>

namespace dynamy {

class ForceSearch {
 public:
  /// Notes which sets are idle at the start x of a step.
  void idleAtStart(const FrozenPhase& phase, const State& x);
  /// Per held part, not 0 if its set is idle at the start.
  const std::vector<char>& idle() const { return startIdle_; }
  /// Sets up the monitors of `phase` at the start x of a step, where it has evaluated its forces.
  void watch(const FrozenPhase& phase, const State& x);
  /// Notes the forces at the end of the path, time t. A step that begins there with the same
  /// statuses starts from them, since a search leaves the phase with forces of other places.
  void atEnd(const FrozenPhase& phase, double t) {
    endScale_ = forces(phase, endForces_), idles(phase, endIdle_), end_ = t;
  }
  /// Evaluates the forces at the middle of the path. False: the phase has a fault.
  bool sample(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path);
  /// Finds the first switch of the samples before `first`, which it replaces. `width`: accuracy of
  /// a root, as a part of the step. False: the phase has a fault.
  bool find(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path, double width,
            Switch& first);
  /// True: the samples themselves show that they do not resolve the path.
  bool roughSamples() const;
  /// True: forces between the samples of the last path deviate from them.
  bool rough(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path);
  /// Distance of a watched force from its bound in the last acceleration of the phase.
  void value(const FrozenPhase& phase, int monitor, double& out) const;
  /// Forgets all noted forces, because statuses have changed.
  void forget() { end_ = start_ = std::numeric_limits<double>::quiet_NaN(); }
  /// Forgets the forces noted at time t, because the state there has changed.
  void forget(double t);

  bool any() const { return !monitors_.empty(); }
  /// Index of the held part of a monitor.
  std::size_t held(int monitor) const { return monitors_[static_cast<std::size_t>(monitor)].held; }

 private:
  struct Monitor {
    std::size_t held = 0;
    bool contradicts = false;  ///< of all rows that stick
    bool zeroStart = false;
  };
  double distance(const FrozenPhase& phase, const Monitor& m) const;
  static void idles(const FrozenPhase& phase, std::vector<char>& out);
  /// Returns the largest force; `out`: distance of each watched force from its bound [N].
  double forces(const FrozenPhase& phase, Eigen::VectorXd& out) const;
  bool valueAt(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path, int monitor,
               double theta, double& v);
  bool findOf(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path, int monitor,
              double width, Switch& first);
  /// True: a force that deviates by so much bends too fast for the samples of its monitor.
  bool bends(Eigen::Index monitor, double by) const;
  std::vector<Monitor> monitors_;
  // Times of the states whose forces and idle sets are known here. The phase is no source for them:
  // a rejected trial leaves the forces of its own end in it.
  double start_ = std::numeric_limits<double>::quiet_NaN(), end_ = start_;
  std::vector<char> startIdle_, endIdle_;  // per held[i]: not 0 if its set is idle
  Eigen::VectorXd startForces_, middleForces_, endForces_, work_;
  // The largest force at the start, at the end and on the path [N].
  double startScale_ = 0.0, endScale_ = 0.0, scale_ = 0.0;
  State at_;
};

}  // namespace dynamy
