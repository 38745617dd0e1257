/// CarriedBodies: the bodies of a TreeSystem, and their own coordinates at the coordinates of its
/// joints (theory 39.7).
#pragma once
#include <array>
#include <dynamy/system/body_carrier.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/tree_part.hpp>
#include <dynamy_elements/trees/tree_results.hpp>
#include <memory>
#include <vector>

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

class CarriedBodies final : public BodyCarrier {
 public:
  /// `tree` and `results` are those of the system that owns this. `planeNormal`: as in Blocks.
  CarriedBodies(const Tree& tree, TreeResults& results, const Vec3& planeNormal)
      : tree_(tree), results_(results), planeNormal_(planeNormal) {}
  CarriedBodies(const CarriedBodies&) = delete;
  CarriedBodies& operator=(const CarriedBodies&) = delete;

  void add(TreeBody body) {
    expects(body.blocks.nq <= kMostOwn && body.blocks.nu <= kMostOwn,
            "a rigid body has few coordinates");
    bodies_.push_back(std::move(body));
  }
  const std::vector<TreeBody>& all() const { return bodies_; }
  const Vec3& planeNormal() const { return planeNormal_; }

  int carriedBodies() const override { return static_cast<int>(bodies_.size()); }
  const PartialMechanicalSystem& carriedBody(int i) const override {
    return *bodies_[static_cast<std::size_t>(i)].system;
  }
  void ownState(int i, ConstVec q, ConstVec u, Vec qOwn, Vec uOwn) const override;
  void ownVelocities(int i, ConstVec q, ConstVec u, Block J, Vec bias) const override;

  /// Motion of a body's centre of mass, with the quaternion of its turning since the start.
  RigidMotion motion(const TreeBody& body, const double* q, const Tree::Motions& x) const;
  /// Value of a signal that `body` describes in its own coordinates.
  double signal(const TreeBody& body, const SignalFunction& f, const SignalView& v) const;

 private:
  static constexpr int kMostOwn = 16;  // most coordinates of a single body
  const Tree& tree_;
  TreeResults& results_;
  Vec3 planeNormal_;
  std::vector<TreeBody> bodies_;
  /// The body whose signals were requested last, with its own q and u there.
  struct Shown {
    const TreeBody* body = nullptr;
    long changes = 0;  // TreeResults::changes() there
    std::array<double, kMostOwn> q{}, u{};
  };
  mutable Shown shown_;
};

/// Adds columns of a frame for the velocities of a node on its way to the
/// root: w and v + w × (r − r_K).
void addColumns(const Tree::Motions& x, const TreeNode& node, const NodeMotion& at, Frame& f);

}  // namespace dynamy
