#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/lcp/law_probe.hpp>
#include <dynamy/solver/lcp/lcp_form.hpp>
#include <numbers>

namespace dynamy {
namespace {

RowMatrix denseG(const InclusionProblem& p) {
  const int n = p.rows();
  if (p.G->dense()) return ConstBlock(p.G->dense(), n, n);
  RowMatrix G = RowMatrix::Zero(n, n);
  const BlockRows& rows = p.G->blockRows();
  for (int i = 0; i < p.size(); ++i)
    for (int k = rows.first[static_cast<std::size_t>(i)];
         k < rows.first[static_cast<std::size_t>(i) + 1]; ++k) {
      const int j = rows.column[static_cast<std::size_t>(k)];
      G.block(p.row0(i), p.row0(j), p.dim(i), p.dim(j)) = ConstBlock(
          rows.value.data() + rows.value0[static_cast<std::size_t>(k)], p.dim(i), p.dim(j));
    }
  return G;
}

}  // namespace

void LcpForm::scalar(int row, double lower, double upper) {
  if (std::isinf(lower) && std::isinf(upper)) {
    free_.push_back(row);
    return;
  }
  const bool fromAbove = std::isinf(lower);
  Lambda0_[row] = fromAbove ? upper : lower;
  if (!(upper > lower)) return;  // a given force
  Variable z{.row = row};
  z.v[0] = fromAbove ? -1.0 : 1.0;
  if (!std::isinf(lower) && !std::isinf(upper)) {
    z.bound = static_cast<int>(bounds_.size());
    bounds_.push_back({upper - lower, -1});
  }
  variables_.push_back(z);
}

void LcpForm::friction(const InclusionProblem& p, int i, int first, int end, int normal,
                       int facets) {
  // Vertices: the extreme points in `facets` directions, or ± along the axes; one row has two.
  const int k = end - first, corners = k == 1 ? 2 : (k == 2 ? facets : 2 * k);
  const LawInput in = p.input(i);
  const LawProbe probe(p.law(i), in);
  const auto vertex = [&](int j, double* v) {
    double d[kMostRows] = {};
    if (k == 2) {
      const double angle = 2.0 * std::numbers::pi * j / corners;
      d[0] = std::cos(angle), d[1] = std::sin(angle);
    } else {
      d[j / 2] = j % 2 == 0 ? 1.0 : -1.0;
    }
    return probe.extreme(first, k, d, v);
  };
  double centre[kMostRows] = {};
  double v[kMostRows];
  if (normal < 0)
    for (int j = 0; j < corners; ++j) {
      if (!vertex(j, v)) {  // unbounded: free rows, as joints
        for (int r = first; r < end; ++r) free_.push_back(p.row0(i) + r);
        return;
      }
      for (int r = 0; r < k; ++r) centre[r] += v[r] / corners;
    }
  for (int r = 0; r < k; ++r) Lambda0_[p.row0(i) + first + r] = centre[r];
  if (k > 1) exact_ = false;
  const int bound = static_cast<int>(bounds_.size());
  bounds_.push_back({normal < 0 ? 1.0 : 0.0, normal});
  for (int j = 0; j < corners; ++j) {
    Variable beta{.row = p.row0(i) + first, .count = k, .bound = bound};
    vertex(j, v);
    for (int r = 0; r < k; ++r) beta.v[r] = v[r] - centre[r];
    variables_.push_back(beta);
  }
}

void LcpForm::describe(const InclusionProblem& p, int facets) {
  exact_ = true;
  variables_.clear(), bounds_.clear(), free_.clear();
  Lambda0_.setZero(p.rows());
  for (int i = 0; i < p.size(); ++i) {
    const SetValuedForceLaw& law = p.law(i);
    const int dim = p.dim(i);
    int row = 0, normal = -1;
    if (law.unilateral()) {
      normal = static_cast<int>(variables_.size());
      Variable N{.row = p.row0(i)};
      N.v[0] = 1.0;
      variables_.push_back(N);
      row = 1;
    }
    while (row < dim) {
      const int end = law.groupEnd(row, dim);
      if (normal < 0 && end == row + 1) {
        double lower, upper;
        const LawInput in = p.input(i);
        LawProbe(law, in).interval(row, lower, upper);
        scalar(p.row0(i) + row, lower, upper);
      } else {
        friction(p, i, row, end, normal, facets);
      }
      row = end;
    }
  }
}

void LcpForm::eliminate(const InclusionProblem& p) {
  const auto nz = static_cast<Eigen::Index>(variables_.size());
  G_ = denseG(p);
  GP_.setZero(p.rows(), nz);
  for (Eigen::Index k = 0; k < nz; ++k) {
    const Variable& z = variables_[static_cast<std::size_t>(k)];
    for (int r = 0; r < z.count; ++r) GP_.col(k) += z.v[r] * G_.col(z.row + r);
  }
  c0_ = ConstVec(p.c.data(), p.rows()) + G_ * Lambda0_;
  free0_.resize(0);
  if (free_.empty()) return;
  // ξ_F = 0: Λ_F = −G_FF⁺ (c_F + (GP)_F z), the smallest solution if joints are redundant.
  joints_.compute(G_(free_, free_));
  joints_.solve(c0_(free_), free0_);
  free0_ = -free0_;
  freeZ_ = -joints_.solve(GP_(free_, Eigen::all));
  const RowMatrix columns = G_(Eigen::all, free_);
  c0_ += columns * free0_;
  GP_ += columns * freeZ_;
}

double LcpForm::along(const Variable& a, const double* rows) const {
  double sum = 0.0;
  for (int r = 0; r < a.count; ++r) sum += a.v[r] * rows[a.row + r];
  return sum;
}

void LcpForm::assemble() {
  const auto nz = static_cast<Eigen::Index>(variables_.size());
  const auto n = nz + static_cast<Eigen::Index>(bounds_.size());
  M_.setZero(n, n), q_.setZero(n);
  for (Eigen::Index k = 0; k < nz; ++k) {
    const Variable& z = variables_[static_cast<std::size_t>(k)];
    q_[k] = along(z, c0_.data());
    for (int r = 0; r < z.count; ++r) M_.row(k).head(nz) += z.v[r] * GP_.row(z.row + r);
    if (z.bound >= 0) M_(k, nz + z.bound) = 1.0, M_(nz + z.bound, k) = -1.0;
  }
  for (std::size_t j = 0; j < bounds_.size(); ++j) {
    const Eigen::Index row = nz + static_cast<Eigen::Index>(j);
    q_[row] = bounds_[j].constant;
    if (bounds_[j].normal >= 0) M_(row, bounds_[j].normal) = 1.0;
  }
}

void LcpForm::pose(const InclusionProblem& p, int facets) {
  describe(p, facets);
  eliminate(p);
  assemble();
}

void LcpForm::forces(const double* z, Vec Lambda) const {
  Lambda = Lambda0_;
  for (std::size_t k = 0; k < variables_.size(); ++k)
    for (int r = 0; r < variables_[k].count; ++r)
      Lambda[variables_[k].row + r] += variables_[k].v[r] * z[k];
  for (std::size_t f = 0; f < free_.size(); ++f) {
    double value = free0_[static_cast<Eigen::Index>(f)];
    for (std::size_t k = 0; k < variables_.size(); ++k)
      value += freeZ_(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)) * z[k];
    Lambda[free_[f]] = value;
  }
}

}  // namespace dynamy
