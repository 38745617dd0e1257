/// Pairs of features of a capsule and a box or polyhedron, or of two capsules, one by one, so that
/// each gap can be followed on its own (feature_pairs.hpp does so for flat faces).
///
///   end of the capsule, nearest place of the body   g = |c − p| − R
///   edge of the body, side of the capsule           g = |p_B − p_A| − R
///   corner of the body, side of the capsule         g = |c − p| − R
///
/// The place nearest to an end moves over a convex body without a jump. The presence [m]:
///
///   end      over a face always, else where the place lies on its half ball
///   edge     distance of the crossing from the ends of both lines; at most the margin of n within
///            the normals of the faces
///   corner   distance of its foot from the ends of the axis; at most the margin of n within the
///            cone of normals
///
/// Where it becomes zero another pair takes over at the same place, with the same gap and its first
/// derivatives: of a line that ends there the gap is smaller on both sides. So a pair that remained
/// present beyond would keep the other one below zero, and no sign would tell that it closes.
#pragma once
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>

namespace dynamy {

/// The capsule of B and the box or polyhedron of A, in space. Pairs of features are numbered: ends
/// of the capsule, edges of the body, corners of the body, the latter two as in capsuleOnBox and in
/// capsuleOnSurface.
class CapsuleFeatures {
 public:
  CapsuleFeatures(const Frame& A, const TouchingShape& body, const Frame& B,
                  const TouchingShape& capsule);
  static int count(const TouchingShape& body);
  FollowedPair pair(int f) const;
  /// Appends, in ascending order, the pairs that may touch while A and B move by at most `within`.
  void near(const Nearness& within, std::vector<int>& out) const;

 private:
  /// An edge with the normals of its faces, in the world; `along`: sign of (n_f × n_g)·e.
  struct Edge {
    LineSegment line;
    Vec3 nf, ng;
    double along;
    /// Sine of the angle by which n ⟂ e lies within the normals.
    double within(const Vec3& n) const;
  };
  Edge edge(int i) const;
  Vec3 corner(int i) const;
  /// Sine of the angle by which n lies within the normals around corner i.
  double withinCone(int i, const Vec3& n) const;
  FollowedPair end(int i) const;
  int edges() const;
  int corners() const;

  const Frame &A_, &B_;
  const TouchingShape &body_, &capsule_;
  Mat3 R_;
  Vec3 c_;
  LineSegment axis_;
  double radius_;
};

/// Two capsules. Pairs of features are numbered as the contacts of betweenCapsules; in `plane`,
/// which is zero in space. An end of A counts where its foot is on the side of B: ends on ends
/// belong to the ends of B.
class TwoCapsules {
 public:
  TwoCapsules(const Frame& A, const TouchingShape& a, const Frame& B, const TouchingShape& b,
              const Vec3& plane)
      : A_(A),
        B_(B),
        a_(a),
        b_(b),
        plane_(plane),
        axisA_(capsuleAxis(A, a)),
        axisB_(capsuleAxis(B, b)) {}
  FollowedPair pair(int f) const;
  void near(const Nearness& within, std::vector<int>& out) const;

 private:
  const Frame &A_, &B_;
  const TouchingShape &a_, &b_;
  const Vec3& plane_;
  LineSegment axisA_, axisB_;
};

}  // namespace dynamy
