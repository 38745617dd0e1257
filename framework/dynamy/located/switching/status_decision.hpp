/// StatusDecision: the statuses that begin at a switch (theory 50.4), by one inclusion that looks
/// ahead by h_s,
///
///   ξ = G(q + h_s u) Λ + W(q + h_s u)ᵀ(u + h_s M⁻¹h) + χ − residual of resting rows,
///   −ξ ∈ N_C(Λ)
///
/// Looking ahead is what makes a switch from stick to slip decidable: at the switch itself the
/// force lies on the bound. It needs no enumeration and works for redundant contacts, since it is
/// an inclusion like any other. Plain decisions do without: they pose the inclusion on the level of
/// accelerations at the instant itself, where a contact whose friction has reached its bound is
/// released in the direction that this friction resists.
#pragma once
#include <dynamy/located/phase/force_set.hpp>
#include <dynamy/located/switching/ongoing_event.hpp>

namespace dynamy {

class StatusDecision {
 public:
  /// A contact that slips in its one tangent with the sign of `direction`; 0: none.
  struct Release {
    ContactKey key;
    double direction = 0.0;
  };
  /// What a decision begins with.
  struct Start {
    double lookAhead;                     ///< h_s [s]
    const std::vector<Held>& held;        ///< statuses of the phase that ends
    const Eigen::VectorXd& a;             ///< its accelerations at the switch
    const std::vector<HeldKey>& stopped;  ///< parts whose slip ends here whatever speed is left
    double leaves;                        ///< speed above which a contact leaves [m/s]
    bool impact;                          ///< there was an impact
    bool jumped;                          ///< velocities have jumped
    bool plain;                           ///< decides at the instant itself,
    Release released;                     ///< with this contact released
  };
  /// Decides at the velocities p.x.u of the event: `held` are the new statuses. Contacts of slot 0
  /// that do not leave take part; slot 1 is evaluated ahead.
  void decide(OngoingEvent& at, const Start& start, std::vector<Held>& held);

 private:
  /// Rows of a contact that have a status of their own in a decision.
  struct Block {
    int contact, first, rows;  // the contact; first row within it, and number of rows
    int row, slip, slipRows;   // rows of the problem: first one, first one of slip, number of slip
    bool slips = false;
  };
  void chooseClosed(const OngoingEvent& at, double leaves);
  ImpactProblem* look(OngoingEvent& at, const Start& start);
  void accelerationLevel(const OngoingEvent& at, const Start& start, InclusionProblem& p);
  void findBlocks(const InclusionProblem& p);
  void pose(const OngoingEvent& at, const Start& start, InclusionProblem& p);
  void readStatus(const InclusionProblem& p, ConstVec Lambda, const Start& start,
                  std::vector<Held>& held) const;
  Held status(const InclusionProblem& p, ConstVec Lambda, const Block& b, const Start& start) const;
  /// Speed of slip of a block; `gamma`: relative velocities of all rows of the problem.
  static double speedOf(const InclusionProblem& p, const Block& b, const Eigen::VectorXd& gamma);
  std::vector<ContactKey> closed_;  // contacts that take part, ascending
  Eigen::VectorXd gamma_;           // relative velocities of all contacts of slot 0
  Eigen::VectorXd gammaBefore_;     // of the rows of the problem
  Eigen::VectorXd xi_;
  std::vector<Block> blocks_;
  std::vector<std::array<int, 2>> parts_;
  State look_;
};

}  // namespace dynamy
