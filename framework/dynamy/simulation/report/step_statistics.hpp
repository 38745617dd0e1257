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
  /// Something happened to a system at t [s].
  void event(double t, ContactEvent::Of of, int system) {
    ContactEvent e;
    e.t = t, e.of = of, e.system = system;
    if (sink_ != nullptr) sink_->event(e);
  }
  /// Contacts, ascending, that keep their status from now on because their bodies sleep, or no longer.
  void rest(const std::vector<ContactKey>& contacts) { move(contacts, before_, resting_); }
  void wake(const std::vector<ContactKey>& contacts) { move(contacts, resting_, before_); }
  void step(const StepView& view) override;
  void archive(Archive& a) override;

 private:
  struct Seen {
    ContactKey key;
    Status status;
    bool impact;
    void archive(Archive& a) { a(key), a(status), a(impact); }
  };
  static void move(const std::vector<ContactKey>& contacts, std::vector<Seen>& from,
                   std::vector<Seen>& to);
  void stepped(const StepView& view);
  void gaps(const StepView& view);
  void statuses(const StepView& view);
  void switched(double t, const Seen& from, const Seen& to);
  RunReport& report_;
  RecordSink* sink_ = nullptr;
  StepImpacts impacts_;
  std::vector<Seen> before_, now_, resting_;
};

}  // namespace dynamy
