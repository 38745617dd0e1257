/// DiscreteState: σ of a step (theory 51.1), what every law that carries does:
///
///   σ_i = status of the prox argument Λ_i − r ξ_i, in planar friction with the sign of the slip
///
/// Open and separating contacts carry nothing and are not listed: which of the two a contact is
/// changes no equation. The argument decides, never Λ, so that no tolerance of a solver does.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class DiscreteState {
 public:
  /// Of the problem that `s` has just solved, u^E in x.
  void read(const MechanicalSystem& s, const State& x);
  void forget() { known_ = false, key_.clear(), value_.clear(); }
  bool known() const { return known_; }
  /// The contacts that carry, ascending.
  const std::vector<ContactKey>& carrying() const { return key_; }
  bool operator==(const DiscreteState& other) const {
    return known_ == other.known_ && key_ == other.key_ && value_ == other.value_;
  }
  /// As numbers from data[first] on, for State::scheme; size() of them.
  Eigen::Index size() const { return 2 + 3 * static_cast<Eigen::Index>(key_.size()); }
  void store(Eigen::VectorXd& data, Eigen::Index first) const;
  /// False: the numbers, of a file, are none that store() leaves; nothing is known then.
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
