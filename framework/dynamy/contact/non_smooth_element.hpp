/// NonSmoothElement: emits all of its contacts (gaps, W and χ) in one call. −ξ_i ∈ N_{C_i}(Λ_i) for
/// each of them.
#pragma once
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/contact/swept_path.hpp>

namespace dynamy {

/// Forces of a joint on its two frames, and how they turn with them.
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
  /// Names → handles, once.
  virtual void connect(Topology& topology) = 0;
  /// Reports every gap that can close, and W and χ rows of the closed ones.
  virtual void contacts(const Kinematics& k, ContactSink& sink) const = 0;
  /// Into how many pieces a step of Δt at these velocities is to be cut to see what it passes; 0:
  /// nothing near another body goes further than that is thick.
  virtual int piecesToSweep(const Kinematics&, double /*dt*/) const { return 0; }
  /// The contact that the path passes first; `element` is the index to be put into its key.
  virtual Passing firstPassing(const SweptPath&, int /*element*/) const { return {}; }
  /// Changes the numbers reserved by Topology::memory, at the end of an accepted step and where any
  /// element switches: twice in one place must be as good as once. A rejected step is rolled back.
  virtual void remember(const Kinematics&, Vec /*memory*/) const {}
  /// Forces of its joint `id` for percussions Λ and their derivative, for Newton's method on
  /// positions; false (default): not offered, differences are taken.
  virtual bool jointForces(const Kinematics&, std::uint64_t /*id*/, const double* /*Lambda*/,
                           JointForces& /*out*/) const {
    return false;
  }
  /// For joints between rigid bodies: what they leave free at the start. Asked before connect(), in
  /// the topology of all bodies; false (default): always a law between its frames.
  virtual bool jointMotion(Topology& /*topology*/, JointMotion& /*out*/) { return false; }
  /// Its motion is a coordinate of a tree from now on: of its laws only those in the free
  /// directions remain. Called before connect().
  virtual void becomeCoordinate() {}
  /// Name of one of its contacts in reports, the element's own left out; "": its number is shown.
  virtual std::string contactName(std::uint64_t /*id*/) const { return {}; }
};

}  // namespace dynamy
