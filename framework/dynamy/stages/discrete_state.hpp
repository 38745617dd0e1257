/// DiscreteState: the discrete state σ of a step (theory 51.1), the status of each contact that
/// carries an impulse:
///
///   σ_i = status of the prox argument Λ_i − r ξ_i, in planar friction with the sign of the slip
///
/// Open and separating contacts carry nothing and are not listed: whether a contact is one or the
/// other changes no equation. The status is read from the argument, never from Λ, so that it does
/// not depend on the tolerance of a solver.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class DiscreteState {
 public:
  /// Reads σ from the problem that `s` has just solved, with u^E in x.
  void read(const MechanicalSystem& s, const State& x);
  void forget() { known_ = false, key_.clear(), value_.clear(); }
  bool known() const { return known_; }
  /// The contacts that carry an impulse, ascending.
  const std::vector<ContactKey>& carrying() const { return key_; }
  bool operator==(const DiscreteState& other) const {
    return known_ == other.known_ && key_ == other.key_ && value_ == other.value_;
  }
  /// Writes size() numbers from data[first] on, for State::scheme.
  Eigen::Index size() const { return 2 + 3 * static_cast<Eigen::Index>(key_.size()); }
  void store(Eigen::VectorXd& data, Eigen::Index first) const;
  /// Reads what store() wrote. False: the numbers (of a file) cannot be from store(); then nothing
  /// is known.
  bool restore(const Eigen::VectorXd& data, Eigen::Index first);

 private:
  bool known_ = false;
  std::vector<ContactKey> key_;
  std::vector<int> value_;
  struct Entry {
    ContactKey key;
    int value;
  };
  std::vector<Entry> work_;
  std::vector<double> gammaE_;
};

}  // namespace dynamy
