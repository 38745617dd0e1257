/// GapWatch: the worst overlap and the worst error of a joint at ends of steps:
///
///   overlap     penetration is measured where steps evaluate the contacts, and at the ends of
///               steps, which are recorded: γ^E extrapolates from the former to the latter. If the
///               extrapolated depth exceeds all before, gaps are evaluated there, as long as that
///               costs little
///   rows        within steps in time of a scheme that locates switches, gaps are evaluated where
///               rows are recorded: such a step may be long, and bodies between its ends overlap. So they
///               are in all its steps once bodies have been inside each other
///   joints      position errors, evaluated at sampled ends of steps: schemes hold joints there,
///               not where they evaluate them
#pragma once
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/report/row_instants.hpp>
#include <dynamy/simulation/report/run_report.hpp>
#include <dynamy/stages/contact_look.hpp>
#include <memory>

namespace dynamy {

class GapWatch {
 public:
  /// Results go to report.gaps; `model` is built, and both outlive the watch.
  GapWatch(Model& model, RunReport& report);
  /// `initial`: view of the initial state, where bodies may overlap.
  void start(const StepView& initial);
  /// Extrapolates overlaps to the end of the step, or looks at rows in a step in time.
  void step(const StepView& view);
  /// Evaluates joints at the end of the step, if something is held there.
  void sample(const StepView& view);
  void archive(Archive& a) { a(looks_), a(joints_); }

 private:
  void rows(const StepView& view);
  void overlaps(const State& x);
  void positions(const State& x);
  MechanicalSystem& ends();
  Model& model_;
  RunReport& report_;
  /// System evaluated at the ends of steps, where schemes hold positions; created at its first use.
  std::unique_ptr<MechanicalSystem> ends_;
  ContactLook look_;     // at the ends of steps
  RowInstants rows_;     // of the record
  State at_;             // within a step
  long looks_ = 0;       // evaluations of gaps at ends of steps
  bool joints_ = false;  // something is held by joints
};

}  // namespace dynamy
