#include <dynamy/stages/work_meter.hpp>

namespace dynamy {

StepWorks WorkMeter::of(const MechanicalSystem& s, const Eigen::VectorXd& uA,
                        const Eigen::VectorXd& uE, double dt, ConstVec Lambda) {
  StepWorks w;
  w.given = true;
  const Evaluation& e = s.slot(0);
  w.nonPotential = 0.5 * dt * (e.hNonPotential.dot(uA) + e.hNonPotential.dot(uE));
  const ContactSet& c = e.contacts;
  const std::vector<double>& gammaA = s.problem().gammaA;
  const auto rows = static_cast<std::size_t>(c.rows());
  if (rows == 0 || Lambda.size() != c.rows() || gammaA.size() != rows) return w;
  gammaE_.resize(rows);
  c.gamma(view(uE), {gammaE_.data(), static_cast<Eigen::Index>(rows)});
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int r = 0; r < c.dim(i); ++r) {
      const int k = c.row0[at] + r;
      const auto row = static_cast<std::size_t>(k);
      w.book(c.law[at]->rowKind(r), Lambda[k], 0.5 * (gammaA[row] + gammaE_[row]), c.chi[row]);
    }
  }
  return w;
}

}  // namespace dynamy
