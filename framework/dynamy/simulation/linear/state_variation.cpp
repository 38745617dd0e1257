#include <fmt/format.h>

#include <dynamy/core/decompositions.hpp>
#include <dynamy/simulation/linear/state_variation.hpp>

namespace dynamy {

/// Columns: what each velocity of the system contributes to q̇.
Eigen::MatrixXd StateVariation::F(const State& x, int system) const {
  const SystemHandle& s = model_.topology().system(system);
  const PartialMechanicalSystem& of = *model_.systems()[static_cast<std::size_t>(system)];
  Eigen::MatrixXd out(s.nq, s.nu);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(s.nu), still(s.nq), moving(s.nq);
  of.qdot(x.t, slice(x.q, s.q0, s.nq), view(std::as_const(v)), view(still));
  for (Eigen::Index k = 0; k < s.nu; ++k) {
    v.setZero(), v[k] = 1.0;
    of.qdot(x.t, slice(x.q, s.q0, s.nq), view(std::as_const(v)), view(moving));
    out.col(k) = moving - still;
  }
  return out;
}

State StateVariation::added(const State& x, const Eigen::VectorXd& z) const {
  State out = x;
  const Eigen::Index nu = size() / 2;
  out.u += z.tail(nu);
  for (int i = 0; i < static_cast<int>(model_.systems().size()); ++i) {
    const SystemHandle& s = model_.topology().system(i);
    if (s.nq == 0) continue;
    out.q.segment(s.q0, s.nq) += F(x, i) * z.segment(s.u0, s.nu);
    model_.systems()[static_cast<std::size_t>(i)]->normalise(slice(out.q, s.q0, s.nq));
  }
  return out;
}

Eigen::VectorXd StateVariation::between(const State& x1, const State& x0) const {
  const Eigen::Index nu = size() / 2;
  Eigen::VectorXd z(size());
  z.tail(nu) = x1.u - x0.u;
  for (int i = 0; i < static_cast<int>(model_.systems().size()); ++i) {
    const SystemHandle& s = model_.topology().system(i);
    if (s.nu == 0) continue;
    PivotedQr own;
    own.compute(F(x0, i));
    z.segment(s.u0, s.nu) =
        own.solve(Eigen::MatrixXd(x1.q.segment(s.q0, s.nq) - x0.q.segment(s.q0, s.nq)));
  }
  return z;
}

std::vector<std::string> StateVariation::names() const {
  const auto nu = static_cast<std::size_t>(size() / 2);
  std::vector<std::string> out(2 * nu);
  for (int i = 0; i < static_cast<int>(model_.systems().size()); ++i) {
    const SystemHandle& s = model_.topology().system(i);
    const Description& d = model_.description(i);
    const PartialMechanicalSystem& system = *model_.systems()[static_cast<std::size_t>(i)];
    const std::string of = (system.name().empty() ? system.type() : system.name()) + ".";
    for (int k = 0; k < s.nu; ++k) {
      const auto at = static_cast<std::size_t>(s.u0 + k);
      out[nu + at] = of + fmt::format("u{}", k);
      for (const auto& [name, index] : d.velocities)
        if (index == k) out[nu + at] = of + name;
      out[at] = "∫" + out[nu + at];
      if (s.nq == s.nu)
        for (const auto& [name, index] : d.coordinates)
          if (index == k) out[at] = of + name;
    }
  }
  return out;
}

std::vector<std::pair<std::string, double>> coordinatesOf(const Model& model, const State& x,
                                                          bool velocities) {
  std::vector<std::pair<std::string, double>> out;
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const SystemHandle& s = model.topology().system(i);
    const Description& d = model.description(i);
    const std::string of = model.systems()[static_cast<std::size_t>(i)]->name() + ".";
    for (const auto& [name, index] : d.coordinates) out.emplace_back(of + name, x.q[s.q0 + index]);
    for (const auto& [name, index] : d.velocities)
      if (velocities) out.emplace_back(of + name, x.u[s.u0 + index]);
  }
  return out;
}

}  // namespace dynamy
