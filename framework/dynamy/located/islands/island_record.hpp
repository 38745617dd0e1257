/// IslandRecord: what islands with clocks of their own report of a step of the run: counts, works,
/// statuses and impacts.
#pragma once
#include <dynamy/located/islands/island_clock.hpp>

namespace dynamy {

class IslandRecord {
 public:
  /// A step of the run begins, unless it has begun.
  void begin(RunPatience* patience = nullptr);
  /// Adds the effort of a step that a clock tried, and spends its work.
  void effort(IslandClock& c);
  /// Adds the step of a clock, which has ended.
  void end(IslandClock& c);
  /// Books the works of the smooth part of a clock's step up to t.
  void pass(MechanicalSystem& s, IslandClock& c, double t);
  /// Writes counts and works into the report, and ends the step of the run.
  void report(StepReport& report);

  const std::vector<LocatedImpact>& impacts();
  /// Percussions and impulses of the steps that ended, one for each contact and step. [N s]
  const std::vector<Percussion>& percussions() const { return percussions_; }
  bool endedByMotion() const { return endedByMotion_; }
  const SolveReport& solved() const { return solved_; }

 private:
  void addPercussions(const ImpactProblem& p);
  RunPatience* patience_ = nullptr;  // of the run; borrowed until the step of the run ends
  bool reported_ = true;
  StepCounts counts_;
  StepWorks works_;
  SolveReport solved_;
  std::vector<LocatedImpact> impacts_;
  std::vector<Percussion> percussions_;
  bool endedByMotion_ = false;
};

}  // namespace dynamy
