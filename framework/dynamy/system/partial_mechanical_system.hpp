/// PartialMechanicalSystem: part of a mechanical system with its own q and u,
///
///   M(q,t) u̇ = h(q,u,t) + W λ,     q̇ = F(q,t) u + β(q,t)
///
/// as a *population* of `capacity` equal, dynamically independent blocks (one pendulum, or 30 000
/// spheres). The slices q, u, h of all blocks lie one after the other; one virtual call serves all
/// blocks.
#pragma once
#include <dynamy/core/declared/element.hpp>
#include <dynamy/system/frame.hpp>
#include <dynamy/system/tree_part.hpp>

namespace dynamy {

/// Sizes: nq positions and nu velocities per block.
struct Blocks {
  int nq = 0, nu = 0;
  int capacity = 1;
  bool constantMass = false;  ///< M never changes: it is inverted once
  /// Unit normal of the plane that all frames of the system move in; zero: motion in space.
  /// Contacts and joints between such systems need fewer rows.
  Vec3 planeNormal = Vec3::Zero();
  /// True: the system implements applyInverseMass(), and M is computed only on request. For systems
  /// of one block with many velocities.
  bool ownInverse = false;
};

/// Writable view of the mass matrices of all blocks of one system, nu × nu each, row after row.
class MassBlocks {
 public:
  MassBlocks(double* data, int nu, int capacity) : data_(data), nu_(nu), capacity_(capacity) {}
  Block operator[](int block) const {
    return {data_ + static_cast<std::ptrdiff_t>(block) * nu_ * nu_, nu_, nu_};
  }
  int capacity() const { return capacity_; }

 private:
  double* data_;
  int nu_, capacity_;
};

class PartialMechanicalSystem : public Element {
 public:
  static constexpr Kind kKind = Kind::system;
  using Element::Element;

  virtual Blocks blocks() const = 0;
  virtual void initialState(Vec q, Vec u) const = 0;
  /// Mass matrices, symmetric positive definite; all entries must be written.
  virtual void M(double t, ConstVec q, MassBlocks M) const = 0;
  /// out = M⁻¹ in. Only called for systems with Blocks::ownInverse.
  virtual void applyInverseMass(double /*t*/, ConstVec /*q*/, ConstVec /*in*/, Vec /*out*/) const {}
  /// All smooth forces of the system, gyroscopic terms included, those of ExternalForce elements
  /// not; all entries must be written.
  virtual void h(double t, ConstVec q, ConstVec u, Vec h) const = 0;
  /// q̇ = F u + β; default q̇ = u (nq = nu).
  virtual void qdot(double t, ConstVec q, ConstVec u, Vec qdot) const;
  /// q ← q ⊕ Δt q̇ with u constant; default q += Δt q̇(t, q, u); rotations use the exponential map.
  virtual void move(double t, Vec q, ConstVec u, double dt) const;
  /// For systems whose gyroscopic terms change u much in a step. On input, h holds all forces at
  /// u^A, those of other elements included. On output, the system's own gyroscopic terms in h are
  /// those at the mean velocity ½(u^A + u_free) with M (u_free − u^A) = Δt h; there they do no
  /// work. Only for systems with constant mass. Default: h is not changed.
  virtual void gyroscopicAtMean(double /*t*/, ConstVec /*q*/, ConstVec /*uA*/, double /*dt*/,
                                Vec /*h*/) const {}
  /// Brings q back on its manifold after linear combinations (unit quaternions); default: nothing
  /// to do.
  virtual void normalise(Vec) const {}
  /// Between two steps a population may remove blocks and add others. q alone shows which blocks
  /// are present, so that a checkpoint contains them. tA, tE: begin and end of the accepted step
  /// [s]. True: q or u changed.
  virtual bool renews() const { return false; }  ///< true: renew() may change something
  virtual bool renew(double /*tA*/, double /*tE*/, Vec /*q*/, Vec /*u*/) const { return false; }
  /// V(q,t) of the forces in h that have a potential [J].
  virtual double potentialEnergy(double, ConstVec) const { return 0.0; }
  /// Uniform field of gravity g_I [m/s²]: writes its generalised force Σ J_Sᵀ m g into h (all
  /// entries) and returns its potential −Σ m g·r_OS [J]. Default: none, for systems without weight.
  virtual double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const;
  /// True: a field of gravity acts on the system. (The weight may also be part of h and
  /// potentialEnergy.) Default: gravity() is not zero in some direction, at position q. Systems
  /// whose joints may carry all of their weight at q override it.
  virtual bool feelsGravity(ConstVec q) const;
  /// The part of h that neither has a potential nor is gyroscopic (drives, dampers); for the energy
  /// ledger. Default: none.
  virtual void nonPotentialForce(double t, ConstVec q, ConstVec u, Vec h) const;
  /// Frame `id` (0 ≤ id < frames()): r, A, v, Ω, J, ν and the bias. J_S_I, J_R_I point to 3 × nu
  /// numbers. They are zero at the first call; later they hold the values of the call before, so
  /// assign, never add. Entries that are always zero need not be written. `block`: index of the
  /// block within this system (0 if not set); −1: the frame moves with no block.
  virtual void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const;
  virtual int frames() const { return 0; }
  /// True: h has stiff parts. Schemes integrate them linearly implicitly, by means of dh().
  virtual bool stiff() const { return false; }
  /// Derivatives K = ∂h/∂q F, D = ∂h/∂u of one block, all entries; false: none. Schemes that
  /// integrate stiff parts linearly implicitly call it for systems that are stiff(), Newton's
  /// method on positions for all systems.
  virtual bool dh(double /*t*/, ConstVec /*q*/, ConstVec /*u*/, int /*block*/, Block /*K*/,
                  Block /*D*/) const {
    return false;
  }
  /// Derivatives for Newton's method on positions, for systems of one block with constant mass, all
  /// entries; false (default): not offered, differences are taken.
  ///
  /// T of move():  q ⊕ Δt (u + δ) = (q ⊕ Δt u) ⊕ Δt T δ to first order. T is the unit matrix if
  /// q̇ = u.
  virtual bool moveTangent(ConstVec /*u*/, double /*dt*/, Block /*T*/) const { return false; }
  /// K = ∂(J_Sᵀ F + J_Rᵀ M)/∂q F of frame `id`, with F_I [N] and M_I [N m] held in I.
  virtual bool frameStiffness(double /*t*/, ConstVec /*q*/, int /*id*/, const Vec3& /*F_I*/,
                              const Vec3& /*M_I*/, Block /*K*/) const {
    return false;
  }
  /// For systems that are one rigid body, or stand still: the data that a tree of joints needs. All
  /// frames of the system are fixed on the body. False (default): joints of a tree cannot carry the
  /// system.
  virtual bool rigidPart(RigidPart& /*out*/) const { return false; }
  /// q and u of a system with rigidPart() from its motion since the start; for its signals.
  virtual void ownState(const RigidMotion& /*motion*/, Vec /*q*/, Vec /*u*/) const {}
};

}  // namespace dynamy
