/// Drag of air or another fluid on a body:                                          (theory 40.5)
///
///   F = −½ ρ c A |v| v − d v       v: velocity of the point relative to the wind
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/time_formulas.hpp>
#include <string>

namespace dynamy {

class Drag final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit Drag(const Parameters& x);
  void connect(Topology& topology) override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  void describe(Description& d) const override;

 private:
  Vec3 force(const Kinematics& k) const;
  std::string on_;
  FrameHandle frame_;
  Vec3 point_;
  double quadratic_, linear_;  // ½ ρ c A [kg/m], d [N s/m]
  TimeFormulas wind_;
};

}  // namespace dynamy
