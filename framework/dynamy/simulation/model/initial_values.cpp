#include <cmath>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
#include <functional>

namespace dynamy {
namespace {

/// Calls `use(name, system, isVelocity, index)` for every number of a state that has a name.
void eachNumber(const Model& model,
                const std::function<void(const std::string&, int, bool, int)>& use) {
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const std::string of = model.systems()[static_cast<std::size_t>(i)]->name() + ".";
    const SystemHandle& s = model.topology().system(i);
    const Description& d = model.description(i);
    for (const auto& [own, index] : d.coordinates) use(of + own, i, false, s.q0 + index);
    for (const auto& [own, index] : d.velocities) use(of + own, i, true, s.u0 + index);
  }
}

}  // namespace

double* numberOfState(const Model& model, const std::string& name, State& x) {
  double* found = nullptr;
  eachNumber(model, [&](const std::string& known, int, bool velocity, int at) {
    if (found == nullptr && known == name) found = velocity ? &x.u[at] : &x.q[at];
  });
  return found;
}

std::vector<std::string> namesOfState(const Model& model) {
  std::vector<std::string> out;
  eachNumber(model, [&](const std::string& name, int, bool, int) { out.push_back(name); });
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
