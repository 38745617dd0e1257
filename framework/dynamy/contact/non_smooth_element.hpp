/// NonSmoothElement: emits all of its contacts (gaps, W and χ) in one call. −ξ_i ∈ N_{C_i}(Λ_i) for
/// each of them.
#pragma once
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/contact/swept_path.hpp>
#include <dynamy/system/tree_part.hpp>

namespace dynamy {

class PathReach;

/// Forces of a joint on its two frames, and their derivatives with respect to motion of the frames.
struct JointForces {
  FrameHandle frame[2];
  Vec3 F[2], M[2];  ///< on frame A and B, about their origins, in I [N, N m, times the unit of Λ]
  /// Derivatives of (F_A, M_A, F_B, M_B) with respect to displacements and small rotations
  /// (δr_A, δθ_A, δr_B, δθ_B) of the two frames, in I.
  Eigen::Matrix<double, 12, 12> D;
};

class NonSmoothElement : public Element {
 public:
  static constexpr Kind kKind = Kind::contact;
  using Element::Element;
  /// Turns names into handles. Called once.
  virtual void connect(Topology& topology) = 0;
  /// Reports every gap that can close, and the rows of W and χ of closed contacts.
  virtual void contacts(const Kinematics& k, ContactSink& sink) const = 0;
  /// Adds to `out` the contacts of this element, number `element`, that can close on a path from `start`
  /// of bodies that move no further than `reach`. False (default): the element cannot tell, and all
  /// its contacts are followed.
  virtual bool nearOnPath(const Kinematics& /*start*/, const PathReach& /*reach*/, int /*element*/,
                          NearContacts& /*out*/) const {
    return false;
  }
  /// Adds the frames on which contact `id` depends, if it depends on nothing else that changes but
  /// time. False (default): all frames are evaluated before each look at this contact.
  virtual bool framesOf(std::uint64_t /*id*/, std::vector<FrameHandle>& /*out*/) const {
    return false;
  }
  /// Number of pieces into which a step of Δt at these velocities is cut to find contacts that it
  /// passes through. 0: no bodies near each other move further than their thickness.
  virtual int piecesToSweep(const Kinematics&, double /*dt*/) const { return 0; }
  /// The contact that the path passes through first. `element`: this element's index, for the key.
  virtual Passing firstPassing(const SweptPath&, int /*element*/) const { return {}; }
  /// Updates the numbers reserved by Topology::memory. Called at the end of an accepted step and
  /// wherever any element switches; a second call at the same state must have no further effect.
  /// A rejected step is rolled back.
  virtual void remember(const Kinematics&, Vec /*memory*/) const {}
  /// Why `memory`, read from a checkpoint, cannot be numbers of this element; empty (default): it
  /// can. Elements that take an index from their memory check it here, once, and never within a step.
  virtual std::string memoryFault(ConstVec /*memory*/) const { return {}; }
  /// Forces of this element's joint `id` for percussions Λ, and their derivative, for Newton's
  /// method on positions. False (default): not offered, differences are taken.
  virtual bool jointForces(const Kinematics&, std::uint64_t /*id*/, const double* /*Lambda*/,
                           JointForces& /*out*/) const {
    return false;
  }
  /// For joints between rigid bodies: the motion that the joint leaves free at the start. Called
  /// before connect(), with the topology of all bodies. False (default): the joint always remains a
  /// law between its frames.
  virtual bool jointMotion(Topology& /*topology*/, JointMotion& /*out*/) { return false; }
  /// As isMirrored(), for elements that find out by the bodies they connect. Called before connect().
  virtual bool keepsPlane(const MirrorPlane& plane) { return isMirrored(plane); }
  /// Makes the motion of the joint a coordinate of a tree: only its laws in the free directions
  /// remain. Called before connect().
  virtual void becomeCoordinate() {}
  /// Name of contact `id` in reports, without the name of the element; "": the number is shown.
  virtual std::string contactName(std::uint64_t /*id*/) const { return {}; }
};

}  // namespace dynamy
