/// Gravity: a uniform field, constant or prescribed.   h += Σ J_Sᵀ m g(t),   V = −Σ m g·r_OS
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/time_formulas.hpp>

namespace dynamy {

/// Gravity acts on all systems that have weight; each computes it itself
/// (PartialMechanicalSystem::gravity).
class Gravity final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit Gravity(const Parameters& x);
  void connect(Topology& topology) override;
  bool mayCouple() const override { return false; }
  bool isMirrored(const MirrorPlane& plane) const override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  /// A field that changes with time does work that is not the change of a potential of q.
  bool hasPotential() const override { return change_.empty(); }
  double potentialEnergy(const Kinematics& k) const override;
  void describe(Description& d) const override {
    d.timeless = change_.empty();
    TimeFormulas::announce(d, {&change_});
  }

 private:
  struct Part {
    const PartialMechanicalSystem* system;
    SystemHandle handle;
  };
  Vec3 field(double t) const;
  Vec3 g_I_;
  TimeFormulas change_;
  std::vector<Part> parts_;
  mutable Eigen::VectorXd h_;  ///< scratch, sized in connect()
};

}  // namespace dynamy
