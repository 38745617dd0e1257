/// SwitchSearch: finds on the path through a trial step where the status of a contact ends
/// (theory 50.3).
///
/// A monitor is a number that is positive while the status holds:
///
///   open      gap g                       slip in one direction   s γ_T
///   closed    λ_N                         stick                   distance of λ_T from the bound
///   beside the notch of a preloaded spring  s x;  in it           distance of λ from the bounds
///   latch (an element that switches)        minus the number that it reports
///   closed by two features                  how far they lie over one another (presence)
///
/// A gap that reaches zero while its two features do not lie over one another is no switch.
///
/// Gaps and slips are sampled at eight points without any force; forces at the middle and the end.
/// Forces are compared with the largest force on the whole path. For a single contact, λ_N over the
/// largest force of the same instant would be nothing but its sign.
/// Every bracket is refined to a root, and roots are compared, never brackets.
#pragma once
#include <dynamy/located/phase/smooth_step.hpp>
#include <dynamy/located/switching/contact_probe.hpp>
#include <limits>

namespace dynamy {

struct Switch {
  enum class Kind : std::uint8_t { none, atStart, root, look };
  Kind kind = Kind::none;
  double theta = 1.0;  ///< place on the path, as a part of the step
  bool force = false;  ///< its monitor is one of forces: each value takes an evaluation
  int monitor = -1;
  double slope = 0.0;  ///< slope of the monitor at the root, per second
  explicit operator bool() const { return kind != Kind::none; }
};

class SwitchSearch {
 public:
  /// `gapNoise`, `speedNoise`: gaps [m] and velocities [m/s] below these count as zero. `touch`:
  /// bodies lie on each other at gaps and overlaps up to this [m]; `same`: contacts of one pair of
  /// bodies that are nearer than this count as one [m].
  void prepare(double gapNoise, double speedNoise, double touch, double same);
  /// Sets up the monitors of `phase` and their values at the start `x` of a step, where the phase
  /// has evaluated its forces. False: contacts changed.
  bool begin(ContactProbe& probe, const FrozenPhase& phase, const State& x);
  /// Until the next begin(): joints bear the open contacts `keys`. Their gaps are the drift of the
  /// joints, and switch only where they fall below −`deep` [m].
  void borne(const std::vector<ContactKey>& keys, double deep) { borne_ = keys, deep_ = deep; }
  /// Sets up the kinematic monitors anew, for the contacts that `probe` follows now.
  bool watch(ContactProbe& probe, const FrozenPhase& phase, const State& x);
  static constexpr int kSamples = 8;
  /// Finds the first switch on `path`, after atEnd() for its end. `looked`: gaps that come near
  /// zero are not examined again. `width`: accuracy of a root of forces, as a part of the step.
  /// False: a fault of the phase or of contacts.
  bool find(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase, const QuinticPath& path,
            bool looked, double width, Switch& out);
  /// Value of the monitor of `w` at x, from kinematics or from the forces of the phase there.
  bool value(ContactProbe& probe, const FrozenPhase& phase, const State& x, const Switch& w,
             double& out);
  /// True: at x, where `w` was found, another contact has closed before; w becomes its switch. Two
  /// contacts that close shortly after each other may do so in another order on the path than in
  /// the true motion.
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
  /// True: forces or slips on the last path, from one state at rest to another, change faster than
  /// the samples resolve. Evaluates the monitors between the samples, once those of forces.
  bool rough(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase, const QuinticPath& path);
  bool any() const { return !kinematic_.empty() || !force_.empty(); }
  /// Notes the forces at the end of the path, time t; to be called before find(). A step that
  /// begins there with the same statuses starts from them, since find() leaves the phase with
  /// forces of other places.
  void atEnd(const FrozenPhase& phase, double t) {
    endScale_ = forces(phase, endForces_), idles(phase, endIdle_), end_ = t;
  }
  /// Forgets all noted forces, because statuses have changed.
  void forget() { end_ = start_ = std::numeric_limits<double>::quiet_NaN(); }
  /// Forgets the forces noted at time t, because the state there has changed.
  void forget(double t) {
    if (end_ == t) end_ = std::numeric_limits<double>::quiet_NaN();
    if (start_ == t) start_ = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static constexpr double kForceNoise = 1e-12;  // of the largest force on the path
  static constexpr double kStart = 1e3;         // of the noise: a monitor below this starts at zero
  struct Monitor {
    enum class Kind : std::uint8_t { gap, slip, latch, presence, force } kind = Kind::gap;
    int contact = 0;  // index in the probe; for a force in the phase; number of a latch
    int row = 0;      // of γ within the contact
    double sign = 1.0;
    bool zeroStart = false;
    ContactKey key = {};
    bool features = false;  // a gap of two features that come and go
    bool behind = false;    // such a gap that starts below zero
    double above = 0.0;     // added to the gap of a contact that joints bear
  };
  static bool isGap(const Monitor& m) { return m.kind == Monitor::Kind::gap; }
  /// Value of a kinematic monitor at the last look of the probe; rate(): rate of a gap, else 0.
  double measure(const ContactProbe& probe, const Monitor& m) const;
  double rate(const ContactProbe& probe, const Monitor& m) const;
  void column(const ContactProbe& probe, int sample);
  /// Returns the largest force; `out`: distance of each watched force from its bound [N].
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
  /// Shrinks the bracket to `width`, or until a value is within ±zero. `slope`: per step.
  template <class Value>
  bool refine(Bracket& at, double width, double zero, Value&& value, double& root, double& slope);
  bool refineKinematic(ContactProbe& probe, const QuinticPath& path, int monitor, Bracket& at,
                       double& root, double& slope);
  bool kinematicSwitch(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first);
  /// Finds where a monitor falls below zero between samples j − 1 and j. `there`: false for a gap
  /// whose features do not lie over one another at the root.
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
  /// True: a force that deviates by so much bends too fast for the samples of its monitor.
  bool bends(Eigen::Index monitor, double by) const;
  // Times of the states whose forces and idle sets are known here. The phase is no source for them:
  // a rejected trial leaves the forces of its own end in it.
  double start_ = std::numeric_limits<double>::quiet_NaN(), end_ = start_;
  std::vector<char> startIdle_, endIdle_;  // per held[i]: not 0 if its set is idle
  double gapNoise_ = 0.0, speedNoise_ = 0.0, touch_ = 0.0, same_ = 0.0;
  Eigen::MatrixXd values_, rates_, presences_;  // kinematic × (kSamples + 1)
  Eigen::VectorXd startForces_, middleForces_, endForces_, work_;
  // The largest force at the start, at the end and on the path [N].
  double startScale_ = 0.0, endScale_ = 0.0, scale_ = 0.0;
  State at_;
};

}  // namespace dynamy
