/// TreeSystem: bodies that joints connect, as one system in the coordinates of these joints. The
/// system owns the bodies; their frames, shapes and signals keep their names.
///
///   M(q) u̇ = h(q, u) + W λ,   q = 0 and unit quaternions where the model file puts the bodies
///
/// It is made by composeTrees() from the bodies and joints of a model, never by an XML tag.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/own_inverse.hpp>
#include <dynamy_elements/trees/carried_bodies.hpp>

namespace dynamy {

class TreeSystem final : public PartialMechanicalSystem, public OwnInverse {
 public:
  using System = std::unique_ptr<PartialMechanicalSystem>;
  /// `x`: type and place of the first body. `planeNormal`: as in Blocks.
  TreeSystem(const Parameters& x, const Vec3& planeNormal)
      : PartialMechanicalSystem(x), carried_(tree_, results_, planeNormal) {}

  /// Adds a body that is carried by `parent` (index of another body, −1: the fixed world) and moves
  /// relative to it by the motions `free` at the point `at_I`. Returns its index.
  int carry(System body, int parent, const Vec3& at_I, const std::vector<FreeMotion>& free);
  /// What the joints changed of the velocities that the bodies were given.
  struct StartChange {
    std::vector<double> off;  ///< change of each body's velocity [m/s, rad/s]; empty: all are zero
    double kineticBefore = 0.0, kineticAfter = 0.0;  ///< [J]
  };
  /// To be called after the last body: computes the velocities at the start. Velocities of the
  /// bodies that joints do not allow are lost as by an impact.
  StartChange finish();

  Blocks blocks() const override {
    return {tree_.nq(), tree_.nu(), 1, tree_.constantMass(), carried_.planeNormal()};
  }
  void describe(Description& d) const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void applyInverseMass(double t, ConstVec q, ConstVec in, Vec out) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  void qdot(double t, ConstVec q, ConstVec u, Vec qdot) const override;
  void move(double t, Vec q, ConstVec u, double dt) const override;
  void gyroscopicAtMean(double t, ConstVec q, ConstVec uA, double dt, Vec h) const override;
  void normalise(Vec q) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  bool feelsGravity(ConstVec) const override { return true; }  // joints may carry it: a wheel
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return static_cast<int>(frames_.size()); }

  Abilities abilities() const override {
    return {.ownInverse = tree_.nu() > kDense ? this : nullptr, .carrier = &carried_};
  }
  int bodies() const { return carried_.carriedBodies(); }

 private:
  static constexpr int kDense = 12;  // velocities up to which M⁻¹ as a matrix costs no more
  struct FixedFrame {
    int node;
    Vec3 r;  // from the node's origin, in its axes
    Mat3 A;
  };
  void placeFrames(TreeBody& body);

  Tree tree_;
  mutable TreeResults results_;
  CarriedBodies carried_;
  std::vector<FixedFrame> frames_;
  Eigen::VectorXd start_, u0_;  // q and u at the start
};

}  // namespace dynamy
