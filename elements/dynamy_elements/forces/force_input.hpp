/// ForceInput: force and moment on a point of a frame, as formulas of time and signals; for drives,
/// excitations, controllers.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

class ForceInput final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit ForceInput(const Parameters& x);
  void connect(Topology& topology) override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  void describe(Description& d) const override { SignalFormulas::announce(d, {&force_, &moment_}); }

 private:
  std::string on_;
  FrameHandle frame_;
  Vec3 point_;
  bool bodyAxes_;
  SignalFormulas force_, moment_;
};

}  // namespace dynamy
