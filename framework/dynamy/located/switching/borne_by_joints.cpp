#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/located/switching/borne_by_joints.hpp>

namespace dynamy {
namespace {

/// Of wᵀM⁻¹w, as in CondensedContacts: a lever of 1e-4 of the body's size.
constexpr double kHeld = 1e-8;
/// Rows of joints that depend on each other up to this are one.
constexpr double kRedundant = 1e-11;

void addRow(const ContactSet& c, int i, int r, Eigen::Ref<Eigen::VectorXd> w) {
  const auto at = static_cast<std::size_t>(i);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    for (int j = 0; j < s.nu; ++j) w[s.u0 + j] += c.W[static_cast<std::size_t>(s.w + r * s.nu + j)];
  }
}

bool isJoint(const ContactSet& c, int i, int r) {
  const SetValuedForceLaw& law = *c.law[static_cast<std::size_t>(i)];
  return !law.unilateral() && law.rowKind(r) == RowKind::joint;
}

}  // namespace

void borneByJoints(const Evaluation& at, std::vector<ContactKey>& out) {
  out.clear();
  const ContactSet& c = at.contacts;
  int rows = 0;
  bool asked = false;
  for (int i = 0; i < c.size(); ++i) {
    asked = asked || c.law[static_cast<std::size_t>(i)]->unilateral();
    for (int r = 0; r < c.dim(i); ++r) rows += isJoint(c, i, r) ? 1 : 0;
  }
  if (rows == 0 || !asked) return;
  const Eigen::Index nu = at.h.size();
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(nu, rows), MInvW(nu, rows);
  int column = 0;
  for (int i = 0; i < c.size(); ++i)
    for (int r = 0; r < c.dim(i); ++r) {
      if (!isJoint(c, i, r)) continue;
      addRow(c, i, r, W.col(column));
      at.mass.applyInverse({W.col(column).data(), nu}, {MInvW.col(column).data(), nu});
      ++column;
    }
  Eigen::MatrixXd G = W.transpose() * MInvW;
  const Eigen::VectorXd scale = G.diagonal().cwiseSqrt().cwiseInverse();
  PseudoInverse inverse(kRedundant);
  inverse.compute(scale.asDiagonal() * G * scale.asDiagonal());
  Eigen::VectorXd w(nu), MInvw(nu), along(rows), share(rows);
  for (int i = 0; i < c.size(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    if (!c.law[index]->unilateral()) continue;
    w.setZero();
    addRow(c, i, 0, w);
    at.mass.applyInverse({w.data(), nu}, {MInvw.data(), nu});
    const double free = w.dot(MInvw);
    along = scale.cwiseProduct(W.transpose() * MInvw);
    inverse.solve(along, share);
    if (std::abs(free - along.dot(share)) <= kHeld * free) out.push_back(c.key[index]);
  }
}

}  // namespace dynamy
