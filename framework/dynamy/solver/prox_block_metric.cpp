#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/lcp/law_probe.hpp>
#include <dynamy/solver/prox_block_metric.hpp>

namespace dynamy {

void ProxBlockMetric::prepare(const InclusionProblem& p) {
  discs_.clear();
  first_.assign(1, 0);
  for (int i = 0; i < p.size(); ++i) {
    const SetValuedForceLaw& law = p.law(i);
    const int dim = p.dim(i);
    const LawInput in = p.input(i);
    const ConstBlock G(p.G->diagonalBlock(i), dim, dim);
    for (int row = law.unilateral() ? 1 : 0; row < dim; row = law.groupEnd(row, dim)) {
      if (law.groupEnd(row, dim) != row + 2) continue;
      Disc disc{.row = row, .coupled = law.unilateral(), .R = {}, .set = {}};
      disc.radius = LawProbe(law, in).discRadius(row);
      // The symmetric part: any positive definite R solves the same law.
      const convex::Matrix<2> block =
          0.5 * (G.block<2, 2>(row, row) + G.block<2, 2>(row, row).transpose());
      const double scale = block.trace();
      if (!(disc.radius >= 0.0) || !(block.determinant() > 1e-12 * scale * scale)) continue;
      disc.R = options().factor * block.inverse();
      // Of an indefinite G, or at the edge of what numbers hold, there is no metric.
      if (!disc.R.allFinite() || Eigen::LLT<convex::Matrix<2>>(disc.R).info() != Eigen::Success)
        continue;
      disc.set = convex::inMetric(convex::Ellipsoid<2>{convex::Point<2>::Ones()}, disc.R);
      discs_.push_back(disc);
    }
    first_.push_back(static_cast<int>(discs_.size()));
  }
}

void ProxBlockMetric::sweep(const InclusionProblem& p, const double* r, double* Lambda) {
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i), first = p.row0(i);
    double xi[kMostRows], old[kMostRows];
    double* L = Lambda + first;
    p.G->row(i, Lambda, xi);
    for (int k = 0; k < dim; ++k) {
      xi[k] += p.c[static_cast<std::size_t>(first + k)];
      old[k] = L[k];
    }
    p.law(i).prox(p.input(i), r + first, xi, L);
    const double* G = p.G->diagonalBlock(i);
    for (int d = first_[static_cast<std::size_t>(i)]; d < first_[static_cast<std::size_t>(i) + 1];
         ++d) {
      // The friction uses the new normal force at once.
      const Disc& disc = discs_[static_cast<std::size_t>(d)];
      const int a = disc.row;
      convex::Point<2> v(xi[a], xi[a + 1]), z(old[a], old[a + 1]);
      if (disc.coupled)
        for (int k = 0; k < 2; ++k) v[k] += G[(a + k) * dim] * (L[0] - old[0]);
      z -= disc.R * v;
      const double radius = disc.radius * (disc.coupled ? L[0] : 1.0);
      const convex::Point<2> x = radius > 0.0 ? convex::prox(disc.set, z, radius)
                                              : convex::Point<2>(convex::Point<2>::Zero());
      L[a] = x[0], L[a + 1] = x[1];
    }
    for (int k = 0; k < dim; ++k) old[k] = L[k] - old[k];
    p.G->changed(i, old);
  }
}

void ProxBlockMetric::declare(Attributes& a) {
  declareCommon(a, "exact");
  a.about(
      "Projected Gauss-Seidel with a non-diagonal R: the friction disc of a contact is projected "
      "in "
      "the metric of its own block of G, Lambda_T <- prox^R(Lambda_T - R xi_T), R = G_TT^-1.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><ProxBlockMetric/></simulation>");
}

}  // namespace dynamy
