#include <algorithm>
#include <cmath>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <dynamy/simulation/orbit/orbit_multipliers.hpp>

namespace dynamy {

std::vector<Eigen::Index> activeChanges(const Return& r, const ReturnDerivative& d) {
  constexpr double kIgnorable = 1e-7;  // rounding of a column of DP
  const Eigen::Index n = d.P.rows();
  std::vector<Eigen::Index> out;
  for (Eigen::Index i = 0; i < n; ++i) {
    double off = std::abs(d.period[i]) * r.range[i] / r.period;
    for (Eigen::Index k = 0; k < n; ++k)
      off = std::max(off, std::abs(d.P(k, i) - (k == i ? 1.0 : 0.0)) * r.range[i] / r.range[k]);
    if (2 * i >= n || off > kIgnorable) out.push_back(i);
  }
  return out;
}

Eigen::MatrixXd scaledMap(const Eigen::MatrixXd& P, const std::vector<Eigen::Index>& active,
                          const Eigen::VectorXd& scale) {
  const auto n = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd out(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index a = active[static_cast<std::size_t>(i)];
      const Eigen::Index b = active[static_cast<std::size_t>(k)];
      out(i, k) = P(a, b) * scale[b] / scale[a];
    }
  return out;
}

Eigen::VectorXcd multipliersOf(const Eigen::MatrixXd& scaled, double noise) {
  Eigen::MatrixXcd vectors;
  Eigen::VectorXcd out;
  nonzeroEigenvalues(scaled, noise, out, vectors);
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
    return std::abs(a) > std::abs(b) * (1.0 + 1e-9);
  });
  return out;
}

Eigen::VectorXcd ofOrbit(const Eigen::VectorXcd& ofReturn, int halves) {
  return halves > 1 ? Eigen::VectorXcd(ofReturn.cwiseProduct(ofReturn)) : ofReturn;
}

int heldByJoints(Model& model, const State& x) {
  MechanicalSystem s = model.mechanicalSystem();
  s.evaluate(x);
  int out = 0;
  const ContactSet& c = s.slot(0).contacts;
  for (int i = 0; i < c.size(); ++i)
    for (int r = 0; r < c.dim(i); ++r) {
      const RowKind kind = c.law[static_cast<std::size_t>(i)]->rowKind(r);
      out += kind == RowKind::joint ? 2 : kind == RowKind::rate ? 1 : 0;
    }
  return out;
}

}  // namespace dynamy
