#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/run/checkpoints.hpp>
#include <utility>

namespace dynamy {
namespace {

double secondsOf(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

void Checkpoints::receiver(double seconds, double share, Receiver receive) {
  every_ = seconds, share_ = share, receive_ = std::move(receive);
}

bool Checkpoints::due(Clock::time_point now) const {
  const double since = secondsOf(now - last_);
  return receive_ && every_ > 0.0 && since >= every_ && cost_ <= share_ * since;
}

void Checkpoints::handOn(const std::function<void()>& write) {
  const auto begin = Clock::now();
  write();
  receive_(bytes_);
  last_ = Clock::now(), cost_ = secondsOf(last_ - begin);
}

void archiveState(Archive& a, State& x) {
  a.section("state");
  a(x.t), a(x.q), a(x.u), a(x.memory), a(x.scheme);
  a(x.impulses.key), a(x.impulses.first), a(x.impulses.Lambda), a(x.impulses.dt);
  a(x.impulses.corrected);
}

std::string stateFault(const State& x, std::size_t contacts) {
  if (!(x.t >= 0.0) || !std::isfinite(x.t)) return "its time is " + numberText(x.t) + " s";
  if (!x.q.allFinite() || !x.u.allFinite()) return "a position or a velocity is not finite";
  const RememberedImpulses& m = x.impulses;
  if (m.key.empty() && m.Lambda.empty() && m.first.size() < 2) return {};
  const bool sorted = std::is_sorted(m.first.begin(), m.first.end());
  if (m.first.size() != m.key.size() + 1 || !sorted || m.first.front() != 0 ||
      static_cast<std::size_t>(m.first.back()) != m.Lambda.size())
    return "its percussions are not those of its contacts";
  for (const ContactKey key : m.key)
    if (key.value >> 40 >= contacts) return "a contact is of an element that is not";
  return {};
}

namespace {

std::string memoryFault(const Model& model, const State& x) {
  const auto faultOf = [&](const auto& elements) -> std::string {
    for (const auto& element : elements) {
      const MemoryHandle own = model.topology().memories().of(*element);
      if (own.size == 0) continue;
      const std::string fault =
          element->memoryFault(ConstVec(x.memory.data() + own.first, own.size));
      if (!fault.empty()) return element->type() + " \"" + element->name() + "\": " + fault;
    }
    return {};
  };
  const std::string fault = faultOf(model.forces());
  return fault.empty() ? faultOf(model.contacts()) : fault;
}

}  // namespace

void refuseForeign(const Model& model, const Archive& a, const State& x) {
  const Topology& t = model.topology();
  const auto memory = static_cast<Eigen::Index>(t.memories().start().size());
  if (x.q.size() != t.nq() || x.u.size() != t.nu() || x.memory.size() != memory || !a.atEnd())
    throw ModelError("the checkpoint belongs to another model");
  std::string fault = stateFault(x, model.contacts().size());
  if (fault.empty()) fault = memoryFault(model, x);
  if (!fault.empty()) throw ModelError("the checkpoint cannot be of this run: " + fault);
}

}  // namespace dynamy
