/// KineticDamping: the motion of a model from rest by its own scheme, in which all velocities are set to
/// zero whenever the kinetic energy has passed a maximum [Otter, Cassell, Hobbs 1966: kinetic
/// damping]. What a model stores as potential energy is lost step by step, contacts open and close
/// by their own laws, and the state approaches a rest that the motion can reach.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

class KineticDamping {
 public:
  /// `model` outlives it. `longest`: most time of one part of the motion [s].
  KineticDamping(Model& model, const State& from, double longest);
  /// Goes on to the next maximum of the kinetic energy. False: there is none within the longest time,
  /// or the run ended early; why() says which.
  bool next();
  /// At rest.
  const State& at() const { return at_; }
  long steps() const { return steps_; }
  /// The last maximum of the kinetic energy [J].
  double peak() const { return peak_; }
  const std::string& why() const { return why_; }

 private:
  Model& model_;
  State at_;
  double longest_, peak_ = 0.0;
  long steps_ = 0;
  std::string why_;
};

}  // namespace dynamy
