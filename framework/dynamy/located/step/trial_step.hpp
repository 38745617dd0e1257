/// TrialStep: a smooth step of a given length, and the first switch on its path (theory 50.2, 50.3).
///
/// A trial that is too long, by its error, by the turn of a starting slip or because bodies meet
/// whose contact cannot be followed, is dropped: the held contacts are as they were at the start,
/// and a shorter length is proposed.
#pragma once
#include <dynamy/located/step/coming_contacts.hpp>
#include <dynamy/located/step/energy_bound.hpp>

namespace dynamy {

/// The result of a trial. It ends in step.to.
struct Trial {
  bool accepted = false;
  double h = 0.0;  ///< its length [s]
  Switch found;    ///< the first switch on its path
  Refusal refusal{};
};

class TrialStep {
 public:
  TrialStep(LocatedParts& parts, ComingContacts& coming) : parts_(parts), coming_(coming) {}
  /// Length of a trial of length h after contacts have limited it [s].
  double shortened(const PhasePoint& from, double h) const;
  /// Tries a step of length h, and again up to the place where a gap comes near zero. Sets the
  /// length of the next trial.
  Trial take(LocatedStep& step, double h);
  /// Drops a trial of length h, in which bodies sank into one another.
  void drop(LocatedStep& step, double h);

 private:
  enum class Tried : std::uint8_t { accepted, rejected, turned, again, failed };
  Tried attempt(LocatedStep& step, bool looked, Trial& trial);
  /// Takes the smooth step and judges its error. `factor`: by which the next step may be longer.
  Tried takeSmooth(LocatedStep& step, Trial& trial, double& factor);
  /// Searches the path for a switch.
  Tried findSwitch(LocatedStep& step, bool looked, Trial& trial);
  Tried boundEnergy(LocatedStep& step, double h, double& factor);
  Tried reject(LocatedStep& step, double next);
  Tried fail(Refusal why, Trial& trial);
  Tried faultOfPhase(LocatedStep& step, Trial& trial);
  Tried shortOfMeeting(LocatedStep& step, Trial& trial, double clear);
  bool tooLongAtRest(LocatedStep& step, const Trial& trial);
  double longestOfTurns(const Eigen::VectorXd& u) const;
  bool moves(const PhasePoint& p) const;
  bool slipsInSpace() const;
  LocatedParts& parts_;
  ComingContacts& coming_;
  EnergyBound energy_;
  QuinticPath path_;
};

}  // namespace dynamy
