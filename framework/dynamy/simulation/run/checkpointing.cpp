// Simulation: checkpoints, from which a run can continue.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <utility>

namespace dynamy {
namespace {

double secondsOf(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

void archiveState(Archive& a, State& x) {
  a.section("state");
  a(x.t), a(x.q), a(x.u), a(x.memory), a(x.scheme);
  a(x.impulses.key), a(x.impulses.first), a(x.impulses.Lambda), a(x.impulses.dt);
  a(x.impulses.corrected);
}

}  // namespace

void Simulation::onCheckpoint(double every, double share,
                              std::function<void(const std::string&)> call) {
  saveEvery_ = every, saveShare_ = share, save_ = std::move(call);
}

void Simulation::archive(Archive& a) {
  a.section("dynamy checkpoint 8");  // the number counts changes of the layout
  archiveState(a, x_);
  a(*loop_), a(report_), searches_.archive(a);
  forAll([&a](Observer& o) { o.archive(a); });
}

void Simulation::resume(const std::string& checkpoint) {
  const Eigen::Index nq = x_.q.size(), nu = x_.u.size(), memory = x_.memory.size();
  Archive a(checkpoint);
  archive(a);
  if (x_.q.size() != nq || x_.u.size() != nu || x_.memory.size() != memory || !a.atEnd())
    throw ModelError("the checkpoint belongs to another model");
  if (const std::string fault = stateFault(); !fault.empty())
    throw ModelError("the checkpoint cannot be of this run: " + fault);
  before_ = x_;
  checkpoint_ = checkpoint;
  resumed_ = true;
}

/// Why x_ cannot be a state of a run; empty: it can. Indices are checked here, once, and never
/// within a step.
std::string Simulation::stateFault() const {
  if (!(x_.t >= 0.0) || !std::isfinite(x_.t)) return "its time is " + numberText(x_.t) + " s";
  if (!x_.q.allFinite() || !x_.u.allFinite()) return "a position or a velocity is not finite";
  const RememberedImpulses& m = x_.impulses;
  if (m.key.empty() && m.Lambda.empty() && m.first.size() < 2) return {};
  const bool sorted = std::is_sorted(m.first.begin(), m.first.end());
  if (m.first.size() != m.key.size() + 1 || !sorted || m.first.front() != 0 ||
      static_cast<std::size_t>(m.first.back()) != m.Lambda.size())
    return "its percussions are not those of its contacts";
  for (const ContactKey key : m.key)
    if (key.value >> 40 >= model_.contacts().size())
      return "a contact is of an element that is not";
  return {};
}

void Simulation::save() {
  const auto begin = Clock::now();
  keep();
  save_(checkpoint_);
  lastSave_ = Clock::now(), saveCost_ = secondsOf(lastSave_ - begin);
}

void Simulation::keep() {
  Archive a;
  archive(a);
  checkpoint_ = a.bytes();
}

/// Ends the run within a step. Parts of the step that observers have seen are kept; a step that was
/// only tried is undone. In both cases the recorder adds no last row.
void Simulation::stopWithin() {
  report_.ended = RunReport::Ended::stopped;
  report_.reason =
      "t = " + numberText(x_.t) + " s: stopped within a step" +
      (whole_ ? ", which was taken back" : " of many parts; a checkpoint is of an earlier moment");
  if (whole_) keep();
  stepReport_ = {};
  end();
}

/// Ends the run when memory runs out. The step that needed the memory is undone if no observer has
/// seen it.
void Simulation::outOfMemory() noexcept {
  report_.ended = RunReport::Ended::failed, report_.cause = RunReport::Cause::memory;
  spare_ = {};
  try {
    if (whole_ && attempted_) std::swap(x_, before_);
    attempted_ = false;
    report_.t = x_.t;
    report_.reason = "t = " + numberText(x_.t) + " s: out of memory";
    if (whole_) keep();
    end();
  } catch (...) {  // checkpoint() then holds an earlier state
  }
}

}  // namespace dynamy
