/// Augmented time-stepping (theory 51) [studer2009]: in smooth phases, Moreau's midpoint rule is
/// the base of an extrapolation. Around the instants where the discrete state σ changes, steps are
/// halved down to Δt_min.
///
///   block    T_{j,1} = base^j(x, H/j),  j = 1 … N;   x^E = T_{N,N}      if σ is constant in it
///   switch   H ← H/2 until the block is smooth, or H = Δt_min: one step of the base
///
/// A step is one block or one switch; Δt is the largest length of a block. Contacts that carried
/// stay closed until they pull. Rejected: base steps that search for closed contacts anew. The
/// midpoint may leave a curved surface by O(Δt²), and every such step would then look like a
/// switch.
#pragma once
#include <dynamy/stages/discrete_state.hpp>
#include <dynamy/stages/extrapolation.hpp>
#include <dynamy/stages/work_meter.hpp>

namespace dynamy {

class AugmentedMoreau final : public OneStep {
 public:
  struct Options {
    int order = 4;       ///< N: rows of the table
    double dtMin = 0.0;  ///< Δt_min [s]; 0: (Δt_max in s)^N / 4 s
    bool checkEnds = true;
  };
  AugmentedMoreau() = default;
  explicit AugmentedMoreau(const Options& options) : options_(options) {}
  explicit AugmentedMoreau(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return options_.order; }
  std::string_view lacks(Asked what) const override {
    return what == Asked::stiffForces && options_.order > 1
               ? "its extrapolation is unstable where Δt does not resolve a stiff element"
               : std::string_view();
  }
  bool choosesSteps() const override { return true; }
  bool needsStep() const override { return true; }  // Δt_max
  double nextStep(const State& x) const override;
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
  void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out) const override;

 private:
  /// Data kept from step to step, in State::scheme.
  struct Plan {
    double dtMax = 0.0;      ///< the largest Δt required so far [s]
    double next = 0.0;       ///< length to be tried next [s]
    double failedEnd = 0.0;  ///< end of the shortest block that failed [s], while bisecting
    bool bisecting = false;
    double windowStart = 0.0;  ///< time since which switches are counted [s]
    int switches = 0;          ///< number of switches since then
    double plainUntil = 0.0;   ///< plain time-stepping up to here [s]
  };
  void restore(const State& x, double dt);
  void store(State& x) const;
  double dtMin() const;
  bool block(MechanicalSystem& s, InclusionSolver& solver, State& x, double H);
  bool subStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h);
  void plainStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h);
  void countSwitch();
  void restOfClosed(InclusionProblem& p, double h) const;
  void begin(State& x);
  void endOfRow(const State& x);
  void extrapolated(const MechanicalSystem& s, State& x);
  enum class Rebound : std::uint8_t { all, ofNew };
  void baseStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h, Rebound rebound);
  const ContactSet& evaluatedContacts(const MechanicalSystem& s, const State& x,
                                      const ContactRequest& request);
  void closedAt(const MechanicalSystem& s, const State& x);
  bool endIsFree(const MechanicalSystem& s, const State& x);
  bool anyPassed(const ContactSet& c, double least) const;
  void accepted(double t, double H);

  Options options_;
  Plan plan_;
  DiscreteState sigma_, sigmaBlock_, sigmaNow_;
  Extrapolation table_;
  State begin_;
  StepReport report_;
  std::vector<ContactKey> closed_;   // contacts closed during the block, whatever their gaps
  std::vector<ContactKey> pressed_;  // contacts that pressed in the step before
  Kinematics kinematics_;
  bool ready_ = false;
  ContactSet contacts_;
  std::vector<double> Lambda_;  // percussions of the last row, summed
  WorkMeter meter_;
  StepWorks works_;    // works of the present row of the table
  Eigen::VectorXd z_;  // extrapolated quantities: q, u and works
  Eigen::VectorXd uA_;
};

}  // namespace dynamy
