/// EventInstants: instants of events of a run as values: the n-th impact of a contact, its n-th
/// change to a status, or the n-th pass of a signal through a value.
///
/// An instant is where a step ends, or, of a signal, the root on the path of a step. Both are smooth
/// in p for runs that follow another (theory 53.2).
#pragma once
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <map>
#include <string>
#include <vector>

namespace dynamy {

struct WantedInstant {
  enum class What : std::uint8_t {
    impact,  ///< of a contact
    status,  ///< a contact changes to `status`
    rise,    ///< a signal passes `value` upwards
    fall     ///< and downwards
  };
  std::string text;  ///< as it was written: "floor=impact#2", "ball.y=0.5-"
  std::string of;    ///< name of a contact or of a signal
  What what = What::impact;
  Status status = Status::open;
  double value = 0.0;  ///< [unit of the signal]
  int count = 1;       ///< which of them, from 1
};

class EventInstants final : public Observer {
 public:
  /// Throws ModelError for unknown signals. `wanted` outlives this.
  EventInstants(const Model& model, const std::vector<WantedInstant>& wanted);
  void step(const StepView& view) override;
  /// Instants [s]; NaN where there were fewer events.
  const std::vector<double>& instants() const { return instants_; }
  /// How many of the events there were.
  const std::vector<int>& counts() const { return counts_; }

 private:
  void found(std::size_t i, double t);
  void impacts(const StepView& view, std::size_t i);
  void statuses(const StepView& view, std::size_t i);
  void passes(const StepView& view, std::size_t i);
  double side(const StepView& view, double theta, std::size_t i);
  bool isNamed(const Model& model, ContactKey key, std::size_t i) const;
  const std::vector<WantedInstant>& wanted_;
  SignalSampler sampler_;
  std::vector<std::size_t> signal_;  ///< index of the signal of each wanted instant
  std::vector<double> instants_;
  std::vector<int> counts_;
  std::map<std::uint64_t, Status> status_;  ///< of all contacts, after the last step
  bool known_ = false;                      ///< status_ holds what was before this step
};

}  // namespace dynamy
