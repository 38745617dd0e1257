/// Input: a number that the program which runs the model sets between two steps; formulas read it
/// as the signal `out`. It is part of State::memory.
#pragma once
#include <dynamy/system/external_force.hpp>

namespace dynamy {

class Input final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit Input(const Parameters& x);
  void connect(Topology& topology) override { topology.memory(*this, {value_}); }
  bool mayCouple() const override { return false; }
  void addTo(const Kinematics&, ForceSink&) const override {}
  void describe(Description& d) const override;

 private:
  double value_;
};

}  // namespace dynamy
