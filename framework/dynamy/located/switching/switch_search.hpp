/// SwitchSearch: finds on the path through a trial step where the status of a contact ends
/// (theory 50.3).
///
/// A monitor is a number that is positive while the status holds:
///
///   open      gap g                       slip in one direction   s γ_T
///   closed    λ_N                         stick                   distance of λ_T from the bound
///   beside the notch of a preloaded spring  s x;  in it           distance of λ from the bounds
///   what an element switches at             less the number that it tells (a latch)
///   closed by two features                  how far they lie over one another (presence)
///
/// The gap of two features that do not lie over one another where it reaches zero is no switch.
///
/// Gaps and slips are sampled at eight points without any force; forces at the middle and the end.
/// Forces are compared with the largest on the whole path: of a contact that is alone, λ_N over the
/// largest force of the instant is nothing but its sign.
/// Every bracket is refined to a root, and roots are compared, never brackets.
#pragma once
#include <dynamy/located/phase/smooth_step.hpp>
#include <dynamy/located/switching/contact_probe.hpp>
#include <limits>

namespace dynamy {

struct Switch {
  enum class Kind : std::uint8_t { none, atStart, root, look };
  Kind kind = Kind::none;
  double theta = 1.0;  ///< part of the step
  bool force = false;  ///< a monitor of forces: its value takes an evaluation
  int monitor = -1;
  double slope = 0.0;  ///< of the monitor at the root, per second
  explicit operator bool() const { return kind != Kind::none; }
};

class SwitchSearch {
 public:
  /// `noise`: what is zero of gaps [m] and of velocities [m/s].
  /// `touch`: gaps and overlaps up to this are those of bodies that lie on each other; `same`:
  /// contacts of one pair of bodies that are nearer than this are one [m].
  void prepare(double gapNoise, double speedNoise, double touch, double same);
  /// Monitors of `phase` and their values at the start of a step; `x`: the start; the phase has
  /// the forces there. False: contacts changed.
  bool begin(ContactProbe& probe, const FrozenPhase& phase, const State& x);
  /// Until the next begin(): the gaps of the open contacts `keys`, which joints bear, are what joints drift, and a
  /// switch only where they fall below −`deep` [m].
  void borne(const std::vector<ContactKey>& keys, double deep) { borne_ = keys, deep_ = deep; }
  /// Kinematic monitors anew, of the contacts that `probe` follows now.
  bool watch(ContactProbe& probe, const FrozenPhase& phase, const State& x);
  static constexpr int kSamples = 8;
  /// The first switch on `path`; `end` holds forces at its end. `looked`: gaps that come near are
  /// not looked at again. `width`: how closely a root of forces is found, as a part of the step.
  /// False: a fault of the phase or of contacts.
  bool find(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase, const QuinticPath& path,
            bool looked, double width, Switch& out);
  /// Value of the monitor of `w` at x, by kinematics or with the forces the phase has there.
  bool value(ContactProbe& probe, const FrozenPhase& phase, const State& x, const Switch& w,
             double& out);
  /// True: at x, where `w` was found, another contact has closed before: w is its switch then. Two
  /// that close soon after one another may change places between the path and the true motion.
  bool closedBefore(ContactProbe& probe, const State& x, Switch& w);
  /// The contact of a switch that was found.
  ContactKey contact(const FrozenPhase& phase, const Switch& w) const;
  /// True: an element switches there (Announcements).
  bool latches(const Switch& w) const {
    return w && !w.force &&
           kinematic_[static_cast<std::size_t>(w.monitor)].kind == Monitor::Kind::latch;
  }
  /// True: two features of a closed contact leave one another there.
  bool leaves(const Switch& w) const {
    return w && !w.force &&
           kinematic_[static_cast<std::size_t>(w.monitor)].kind == Monitor::Kind::presence;
  }
  /// True: there are open contacts.
  bool gaps() const { return !kinematic_.empty() && isGap(kinematic_.front()); }
  /// True: forces or slips of the last path, from one state at rest to another, change faster than
  /// its samples follow. Looks between them, with an evaluation for forces.
  bool rough(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase, const QuinticPath& path);
  bool any() const { return !kinematic_.empty() || !force_.empty(); }
  /// Forces at the end of the path, t, to be told before find(). A step that begins there, with the
  /// same statuses, begins with them: find() leaves those of other places in the phase.
  void atEnd(const FrozenPhase& phase, double t) {
    endScale_ = forces(phase, endForces_), idles(phase, endIdle_), end_ = t;
  }
  /// Statuses are others from now on.
  void forget() { end_ = start_ = std::numeric_limits<double>::quiet_NaN(); }
  /// The state of time t is another one.
  void forget(double t) {
    if (end_ == t) end_ = std::numeric_limits<double>::quiet_NaN();
    if (start_ == t) start_ = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static constexpr double kForceNoise = 1e-12;  // of the largest force on the path
  static constexpr double kStart = 1e3;         // of the noise: a value below starts at zero
  struct Monitor {
    enum class Kind : std::uint8_t { gap, slip, latch, presence, force } kind = Kind::gap;
    int contact = 0;  // of the probe; of a force: index in the phase; of a latch: its number
    int row = 0;      // of γ within the contact
    double sign = 1.0;
    bool zeroStart = false;
    ContactKey key = {};
    bool features = false;  // a gap of two features that come and go
    bool behind = false;    // of these, and it starts below zero
    double above = 0.0;     // added to the gap of a contact that joints bear
  };
  static bool isGap(const Monitor& m) { return m.kind == Monitor::Kind::gap; }
  /// Value of a kinematic monitor, and of a gap its rate, else 0, where the probe has looked.
  double measure(const ContactProbe& probe, const Monitor& m) const;
  double rate(const ContactProbe& probe, const Monitor& m) const;
  void column(const ContactProbe& probe, int sample);
  /// The largest force; `out`: how far each watched one is from its bound [N].
  double forces(const FrozenPhase& phase, Eigen::VectorXd& out) const;
  double noise(const Monitor& m) const {
    return m.kind == Monitor::Kind::slip || m.kind == Monitor::Kind::latch ? speedNoise_
                                                                           : gapNoise_;
  }
  void watchForces(const FrozenPhase& phase, const State& x);
  void watchOpen(const ContactProbe& probe, const FrozenPhase& phase);
  bool present(const ContactProbe& probe, const Monitor& m) const;
  /// Features of the monitor may lie over one another between samples j − 1 and j.
  bool mayBePresent(const Monitor& m, int monitor, int j) const;
  bool presentAt(ContactProbe& probe, const QuinticPath& path, int monitor, double theta,
                 bool& there);
  bool sample(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase,
              const QuinticPath& path);
  bool kinematicAt(ContactProbe& probe, const QuinticPath& path, int monitor, double theta,
                   double& v);
  bool forceAt(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path, int monitor,
               double theta, double& v);
  /// Part of the step at whose ends a monitor is positive and negative.
  struct Bracket {
    double a, fa, b, fb;
  };
  /// Shrinks it to `width`, or until a value is within ±zero. `slope`: per step.
  template <class Value>
  bool refine(Bracket& at, double width, double zero, Value&& value, double& root, double& slope);
  bool refineKinematic(ContactProbe& probe, const QuinticPath& path, int monitor, Bracket& at,
                       double& root, double& slope);
  bool kinematicSwitch(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first);
  /// The fall below zero between samples j − 1 and j; `there`: not that of features that do not lie
  /// over one another.
  bool fallSwitch(ContactProbe& probe, const QuinticPath& path, int monitor, int j, Switch& first,
                  bool& there);
  bool endSwitch(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first);
  bool forceSwitch(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path, int monitor,
                   double width, Switch& first);
  bool near(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first);
  std::vector<Monitor> kinematic_, force_;
  std::vector<ContactKey> borne_;
  double deep_ = 0.0;
  static void idles(const FrozenPhase& phase, std::vector<char>& out);
  bool roughSamples() const;
  /// A force that is off by so much bends too fast for the samples of its monitor.
  bool bends(Eigen::Index monitor, double by) const;
  // Times of the states whose forces and idle sets are known: a trial that is rejected leaves
  // those of its own end in the phase.
  double start_ = std::numeric_limits<double>::quiet_NaN(), end_ = start_;
  std::vector<char> startIdle_, endIdle_;  // of held[i]
  double gapNoise_ = 0.0, speedNoise_ = 0.0, touch_ = 0.0, same_ = 0.0;
  Eigen::MatrixXd values_, rates_, presences_;  // kinematic × (kSamples + 1)
  Eigen::VectorXd startForces_, middleForces_, endForces_, work_;
  // The largest force at the start, at the end and on the path [N].
  double startScale_ = 0.0, endScale_ = 0.0, scale_ = 0.0;
  State at_;
};

}  // namespace dynamy
