/// TreeSystem: bodies that joints connect, as one system in the coordinates of these joints. The
/// system owns the bodies; their frames, shapes and signals keep their names.
///
///   M(q) u̇ = h(q, u) + W λ,   q = 0 and unit quaternions where the model file puts the bodies
///
/// It is made by composeTrees() from the bodies and joints of a model, never by an XML tag.
#pragma once
#include <array>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/own_inverse.hpp>
#include <dynamy/system/tree_part.hpp>
#include <dynamy_elements/trees/tree_results.hpp>
#include <memory>

namespace dynamy {

/// A body of a TreeSystem.
struct TreeBody {
  std::unique_ptr<PartialMechanicalSystem> system;
  int node = -1;  ///< node that it is fixed to; −1: the fixed world
  int first = 0;  ///< node of its joint's first motion, node + 1 if it has none
  int frame0 = 0;
  Vec3 S = Vec3::Zero();  ///< centre of mass from the node's origin, in its axes
  RigidPart part;
  Blocks blocks;
  Vec3 v = Vec3::Zero(), Omega = Vec3::Zero();  ///< as given at the start
};

class TreeSystem final : public PartialMechanicalSystem, public OwnInverse {
 public:
  using System = std::unique_ptr<PartialMechanicalSystem>;
  /// `x`: type and place of the first body. `planeNormal`: as in Blocks.
  TreeSystem(const Parameters& x, const Vec3& planeNormal)
      : PartialMechanicalSystem(x), planeNormal_(planeNormal) {}

  /// Adds a body that is carried by `parent` (index of another body, −1: the fixed world) and moves
  /// relative to it by the motions `free` at the point `at_I`. Returns its index.
  int carry(System body, int parent, const Vec3& at_I, const std::vector<FreeMotion>& free);
  /// To be called after the last body: computes the velocities at the start. Velocities of the
  /// bodies that joints do not allow are lost as by an impact; returns the largest change of a
  /// body's velocity [m/s, rad/s].
  double finish();

  Blocks blocks() const override {
    return {tree_.nq(), tree_.nu(), 1, tree_.constantMass(), planeNormal_};
  }
  void describe(Description& d) const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  const OwnInverse* ownInverse() const override { return tree_.nu() > kDense ? this : nullptr; }
  void applyInverseMass(double t, ConstVec q, ConstVec in, Vec out) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  void qdot(double t, ConstVec q, ConstVec u, Vec qdot) const override;
  void move(double t, Vec q, ConstVec u, double dt) const override;
  void normalise(Vec q) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  bool feelsGravity(ConstVec) const override { return true; }  // joints may carry it: a wheel
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return static_cast<int>(frames_.size()); }

  int bodies() const { return static_cast<int>(bodies_.size()); }

 private:
  static constexpr int kMostOwn = 16;  // most coordinates of a single body
  static constexpr int kDense = 12;    // velocities up to which M⁻¹ as a matrix costs no more
  struct FixedFrame {
    int node;
    Vec3 r;  // from the node's origin, in its axes
    Mat3 A;
  };
  void placeFrames(TreeBody& body);
  double ownSignal(const TreeBody& body, const SignalFunction& f, const SignalView& v) const;

  Tree tree_;
  Vec3 planeNormal_;
  std::vector<TreeBody> bodies_;
  std::vector<FixedFrame> frames_;
  Eigen::VectorXd start_, u0_;  // q and u at the start
  mutable TreeResults results_;
  /// The body whose signals were requested last, with its own q and u there.
  struct Shown {
    const TreeBody* body = nullptr;
    long changes = 0;  // TreeResults::changes() there
    std::array<double, kMostOwn> q{}, u{};
  };
  mutable Shown shown_;
};

}  // namespace dynamy
