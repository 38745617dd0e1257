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

namespace dynamy {

class BodyCarrier;
class OwnInverse;
class PositionTangents;
class Renewable;
class RigidSystem;

/// Sizes: nq positions and nu velocities per block.
struct Blocks {
  int nq = 0, nu = 0;
  int capacity = 1;
  bool constantMass = false;  ///< M never changes: it is inverted once
  /// Unit normal of the plane that all frames of the system move in; zero: motion in space.
  /// Contacts and joints between such systems need fewer rows.
  Vec3 planeNormal = Vec3::Zero();
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

/// What only some systems can do. Null: the system cannot. The answer must not change during a run;
/// methods ask where they begin, never for every contact.
struct Abilities {
  const Renewable* renewable = nullptr;    ///< removal and addition of blocks between two steps
  const OwnInverse* ownInverse = nullptr;  ///< M⁻¹; for one block whose mass is not constant
  /// Derivatives for Newton's method on positions.
  const PositionTangents* positionTangents = nullptr;
  /// The system as one rigid body, or as one at rest, that joints of a tree can carry.
  const RigidSystem* rigid = nullptr;
  /// The system as carrier of bodies whose own coordinates elements may read.
  const BodyCarrier* carrier = nullptr;
};

class PartialMechanicalSystem : public Element {
 public:
  static constexpr Kind kKind = Kind::system;
  using Element::Element;

  virtual Blocks blocks() const = 0;
  virtual void initialState(Vec q, Vec u) const = 0;
  /// Mass matrices, symmetric positive definite; all entries must be written.
  virtual void M(double t, ConstVec q, MassBlocks M) const = 0;
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

  /// Default: none of them.
  virtual Abilities abilities() const { return {}; }
};

}  // namespace dynamy
