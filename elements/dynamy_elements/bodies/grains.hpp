/// Grains: a population of free bodies of one shape in many sizes; M, h and the kinematics of each
/// are those of RigidBody.
///
///   q_i = (r_OS, p),  u_i = (v_S, Ω_K),  m_i = s_i³ m,  J_i = s_i⁵ J    s: factor of the size
///
/// One element per body was rejected: 100 000 names, and as many virtual calls for each quantity of
/// a step.
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>
#include <dynamy_elements/bodies/grain_exchange.hpp>

namespace dynamy {

class Grains final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a);
  explicit Grains(const Parameters& x);

  Blocks blocks() const override { return {7, 6, count(), true}; }
  void describe(Description& d) const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  void gyroscopicAtMean(double t, ConstVec q, ConstVec uA, double dt, Vec h) const override;
  void qdot(double t, ConstVec q, ConstVec u, Vec qdot) const override;
  void move(double t, Vec q, ConstVec u, double dt) const override;
  void normalise(Vec q) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return count(); }
  Abilities abilities() const override {
    return {.renewable = exchange_->any() ? exchange_.get() : nullptr};
  }

 private:
  struct Grain {
    double m = 0.0;
    Mat3 J_S_K = Mat3::Identity();
    Vec3 r_OS_I = Vec3::Zero();
    double p[4] = {1.0, 0.0, 0.0, 0.0};
  };
  int count() const { return static_cast<int>(grains_.size()); }
  void takeSizes(const Parameters& x, SeededNumbers& numbers);
  void place(const Parameters& x, SeededNumbers& numbers);

  std::unique_ptr<Shape> shape_;
  std::vector<double> size_;                       ///< factors
  std::vector<std::unique_ptr<Shape>> ownShapes_;  ///< one per grain if sizes differ
  std::vector<Grain> grains_;
  std::unique_ptr<const GrainExchange> exchange_;
  Vec3 v_S_I_;
  mutable std::vector<double> sorted_;  ///< scratch of a signal
};

}  // namespace dynamy
