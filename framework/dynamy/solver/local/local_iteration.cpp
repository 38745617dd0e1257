#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/local/local_iteration.hpp>

namespace dynamy {
namespace {

constexpr int kNewtonSteps = 20, kNewtonHalvings = 4;
/// |F| below this part of |Λ| is rounding.
constexpr double kLocalNoise = 1e-15;

using SmallVec = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows, 1>;
using SmallMat =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostRows, kMostRows>;

struct Contact {
  const SetValuedForceLaw& law;
  const LawInput& in;
  Eigen::Map<const RowMatrix> D;
  Eigen::Map<const Eigen::VectorXd> b;
  SmallVec r;       ///< as given
  SmallVec common;  ///< the smallest r for all rows, as derivatives require

  SmallVec xi(const SmallVec& Lambda) const {
    SmallVec out = b;
    out.noalias() += D * Lambda;
    return out;
  }
  SmallVec stepped(const SmallVec& Lambda, const SmallVec& steps) const {
    SmallVec out = Lambda;
    law.prox(in, steps.data(), xi(Lambda).data(), out.data());
    return out;
  }
  SmallVec F(const SmallVec& Lambda) const { return Lambda - stepped(Lambda, common); }
};

}  // namespace

bool iterateContact(const SetValuedForceLaw& law, const LawInput& in, const double* D,
                    const double* b, const double* r, double* Lambda) {
  const int n = in.dim;
  assert(n <= kMostRows);
  const double rho = *std::min_element(r, r + n);
  const Contact x{law,
                  in,
                  {D, n, n},
                  {b, n},
                  Eigen::Map<const Eigen::VectorXd>(r, n),
                  SmallVec::Constant(n, rho)};
  Eigen::Map<Eigen::VectorXd> out(Lambda, n);
  SmallVec L = x.stepped(out, x.r), F = x.F(L);
  SmallMat A(n, n), B(n, n);
  double size = F.norm();
  for (int step = 0; step < kNewtonSteps && size > kLocalNoise * L.norm(); ++step) {
    if (!law.proxDerivative(in, rho, x.xi(L).data(), L.data(), A.data(), B.data())) break;
    A.noalias() += B * x.D;
    const SmallVec delta = -A.partialPivLu().solve(F);
    double t = 1.0, reached = size;
    SmallVec trial;
    for (int h = 0; h <= kNewtonHalvings; ++h, t *= 0.5) {
      trial = L + t * delta;
      const SmallVec there = x.F(trial);
      reached = there.norm();
      if (reached < size) {
        F = there;
        break;
      }
    }
    if (!(reached < size)) break;
    L = trial, size = reached;
  }
  if (!L.allFinite()) return false;
  // Newton's Λ may lie outside of C by rounding.
  out = x.stepped(L, x.common);
  return size <= kLocalNoise * L.norm();
}

}  // namespace dynamy
