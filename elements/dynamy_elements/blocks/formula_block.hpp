/// FormulaBlock: out = f(t, signals): a gain, a sum, a limit, any number that several formulas share.
///
/// It has no state. A loop through it alone is refused where the model is built (theory 55.1).
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

class FormulaBlock final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit FormulaBlock(const Parameters& x) : ExternalForce(x), of_(x, "of", 1) {}
  void connect(Topology& topology) override { of_.connect(topology, *this); }
  bool mayCouple() const override { return false; }
  void addTo(const Kinematics&, ForceSink&) const override {}
  void describe(Description& d) const override;

 private:
  SignalFormulas of_;
};

}  // namespace dynamy
