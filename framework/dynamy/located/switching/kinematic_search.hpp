/// KinematicSearch: the first switch of the KinematicMonitors on a path. They are sampled at eight
/// points, and every bracket is refined to a root; roots are compared, never brackets.
///
/// A gap that reaches zero while its two features do not lie over one another is no switch.
#pragma once
#include <dynamy/located/phase/phase_point.hpp>
#include <dynamy/located/switching/bracket.hpp>
#include <dynamy/located/switching/kinematic_monitors.hpp>

namespace dynamy {

class KinematicSearch {
 public:
  static constexpr int kSamples = 8;
  KinematicMonitors monitors;

  /// Notes the values at the start x, after monitors.watch() there.
  void start(const ContactProbe& probe, const State& x);
  /// Samples the path. False: contacts changed.
  bool sample(ContactProbe& probe, const QuinticPath& path);
  /// Finds the first switch of the samples before `first`, which it replaces. `looked`: gaps that
  /// come near zero between two samples are not examined. False: contacts changed.
  bool find(ContactProbe& probe, const QuinticPath& path, bool looked, Switch& first);
  /// True: before θ the lowest point of a closed circle may run along its rim between two samples.
  bool passesFlat(double theta) const;
  /// True: the samples themselves show that they do not resolve the path.
  bool roughSamples() const;
  /// True: values between the samples of the last path deviate from them, or are not known.
  bool rough(ContactProbe& probe, const QuinticPath& path);

 private:
  void column(const ContactProbe& probe, int sample);
  bool valueAt(ContactProbe& probe, const QuinticPath& path, int monitor, double theta, double& v);
  /// Features of the monitor may lie over one another between samples j − 1 and j.
  bool mayBePresent(int monitor, int j) const;
  bool presentAt(ContactProbe& probe, const QuinticPath& path, int monitor, double theta,
                 bool& there);
  bool refine(ContactProbe& probe, const QuinticPath& path, int monitor, Bracket& at, double& root,
              double& slope);
  bool separates(int monitor) const;
  void untilItCloses(int monitor, Switch& first) const;
  bool findOf(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first);
  /// Halves [0, b] until the monitor, which starts at zero, is positive in its middle: at [a, b].
  bool fromZero(ContactProbe& probe, const QuinticPath& path, int monitor, Bracket& at,
                bool& positive);
  /// Finds where a monitor falls below zero between samples j − 1 and j. `there`: false for a gap
  /// whose features do not lie over one another at the root.
  bool fall(ContactProbe& probe, const QuinticPath& path, int monitor, int j, Switch& first,
            bool& there);
  bool atEnd(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first);
  bool staysHigh(const QuinticPath& path, int monitor, int j, double high) const;
  bool near(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first);
  Eigen::MatrixXd values_, rates_, presences_;  // monitors × (kSamples + 1)
  State at_;
};

}  // namespace dynamy
