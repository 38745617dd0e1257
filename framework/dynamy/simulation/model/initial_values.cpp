#include <Eigen/Cholesky>
#include <cmath>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
#include <dynamy/system/body_carrier.hpp>
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

namespace {

/// Sets velocity k of body `i`, which system number `at` carries.
void setCarried(const Model& model, int at, int i, int k, const std::string& name, double value,
                State& x) {
  const PartialMechanicalSystem& system = *model.systems()[static_cast<std::size_t>(at)];
  const BodyCarrier& carrier = *system.abilities().carrier;
  const SystemHandle& s = model.topology().system(at);
  const Blocks own = carrier.carriedBody(i).blocks();
  const Eigen::VectorXd q = x.q.segment(s.q0, s.nq), u = x.u.segment(s.u0, s.nu);
  Eigen::VectorXd qOwn(own.nq), uOwn(own.nu), bias(own.nu);
  RowMatrix J(own.nu, s.nu), M(s.nu, s.nu);
  carrier.ownState(i, view(q), view(u), view(qOwn), view(uOwn));
  carrier.ownVelocities(i, view(q), view(u), {J.data(), own.nu, s.nu}, view(bias));
  system.M(x.t, view(q), {M.data(), s.nu, 1});
  const Eigen::VectorXd w = J.row(k).transpose(), change = M.ldlt().solve(w);
  const double along = w.dot(change);
  if (!(along > 1e-12 * J.squaredNorm() / M.diagonal().maxCoeff()))
    throw ModelError("the joints do not let \"" + name + "\" change",
                     "the coordinates and velocities that can be set are those of the joints, " +
                         unknownNameHint(name, namesOfState(model)));
  x.u.segment(s.u0, s.nu) += change * (value - uOwn[k]) / along;
}

/// The number of `name`, as "body.number", among those that a body names; −1: none of them.
int ownNumber(const std::string& name, const std::string& body,
              const std::vector<std::pair<std::string, int>>& numbers) {
  for (const auto& [own, k] : numbers)
    if (name == body + "." + own) return k;
  return -1;
}

}  // namespace

void setNumber(const Model& model, const std::string& name, double value, State& x) {
  if (numberOfState(model, name, x) != nullptr) return changeInitialValue(model, name, value, x);
  for (int at = 0; at < static_cast<int>(model.systems().size()); ++at) {
    const BodyCarrier* carrier = model.systems()[static_cast<std::size_t>(at)]->abilities().carrier;
    for (int i = 0; carrier != nullptr && i < carrier->carriedBodies(); ++i) {
      Description own;
      carrier->carriedBody(i).describe(own);
      const std::string& body = carrier->carriedBody(i).name();
      if (const int k = ownNumber(name, body, own.velocities); k >= 0)
        return setCarried(model, at, i, k, name, value, x);
      if (ownNumber(name, body, own.coordinates) >= 0)
        throw ModelError('"' + body + "\" is carried by joints, whose coordinates say where it is",
                         "set one of them, such as " + body +
                             ".joint.angle; or coordinates=\"absolute\" in <simulation>");
    }
  }
  throw ModelError("no coordinate or velocity named \"" + name + '"',
                   unknownNameHint(name, namesOfState(model)));
}

}  // namespace dynamy
