/// Gravity: uniform field.   h += Σ J_Sᵀ m g,   V = −Σ m g·r_OS
#pragma once
#include <dynamy/core/parameters.hpp>
#include <dynamy/system/external_force.hpp>

namespace dynamy {

/// Acts on all systems that have weight; each answers itself (PartialMechanicalSystem::gravity).
class Gravity final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit Gravity(const Parameters& x);
  void connect(Topology& topology) override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  bool hasPotential() const override { return true; }
  double potentialEnergy(const Kinematics& k) const override;

 private:
  struct Part {
    const PartialMechanicalSystem* system;
    SystemHandle handle;
  };
  Vec3 g_I_;
  std::vector<Part> parts_;
  mutable Eigen::VectorXd h_;  ///< scratch, sized in connect()
};

}  // namespace dynamy
