/// LookupTable: out = y(f), piecewise linear between points (x_i, y_i) and held beyond them.
///
/// A table of the time announces its kinks. Rejected: splines, which overshoot measured values.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/signal_formulas.hpp>
#include <optional>

namespace dynamy {

class LookupTable final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit LookupTable(const Parameters& x);
  void connect(Topology& topology) override { of_.connect(topology, *this); }
  bool mayCouple() const override { return false; }
  void addTo(const Kinematics&, ForceSink&) const override {}
  void describe(Description& d) const override;

 private:
  void read(const Parameters& x);
  double at(double x) const;
  double nextInstant(double t) const;
  SignalFormulas of_;
  std::vector<double> x_, y_;
};

}  // namespace dynamy
