/// BlockStates: the states x of an element as a system of its own, q = ∫x dt and u = x (theory 55.3):
///
///   m u̇ = m ẋ,   with a small mass m, which cancels
#pragma once
#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <string>
#include <vector>

namespace dynamy {

class BlockStates final : public PartialMechanicalSystem {
 public:
  /// Mass of a state: its kinetic energy is no part of the energies of the model [kg].
  static constexpr double kMass = 1e-12;
  /// As many states as there are initial values. The only one has its integral as a signal, too.
  BlockStates(const Parameters& x, std::vector<double> initial, std::vector<std::string> names)
      : PartialMechanicalSystem(x), initial_(std::move(initial)), names_(std::move(names)) {}
  Blocks blocks() const override {
    const int n = static_cast<int>(initial_.size());
    return {.nq = n, .nu = n, .constantMass = true};
  }
  void initialState(Vec q, Vec u) const override {
    q.setZero();
    std::copy(initial_.begin(), initial_.end(), u.data());
  }
  void M(double, ConstVec, MassBlocks M) const override {
    M[0].setZero();
    M[0].diagonal().setConstant(kMass);
  }
  void h(double, ConstVec, ConstVec, Vec h) const override { h.setZero(); }
  bool feelsGravity(ConstVec) const override { return false; }
  void describe(Description& d) const override {
    for (std::size_t i = 0; i < names_.size(); ++i)
      d.velocity(names_[i], Unit::any, static_cast<int>(i), "state of the block");
    if (names_.size() == 1) d.coordinate("integral", Unit::any, 0, "its integral since the start");
  }

 private:
  std::vector<double> initial_;
  std::vector<std::string> names_;
};

}  // namespace dynamy
