#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/model/signal_binding.hpp>
#include <map>
#include <set>

namespace dynamy {
namespace {

using Request = ReadSignals::Request;

Diagnostic fault(const Request& r, std::string text, std::string hint) {
  Diagnostic d;
  d.place = r.place;
  d.element =
      r.element->type() + (r.element->name().empty() ? "" : " name=\"" + r.element->name() + '"');
  d.text = std::move(text), d.hint = std::move(hint);
  return d;
}

Diagnostic unknown(const Model& model, const Request& r) {
  std::vector<std::string> known;
  for (const NamedSignal& s : model.signals()) known.push_back(s.name);
  return fault(r, "no signal named \"" + r.name + '"', unknownNameHint(r.name, known));
}

/// Why formulas cannot read a signal; empty: they can.
std::string hindrance(const NamedSignal& s) {
  if (s.contact >= 0 && !s.signal.ofState)
    return "the signal \"" + s.name +
           "\" belongs to a contact: its forces and statuses follow from all forces, so no force "
           "can follow from them";
  return {};
}

int numberOf(const Model& model, const NamedSignal& s) {
  return static_cast<int>(&s - model.signals().data());
}

ReadSignals::Source sourceOf(const Model& model, const NamedSignal& s) {
  ReadSignals::Source out;
  out.signal = numberOf(model, s), out.value = s.signal.value;
  out.system = s.system;
  out.memory = {s.memory0, s.memory};
  return out;
}

/// Gives each source the systems that it follows from, through other elements as well.
void findSystems(const Model& model, const std::vector<const NamedSignal*>& signals,
                 std::vector<ReadSignals::Source>& sources) {
  const std::vector<Request>& requests = model.topology().signals().requests();
  std::map<const Element*, std::set<int>> of;
  for (const Connection& c : model.topology().connections())
    of[c.element].insert(c.systems.begin(), c.systems.end());
  const auto behind = [&](const NamedSignal& s) {
    return s.system >= 0 ? std::set<int>{s.system} : of[s.element];
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      std::set<int>& own = of[requests[i].element];
      const std::size_t before = own.size();
      own.merge(behind(*signals[i]));
      more = more || own.size() > before;
    }
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::set<int> systems = behind(*signals[i]);
    sources[i].systems.assign(systems.begin(), systems.end());
  }
}

void refuseLoops(const Model& model) {
  const State x = model.initialState();
  Kinematics k;
  k.evaluate(model.topology(), x.t, view(x.q), view(x.u), view(x.memory));
  const std::vector<int> loop = model.topology().signals().loop(k);
  if (loop.empty()) return;
  const auto name = [&](int i) { return model.signals()[static_cast<std::size_t>(i)].name; };
  std::string text = "algebraic loop: a signal would follow from itself at the same instant: ";
  for (const int i : loop) text += name(i) + " ← ";
  text += name(loop.front());
  for (const Request& r : model.topology().signals().requests())
    if (r.name == name(loop.front()))
      throw ModelError(fault(r, std::move(text),
                             "an <Integrator>, a <Sample> or a <Delay> in the loop has a state of "
                             "its own"));
}

}  // namespace

void bindSignals(Model& model) {
  Topology& topology = model.topology();
  const std::vector<Request>& requests = topology.signals().requests();
  if (requests.empty()) return;
  Diagnostics faults;
  std::vector<ReadSignals::Source> sources;
  std::vector<const NamedSignal*> found;
  for (const Request& r : requests) {
    const NamedSignal* s = model.signal(r.name);
    if (s == nullptr) {
      faults.add(unknown(model, r));
    } else if (std::string why = hindrance(*s); !why.empty()) {
      faults.add(
          fault(r, std::move(why), "read positions and velocities, or sample the motion before"));
    } else {
      sources.push_back(sourceOf(model, *s)), found.push_back(s);
    }
  }
  faults.throwIfAny();
  findSystems(model, found, sources);
  topology.bindSignals(std::move(sources));
  refuseLoops(model);
}

}  // namespace dynamy
