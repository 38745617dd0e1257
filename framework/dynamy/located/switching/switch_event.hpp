/// SwitchEvent: what happens at the instant of a switch (theory 50.4).
///
///   1  project with the old status
///   2  impact of all contacts that are closed or touch:   M(u⁺ − u⁻) = WΛ with the impact law
///   3  decide the new status by one inclusion that looks ahead by h_s,
///          ξ = G(q + h_s u) Λ + W(q + h_s u)ᵀ(u + h_s M⁻¹h) + χ − residual of resting rows
///   4  project with the new status, accelerations
///   5  contacts that leave and return within the tolerance stay closed:  v²/(2a) ≤ z tol L;
///      likewise a preloaded spring that passes its middle comes to rest there
///
/// Looking ahead is what makes a switch from stick to slip decidable: at the switch itself the
/// force lies on the bound. It needs no enumeration and works for redundant contacts, since it is
/// an inclusion like any other.
#pragma once
#include <dynamy/law/most_rows.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/located/phase/smooth_step.hpp>
#include <dynamy/located/switching/contact_probe.hpp>
#include <memory>

namespace dynamy {

/// Wraps another law and removes its restitution.
class WithoutRebound final : public SetValuedForceLaw {
 public:
  explicit WithoutRebound(const SetValuedForceLaw* of = nullptr) : law_(of) {}
  int dim(int geometric) const override { return law_->dim(geometric); }
  bool unilateral() const override { return law_->unilateral(); }
  RowKind rowKind(int row) const override { return law_->rowKind(row); }
  int groupEnd(int row, int dim) const override { return law_->groupEnd(row, dim); }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override {
    law_->prox(in, r, xi, Lambda);
  }
  void naturalMap(const LawInput& in, double rho, const double* xi, const double* Lambda,
                  double* e) const override {
    law_->naturalMap(in, rho, xi, Lambda, e);
  }
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override {
    return law_->proxDerivative(in, rho, xi, Lambda, A, B);
  }
  SimpleSet simpleSet(const LawInput& in) const override { return law_->simpleSet(in); }
  const NormalTimesReservoir* reservoir() const override { return law_->reservoir(); }
  const NormalTimesReservoir* discs() const override { return law_->discs(); }
  Status status(const LawInput& in, const double* argument) const override {
    return law_->status(in, argument);
  }

 private:
  const SetValuedForceLaw* law_;
};

/// Percussions of one contact at an event, and its relative velocities before them, for the report
/// of the step.
struct Percussion {
  ContactKey key;
  int dim = 0;
  std::array<double, kMostRows> Lambda{}, gammaMinus{};
  bool unilateral = false;
};

class SwitchEvent {
 public:
  struct Result {
    bool impact = false, changed = false, undecided = false;
    int accumulations = 0;
    double accumulationEnd = 0.0;  ///< [s]
    SolveReport solved;
    std::string_view fault;
    ContactKey lost;  ///< contact of the faults FrozenPhase::kLost and kOtherSet
  };
  void prepare(const MechanicalSystem& s, const ErrorNorm& norm);
  /// Plain: decides by the inclusion on the level of accelerations at the instant itself; contacts
  /// that leave are open however soon they return.
  void plain(bool wanted) { plain_ = wanted; }
  /// In plain decisions from now on contact `key`, whose friction has reached its bound, slips in
  /// its one tangent with the sign of `direction`; 0: no contact is released.
  void release(ContactKey key, double direction) { released_ = key, direction_ = direction; }
  /// Contacts of the same two bodies that are nearer than this part of L count as one.
  static constexpr double kSame = 4e-6;
  /// Excludes contact `key` from the next decision, since its features leave one another.
  void leave(ContactKey key) { left_ = key; }
  /// Processes the event at p.x: changes p.x, `phase` and p (accelerations under the new status).
  /// `lookAhead`: h_s; `stopped`: parts whose slip ends here whatever speed is left. Slot 0 is left
  /// evaluated at p.x with all contacts that took part.
  Result process(MechanicalSystem& s, InclusionSolver& solver, ContactProbe& probe,
                 FrozenPhase& phase, PhasePoint& p, const SmoothStep& smooth, double lookAhead,
                 const std::vector<HeldKey>& stopped);
  /// Percussions of the last process(); works() are theirs.
  const std::vector<Percussion>& percussions() const { return percussions_; }
  const std::array<double, 5>& works() const { return works_; }
  /// Velocities before the impact of the last process().
  const Eigen::VectorXd& uBefore() const { return uBefore_; }

 private:
  static constexpr double kSlip = 1e-9;  // slips above this part of U continue
  static constexpr ContactKey kNone{~std::uint64_t{0}};
  /// z tol, as a part of L: a contact that would rise no higher stays closed.
  double zenoHeight() const;
  bool takePart(ContactProbe& probe, const FrozenPhase& phase, const State& x);
  bool touches(const ContactProbe& probe, int i) const;
  bool leaves(const ContactProbe& probe, int i) const;
  void projectHeld(MechanicalSystem& s, const FrozenPhase& phase, State& x);
  void leaveToJoints(MechanicalSystem& s, const State& x);
  void leaveOneOfEach(const ContactProbe& probe, const FrozenPhase& phase);
  void projectPositions(MechanicalSystem& s, const FrozenPhase& phase, State& x);
  void projectVelocities(MechanicalSystem& s, FrozenPhase& phase, State& x);
  bool accelerateAlone(MechanicalSystem& s, PhasePoint& p);
  bool impact(MechanicalSystem& s, InclusionSolver& solver, State& x, Result& r);
  void notePercussions(const MechanicalSystem& s);
  void shut(MechanicalSystem& s, State& x);
  void chooseClosed(MechanicalSystem& s, const State& x);
  void accelerationLevel(InclusionProblem& p, double unit);
  double pose(InclusionProblem& p, bool jumped, const std::vector<HeldKey>& stopped);
  void decide(MechanicalSystem& s, InclusionSolver& solver, const State& x, double lookAhead,
              const FrozenPhase& old, const std::vector<HeldKey>& stopped, FrozenPhase& phase,
              Result& r);
  void readStatus(const InclusionProblem& p, ConstVec Lambda, double lookAhead,
                  const FrozenPhase& old, FrozenPhase& phase);
  /// Rows of a contact that have a status of their own in a decision.
  struct Block {
    int contact, first, rows;  // the contact; first row within it, and number of rows
    int row, slip, slipRows;   // rows of the problem: first one, first one of slip, number of slip
    bool slips = false;
  };
  Held status(const InclusionProblem& p, ConstVec Lambda, const Block& b, double lookAhead,
              const FrozenPhase& old) const;
  void findBlocks(const InclusionProblem& p);
  /// Speed of slip of a block; `gamma`: relative velocities of all rows of the problem.
  static double speedOf(const InclusionProblem& p, const Block& b, const Eigen::VectorXd& gamma);
  bool staysClosed(const MechanicalSystem& s, const FrozenPhase& phase, const PhasePoint& p,
                   Result& r);
  double closing(const ContactSet& c, std::size_t i, const Eigen::VectorXd& a) const;
  // Sets on displacements (switch_notches.cpp).
  double side(const ContactSet& c, std::size_t i, const double* gamma) const;
  void holdNotches(ContactSet& c);
  bool staysInNotch(const MechanicalSystem& s, const FrozenPhase& old, const FrozenPhase& phase,
                    const PhasePoint& p, Result& r);
  const ErrorNorm* norm_ = nullptr;
  std::vector<ContactKey> keys_, closing_, plastic_, shut_, borne_;
  std::vector<std::unique_ptr<WithoutRebound>> wrappers_;
  std::vector<Percussion> percussions_;
  std::array<double, 5> works_{};
  Eigen::VectorXd uBefore_, aBefore_, delta_, gamma_, gammaBefore_, xi_;
  bool plain_ = false;
  ContactKey released_, left_ = kNone;
  std::vector<int> taking_, alike_;
  double direction_ = 0.0;
  double leaves_ = 0.0;  // speed above which a contact leaves [m/s]
  std::vector<Block> blocks_;
  std::vector<std::array<int, 2>> parts_;
  State look_;
  FrozenPhase next_, shutPhase_;
};

}  // namespace dynamy
