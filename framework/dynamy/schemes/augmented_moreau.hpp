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
#include <dynamy/schemes/augmented/block_lengths.hpp>
#include <dynamy/schemes/augmented/closed_contacts.hpp>
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
  bool block(MechanicalSystem& s, InclusionSolver& solver, State& x, double H);
  bool subStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h);
  void plainStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h);
  void switchStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h);
  bool endIsFree(const MechanicalSystem& s, const State& x);
  void begin(State& x);
  void endOfRow(const State& x);
  void extrapolated(const MechanicalSystem& s, State& x);
  enum class Rebound : std::uint8_t { all, ofNew };
  void baseStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h, Rebound rebound);

  Options options_;
  BlockLengths lengths_{options_.order, options_.dtMin};
  ClosedContacts closed_;
  DiscreteState sigma_, sigmaBlock_, sigmaNow_;
  Extrapolation table_;
  State begin_;
  StepReport report_;
  ImpactProblem* problem_ = nullptr;  // of the last sub-step
  std::vector<double> Lambda_;        // percussions of the last row, summed
  WorkMeter meter_;
  StepWorks works_;    // works of the present row of the table
  Eigen::VectorXd z_;  // extrapolated quantities: q, u and works
  Eigen::VectorXd uA_;
};

}  // namespace dynamy
