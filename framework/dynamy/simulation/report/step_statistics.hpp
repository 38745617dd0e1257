/// StepStatistics: sums up the reports of the accepted steps in a RunReport. A contact's status is
/// compared with that of the step before by its key: both lists are sorted and merged.
#pragma once
#include <dynamy/simulation/report/record_sink.hpp>
#include <dynamy/simulation/report/run_report.hpp>
#include <dynamy/simulation/report/step_impacts.hpp>

namespace dynamy {

class StepStatistics final : public Observer {
 public:
  explicit StepStatistics(RunReport& report) : report_(report) {}
  /// Reports impacts and switches to `sink` from now on.
  void tell(RecordSink& sink) { sink_ = &sink; }
  /// A system jumped at t [s].
  void jump(double t, int system) {
    ContactEvent e;
    e.t = t, e.jumped = system;
    if (sink_ != nullptr) sink_->event(e);
  }
  void step(const StepView& view) override;
  void archive(Archive& a) override;

 private:
  struct Seen {
    ContactKey key;
    Status status;
    bool impact;
    void archive(Archive& a) { a(key), a(status), a(impact); }
  };
  void stepped(const StepView& view);
  void gaps(const StepView& view);
  void statuses(const StepView& view);
  void switched(double t, const Seen& from, const Seen& to);
  RunReport& report_;
  RecordSink* sink_ = nullptr;
  StepImpacts impacts_;
  std::vector<Seen> before_, now_;
};

}  // namespace dynamy
