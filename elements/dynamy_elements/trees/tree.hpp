/// Tree: kinematics and dynamics of rigid bodies on a tree of simple motions (theory 39).
///
/// A node has axes K, which are those of the world at the start, and its origin O at the joint
/// point. A joint is a chain of nodes; those between two bodies have no mass. A new joint type is a
/// list of simple motions; a new simple motion is one case in pose(), rates() and Columns. With P
/// the parent of K, d = r_K − r_P and the screw (w, v) of a velocity u_j
///
///   turn   w = a, v = 0          slide  w = 0, v = a          a = A_K axis
///   screw  w = a, v = p a        ball   w_i = A_P e_i, v = 0
///   Ω_K = Ω_P + Σ w u,   v_K = v_P + Ω_P × d + Σ v u                                  (39.1)
///   M_jj also has the rotor inertia of motion j                                        (39.3)
///   β_R = β_RP + Ω_P × Σ w u,  β_S = β_SP + β_RP × d + Ω_P × (Ω_P × d) + 2 Ω_P × Σ v u (39.2)
///
/// All vectors are in components of the world, with moments about each node's own origin, so that
/// rounding depends on distances within the mechanism only. Axes of the bodies were rejected:
/// Jacobians of frames are required in the world.
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/tree_part.hpp>
#include <vector>

namespace dynamy {

struct TreeNode {
  FreeMotion::Kind kind = FreeMotion::Kind::turn;
  int parent = -1;             ///< lower than its own index; −1: the fixed world
  int q0 = 0, u0 = 0;          ///< index of its first coordinate and velocity
  Vec3 axis = Vec3::UnitZ();   ///< unit, in axes K
  double pitch = 0.0;          ///< of a screw [m/rad]
  double rotor = 0.0;          ///< of a turn or slide: what its rate alone moves [kg m² or kg]
  Vec3 arm = Vec3::Zero();     ///< joint point from the parent's origin, in axes P [m]
  double m = 0.0;              ///< mass of all bodies fixed to it [kg]
  Vec3 centre = Vec3::Zero();  ///< their centre of mass from O, in axes K [m]
  Mat3 J = Mat3::Zero();       ///< inertia about it, in axes K [kg m²]
  int nq() const { return kind == FreeMotion::Kind::ball ? 4 : 1; }
  int nu() const { return kind == FreeMotion::Kind::ball ? 3 : 1; }
};

/// Position and motion of a node, with mass and moment of all nodes that it carries.
struct NodeMotion {
  Mat3 A;       ///< A_IK
  Vec3 r;       ///< origin O [m]
  Vec3 a;       ///< axis
  Vec3 d;       ///< r − r_P
  double mass;  ///< of the node and all that it carries [kg]
  Vec3 moment;  ///< Σ m (r_S − r) of the same [kg m]
  Vec3 Omega, v, biasR, biasS;
};

class Tree {
 public:
  /// Appends a node, whose parent must have been added before. Returns its index.
  int add(TreeNode node);
  /// Fixes a body to node k: mass m, centre of mass in axes K from O, inertia about it.
  void addMass(int k, double m, const Vec3& centre, const Mat3& J);

  int nq() const { return nq_; }
  int nu() const { return nu_; }
  int size() const { return static_cast<int>(nodes_.size()); }
  const TreeNode& node(int k) const { return nodes_[static_cast<std::size_t>(k)]; }
  /// Is M independent of q? It is for a tree of slides only, or of one single motion that
  /// is no ball.
  bool constantMass() const;

  using Motions = std::vector<NodeMotion>;
  /// Computes positions, and mass and moment of all that each node carries.
  void pose(const double* q, Motions& out) const;
  /// Computes velocities and biases; after pose().
  void rates(const double* u, Motions& out) const;
  /// M by composite bodies; after pose(). `work`: one inertia per node.
  void mass(const Motions& x, std::vector<Mat3>& work, Block M) const;
  /// −Σ Jᵀ(M_b β + gyroscopic terms); after rates(). `work`: two vectors per node.
  void gyroscopic(const Motions& x, std::vector<Vec3>& work, Vec h) const;
  /// Weight Σ J_Sᵀ m g and the potential −Σ m g·r_S [J]; after pose().
  double gravity(const Motions& x, const Vec3& g_I, Vec h) const;
  /// out_j = Σ w_j·L + v_j·p over all nodes that are moved by u_j. `work` has p and L about O of
  /// each node, force-like, as (p_0, L_0, p_1, …); they are summed up towards the roots.
  void project(const Motions& x, std::vector<Vec3>& work, Vec out) const;

  /// Columns of node k: per u_j angular velocity w and velocity v of the point at r.
  struct Columns {
    Vec3 w[3], v[3];
    int n = 1;
  };
  Columns columns(const Motions& x, int k) const;

  /// Articulated inertia of a node about its origin: the inertia that it has while all nodes after
  /// it follow freely. f = m a + C α, n = Cᵀ a + I α; for one motion S with the part U = I_A S.
  struct Articulated {
    Mat3 m, C, I;
    Vec3 Uf, Un;
    double inverse;   ///< 1/(Sᵀ U)
    Mat3 inverseOfI;  ///< of a ball joint, in the world
  };
  /// Computes the articulated inertias, with a cost linear in the number of nodes; after pose().
  void factor(const Motions& x, std::vector<Articulated>& out) const;
  /// out = M⁻¹ in, with a cost linear in the number of nodes. `work`: two vectors per node.
  void solve(const Motions& x, const std::vector<Articulated>& factors, ConstVec in,
             std::vector<Vec3>& work, Vec out) const;

 private:
  /// Projects a force f and a moment n about the origin of node k onto the node's own columns.
  void along(const Motions& x, int k, const Vec3& f, const Vec3& n, Vec out) const;
  std::vector<TreeNode> nodes_;
  int nq_ = 0, nu_ = 0;
};

/// Axes of the angular velocity of a ball: those of its parent P, in which a body that spins about
/// its axis of symmetry has an angular velocity that changes slowly.
const Mat3& turnAxes(const Tree::Motions& x, const TreeNode& node);

}  // namespace dynamy
