/// MotionSequence: what happened in a run, step by step: lengths, switches, statuses after them and
/// impacts. Two runs of nearly the same motion can be subtracted if theirs are the same.
#pragma once
#include <dynamy/located/switching/contact_gaps.hpp>
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/run/planned_steps.hpp>
#include <string>

namespace dynamy {

struct MotionSequence {
  struct Step {
    PlannedStep step;
    double t = 0.0;  ///< its end [s]
    int switches = 0;
    bool inTime = false;               ///< switches in it were not located
    std::vector<HeldStatus> statuses;  ///< after a switch
    std::vector<ContactKey> impacts;
  };
  std::vector<Step> steps;

  void add(const StepView& view, PlannedStep::End end);
  std::vector<PlannedStep> plan() const;
  /// Where another run of nearly the same motion begins to differ.
  struct Difference {
    bool any = false;
    double t = 0.0;                   ///< [s]
    ContactKey contact = kNoContact;  ///< that switches or impacts in one of them only
  };
  Difference from(const MotionSequence& other) const;
};

}  // namespace dynamy
