/// RestRules: which systems of a model may sleep while they rest, and why no other does (theory 58).
///
/// A system may if its own equations and all elements that act on it follow from positions and
/// velocities alone (Description::timeless), and if no such element holds it to something that moves
/// as a function of time: what rests then rests until something touches it.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

class RestRules {
 public:
  /// `model` is built, and its scheme is known. `planned`: another run has chosen the steps.
  explicit RestRules(const Model& model, bool planned = false);
  bool any() const { return reason_.empty(); }
  /// Why no system at all may sleep; empty: some may.
  const std::string& reason() const { return reason_; }
  bool may(int system) const { return may_[static_cast<std::size_t>(system)] != 0; }
  /// True: the system has no velocities and stands still.
  bool still(int system) const { return still_[static_cast<std::size_t>(system)] != 0; }
  const std::vector<char>& still() const { return still_; }
  /// Number of systems with velocities, and of those that may sleep.
  int moving() const { return moving_; }
  int resting() const;

 private:
  void follow(const Model& model, const Element& element, bool timeless, const Connection* own);
  void keepAwake(const Connection* own, const Element& element);
  std::vector<char> may_, still_;  // per system
  int moving_ = 0;
  std::string reason_;
};

}  // namespace dynamy
