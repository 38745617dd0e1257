/// Controls of the rider: brakes and steering.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/system/external_force.hpp>

#include "motorbike.hpp"

namespace dynamy::motorbike {

/// Brake between a wheel and the body that carries it: a friction torque in [−M_b(t), M_b(t)],
///
///   γ = s(t) φ̇,   λ ∈ −M_b Sgn γ,   torque s(t) λ       s from 0 at `start` to 1 in `rise`
///
/// A force set that changes with time was rejected: laws are constant, and the factor s in W has
/// the same effect.
class WheelBrake final : public NonSmoothElement {
 public:
  static void declare(Attributes& a);
  explicit WheelBrake(const Parameters& x);
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;

 private:
  std::string on_;
  int wheel_;
  double start_, rise_, end_;
  GivenFriction law_;
  SystemHandle system_;
};

/// A rider who steers into the fall: torque on the handlebar, positive to the left,
///
///   T = −k_φ φ − k_φ̇ Ω_x − k_δ δ − k_δ̇ δ̇ + k_ψ ψ      φ to the right, ψ to the left
class RiderSteering final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit RiderSteering(const Parameters& x);
  void connect(Topology& topology) override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;

 private:
  std::string on_;
  double lean_, leanRate_, steer_, steerRate_, heading_;
  SystemHandle system_;
};

}  // namespace dynamy::motorbike
