#include <cmath>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
#include <utility>

namespace dynamy {
std::vector<NamedNumber> numbersOfState(const Model& model) {
  std::vector<NamedNumber> out;
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const std::string& name = model.systems()[static_cast<std::size_t>(i)]->name();
    const std::string of = name.empty() ? "" : name + ".";  // of a tree: its bodies have names
    const SystemHandle& s = model.topology().system(i);
    const Description& d = model.description(i);
    for (const auto& [own, index] : d.coordinates) {
      out.push_back({of + own, false, s.q0 + index});
      if (s.nq != s.nu) continue;
      for (const auto& [rate, k] : d.velocities)
        if (k == index) out.back().rate = of + rate;
    }
    for (const auto& [own, index] : d.velocities) out.push_back({of + own, true, s.u0 + index});
  }
  return out;
}

double* numberOfState(const Model& model, const std::string& name, State& x) {
  for (const NamedNumber& n : numbersOfState(model))
    if (n.name == name) return n.velocity ? &x.u[n.index] : &x.q[n.index];
  return nullptr;
}

std::vector<std::string> namesOfState(const Model& model) {
  std::vector<std::string> out;
  for (NamedNumber& n : numbersOfState(model)) out.push_back(std::move(n.name));
  return out;
}

void changeInitialValue(const Model& model, const std::string& name, double value, State& x) {
  double* number = numberOfState(model, name, x);
  if (number == nullptr)
    throw ModelError("no coordinate or velocity named \"" + name + '"',
                     unknownNameHint(name, namesOfState(model)));
  *number = value;
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const SystemHandle& s = model.topology().system(i);
    if (s.nq == 0) continue;
    const Eigen::VectorXd before = x.q.segment(s.q0, s.nq);
    model.systems()[static_cast<std::size_t>(i)]->normalise(slice(x.q, s.q0, s.nq));
    // Numbers of unit length are rounded; a number that is not free moves by a part of its change.
    if ((x.q.segment(s.q0, s.nq) - before).cwiseAbs().maxCoeff() > 1e-12)
      throw ModelError('"' + name + "\" is one of several numbers that hold a rotation together",
                       "write the initial attitude with a parameter, and vary the parameter");
  }
}

}  // namespace dynamy
