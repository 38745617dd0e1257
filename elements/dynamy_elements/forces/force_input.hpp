/// ForceInput: force and moment on a point of a frame, as formulas of
/// time; for drives, excitations.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/time_formulas.hpp>

namespace dynamy {

class ForceInput final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit ForceInput(const Parameters& x);
  void connect(Topology& topology) override { frame_ = topology.frame(on_, *this); }
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  void describe(Description& d) const override { TimeFormulas::announce(d, {&force_, &moment_}); }

 private:
  std::string on_;
  FrameHandle frame_;
  Vec3 point_;
  bool bodyAxes_;
  TimeFormulas force_, moment_;
};

}  // namespace dynamy
