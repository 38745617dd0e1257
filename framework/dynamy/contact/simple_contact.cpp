#include <algorithm>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {
namespace {

constexpr int kMostOfOneSystem = 64;  ///< most positions, and most velocities, of the system

}  // namespace

void SimpleContact::declareCommon(Attributes& a) {
  a.reference("on", "system", "the system whose q and u the contact reads");
  a.child(Kind::law, 0, 1, "law of the contact; default: Unilateral with epsilonN = 0");
}

SimpleContact::SimpleContact(const Parameters& x)
    : NonSmoothElement(x), on_(x["on"].text), law_(x.takeOne<SetValuedForceLaw>()) {
  if (!law_) law_ = std::make_unique<Unilateral>(0.0);
}

SimpleContact::~SimpleContact() = default;

void SimpleContact::connect(Topology& topology) {
  own_ = {topology, on_, *this};
  if (own_.handle().blocks > 1)
    throw ModelError("a simple contact acts on a system of one block",
                     "write a NonSmoothElement for populations");
  if (rows() < 1 || rows() > kMostRows)
    throw ModelError("a simple contact has 1 to " + std::to_string(kMostRows) + " rows, not " +
                         std::to_string(rows()),
                     "report the rows as several contacts");
  if (own_.nu() > kMostOfOneSystem || own_.nq() > kMostOfOneSystem)
    throw ModelError("a simple contact acts on a system of at most " +
                         std::to_string(kMostOfOneSystem) + " coordinates",
                     "write a NonSmoothElement");
}

void SimpleContact::contacts(const Kinematics& k, ContactSink& sink) const {
  const ConstVec q = own_.q(k);
  auto out = sink.add(0, g(k.t(), q), *law_, rows());
  if (!out) return;
  // γ is affine in u: χ = γ(t, q, 0), column j of W = γ(t, q, e_j) − χ.
  const int n = own_.nu(), dim = out.dim(), all = rows();
  double e[kMostOfOneSystem] = {}, value[kMostRows], chi[kMostRows];
  gamma(k.t(), q, {e, n}, {chi, all});
  const Block moving = out.segment(own_.handle());
  Block W = own_.room(moving);
  for (int j = 0; j < n; ++j) {
    e[j] = 1.0;
    gamma(k.t(), q, {e, n}, {value, all});
    e[j] = 0.0;
    for (int r = 0; r < dim; ++r) W(r, j) = value[r] - chi[r];
  }
  for (int r = 0; r < dim; ++r) out.chi(r) = chi[r];
  if (DrawnPlace at; drawnAt(k.t(), q, at))
    out.place(at.point, at.normal, at.t1, at.normal.cross(at.t1));
  const double* bias = own_.carry(k, moving);
  if (out.wantsBias()) addBias(k, out, dim);
  for (int r = 0; bias && out.wantsBias() && r < dim; ++r) out.bias(r) += bias[r];
}

void SimpleContact::addBias(const Kinematics& k, ContactRows& out, int dim) const {
  // d/ds γ(t+s, q + s u, u) with u fixed, by the 4-point difference; any curve with the right
  // tangent will do. Systems whose positions are not moved by q̇ = u override bias().
  double w[kMostRows] = {};
  if (!bias(k, {w, rows()})) {
    const ConstVec q = own_.q(k), u = own_.u(k);
    const double d = 1e-3 / (1.0 + u.lpNorm<Eigen::Infinity>());
    const double weight[4] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0},
                 at[4] = {-2.0, -1.0, 1.0, 2.0};
    double moved[kMostOfOneSystem], value[kMostRows];
    const int both = std::min(own_.nq(), own_.nu());
    std::copy(q.data(), q.data() + own_.nq(), moved);
    for (int p = 0; p < 4; ++p) {
      for (int j = 0; j < both; ++j) moved[j] = q[j] + at[p] * d * u[j];
      gamma(k.t() + at[p] * d, {moved, own_.nq()}, u, {value, rows()});
      for (int r = 0; r < dim; ++r) w[r] += weight[p] * value[r] / d;
    }
  }
  for (int r = 0; r < dim; ++r) out.bias(r) = w[r];
}

void SimpleContact::describe(Description& d) const { describeContact(d, 0, rows(), *law_); }

}  // namespace dynamy
