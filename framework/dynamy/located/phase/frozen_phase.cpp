#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/located/phase/frozen_phase.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {
namespace {

/// Pivots below this share of the largest belong to redundant rows.
constexpr double kClearMargin = 1e-3;  ///< of the largest force
constexpr int kMostSlipTurns = 200;    ///< iterations for the directions of slips that start
constexpr double kTurned = 1e-14;      ///< change of a direction that ends these iterations

}  // namespace

const Held* FrozenPhase::find(ContactKey key) const {
  for (const Held& h : held)
    if (h.key == key) return &h;
  return nullptr;
}

Held* FrozenPhase::find(ContactKey key) {
  for (Held& h : held)
    if (h.key == key) return &h;
  return nullptr;
}

const Held* FrozenPhase::find(HeldKey part) const {
  for (const Held& h : held)
    if (h.key == part.key && h.first == part.first) return &h;
  return nullptr;
}

void FrozenPhase::keys(std::vector<ContactKey>& out) const {
  for (const Held& h : held)
    if (h.first == 0) out.push_back(h.key);
  std::sort(out.begin(), out.end());
}

namespace {

/// Coefficient of the disc that row `row` of a law of discs belongs to.
double discSize(const NormalTimesReservoir& law, int dim, int row) {
  double axis[kMostRows] = {};
  axis[row - 1] = 1.0;
  return law.support({.dim = dim, .dt = 1.0}, dim - 1, axis);
}

}  // namespace

void FrozenPhase::parts(const SetValuedForceLaw& law, int dim,
                        std::vector<std::array<int, 2>>& out) {
  out.clear();
  const NormalTimesReservoir* discs = law.discs();
  if (discs == nullptr || dim < 2 || dim > kMostRows) {
    out.push_back({0, dim});
    return;
  }
  // Rows without a coefficient take no force at all.
  for (int row = 1; row < dim; row = law.groupEnd(row, dim)) {
    const int end = law.groupEnd(row, dim), first = row == 1 ? 0 : row;
    const bool any = discSize(*discs, dim, row) > 0.0;
    if (any || first == 0) out.push_back({first, any ? end - first : 1});
  }
}

bool FrozenPhase::bounds(const SetValuedForceLaw& law, const LawInput& in, Bounds& out, int first) {
  if (const NormalTimesReservoir* discs = law.discs(); discs != nullptr && in.dim > 1) {
    if (in.dim > kMostRows) return false;
    out.upper = discSize(*discs, in.dim, std::max(first, 1));
    out.form = first > 0 ? Form::disc : out.upper > 0.0 ? Form::cone : Form::normal;
    return true;
  }
  if (NotchedForce f; law.notched(in, f)) {
    // A slip with the sign of x has the force of that side, continued smoothly past x = 0.
    const double x = in.position ? in.position[0] : 0.0;
    out.form = Form::notch, out.lower = f.above - f.cAbove * x, out.upper = f.below - f.cBelow * x;
    return true;
  }
  const SimpleSet set = law.simpleSet(in);
  out.lower = set.lower, out.upper = set.upper;
  switch (set.shape) {
    case SimpleSet::Shape::all:
      out.form = Form::joint;
      return true;
    case SimpleSet::Shape::interval:
      out.form = law.unilateral() ? Form::normal : Form::given;
      return in.dim == 1;
    case SimpleSet::Shape::ball:
      out.form = Form::given, out.lower = -set.upper;
      return true;
    case SimpleSet::Shape::friction:
      out.form = Form::cone;
      return true;
    default:
      break;
  }
  // A reservoir: its widths along the rows are S_B(e_r).
  out.set = law.reservoir();
  const int dim = in.dim;
  if (out.set == nullptr || dim < 2 || dim > kMostRows) return false;
  out.form = Form::reservoir, out.upper = 0.0;
  for (int r = 0; r < dim - 1; ++r) {
    double axis[kMostRows] = {};
    axis[r] = 1.0;
    out.weight[static_cast<std::size_t>(r)] = out.set->support(in, dim - 1, axis);
    // Only widths of tangential rows are forces over Λ_N; a spin row comes last.
    if (r < 2) out.upper = std::max(out.upper, out.weight[static_cast<std::size_t>(r)]);
  }
  for (double& w : out.weight) w = out.upper > 0.0 ? w / out.upper : 1.0;
  return out.upper > 0.0;
}

double slipSpeed(const FrozenPhase::Bounds& b, int rows, const double* gamma) {
  double square = 0.0;
  for (int r = 0; r < rows; ++r) {
    const double v = b.weight[static_cast<std::size_t>(r)] * gamma[r];
    square += v * v;
  }
  return std::sqrt(square);
}

void FrozenPhase::addRow(const ContactSet& c, int at, int of, Eigen::MatrixXd& W, int row) {
  const auto i = static_cast<std::size_t>(at);
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(of) * s.nu;
    for (int j = 0; j < s.nu; ++j) W(s.u0 + j, row) += w[j];
  }
}

int FrozenPhase::countRows(const Evaluation& e) const {
  int n = 0;
  for (const Held& h : held) {
    const auto at = std::find(e.contacts.key.begin(), e.contacts.key.end(), h.key);
    if (h.rows > 0)
      n += h.rows;
    else if (at != e.contacts.key.end())
      n += e.contacts.dim(static_cast<int>(at - e.contacts.key.begin()));
  }
  return n;
}

bool FrozenPhase::gather(const Evaluation& e, const Eigen::VectorXd& u) {
  const ContactSet& c = e.contacts;
  const std::size_t n = held.size();
  index_.resize(n), form_.resize(n), bounds_.resize(n), row0_.assign(n + 1, 0);
  std::size_t cursor = 0;
  for (std::size_t i = 0; i < n; ++i) {  // contacts come in the same order, with others between
    while (cursor < c.key.size() && c.key[cursor] != held[i].key) ++cursor;
    // A checkpoint may name a part that the contact does not have.
    const bool other =
        cursor < c.key.size() && held[i].first + held[i].rows > c.dim(static_cast<int>(cursor));
    if (cursor == c.key.size() || other) {
      fault_ = kLost, lost_ = held[i].key;
      return false;
    }
    index_[i] = static_cast<int>(cursor);
    row0_[i + 1] = row0_[i] + (held[i].rows > 0 ? held[i].rows : c.dim(index_[i]));
  }
  const int rows = row0_.back();
  W_.setZero(u.size(), rows), MInvW_.resize(u.size(), rows);
  moved_.clear(), moved0_.clear();
  gamma_.resize(rows), bias_.resize(rows), position_.resize(rows);
  chi_.resize(static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(index_[i]);
    for (int r = 0; r < dim(i); ++r) {
      const int row = row0_[i] + r, of = held[i].first + r;
      const auto from = static_cast<std::size_t>(c.row0[at] + of);
      addRow(c, index_[i], of, W_, row);
      moved0_.push_back(static_cast<int>(moved_.size()));
      for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
        const Segment& s = c.segment[static_cast<std::size_t>(k)];
        moved_.push_back({s.u0, s.nu});
      }
      bias_[row] = c.bias.size() > from ? c.bias[from] : 0.0;
      position_[row] = c.position[from];
      chi_[static_cast<std::size_t>(row)] = c.chi[from];
      gamma_[row] = W_.col(row).dot(u) + c.chi[from];
      e.mass.applyInverse({W_.col(row).data(), u.size()}, {MInvW_.col(row).data(), u.size()});
    }
  }
  moved0_.push_back(static_cast<int>(moved_.size()));
  return true;
}

void FrozenPhase::columns(std::size_t i) {
  const Held& h = held[i];
  const int first = row0_[i], d = dim(i);
  const auto unknown = [&](int row) {
    P_(row, static_cast<Eigen::Index>(kept_.size())) = 1.0;
    kept_.push_back(row);
  };
  if (h.first == 0) normal_ = static_cast<Eigen::Index>(kept_.size());
  if (!h.slips) {
    for (int r = 0; r < d; ++r) unknown(first + r);
    return;
  }
  const int tangent = slip0(i), k = slipRows(i);
  const bool normal = tangent > first;
  if (normal) unknown(first);
  // Direction of slip: γ_T of the stage; in one tangent, and while a slip starts, the decided one.
  const double speed = slipSpeed(bounds_[i], k, gamma_.data() + tangent);
  const bool decided = k > 1 && (h.starts || !(speed > Held::kLeastSlip));
  const double* t = decided ? h.direction.data() : k > 1 ? gamma_.data() + tangent : &h.sign;
  if (form_[i] == Form::reservoir) {
    double force[kMostRows];
    bounds_[i].set->support({dim(i), 1.0, gamma_.data() + first, nullptr}, k, t, force);
    for (int r = 0; r < k; ++r) P_(tangent + r, normal_) = -force[r];
    return;
  }
  const double length = k > 1 ? ConstVec(t, k).norm() : 1.0;
  for (int r = 0; r < k; ++r) {
    const double e = t[r] / length;
    if (normal || form_[i] == Form::disc)
      P_(tangent + r, normal_) = -bounds_[i].upper * e;
    else
      p0_[tangent + r] = e > 0.0 ? bounds_[i].lower * e : -bounds_[i].upper * e;
  }
}

bool FrozenPhase::shapes(const Evaluation& e) {
  for (std::size_t i = 0; i < held.size(); ++i) {
    const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(index_[i])];
    double slip[kMostRows] = {};
    const bool fits = dim(i) <= kMostRows;
    for (int r = 0; fits && r < dim(i); ++r) slip[r] = gamma_[row0_[i] + r];
    const LawInput in = e.contacts.input(index_[i], 1.0, nullptr);
    const bool whole = held[i].rows == 0 && law.discs() != nullptr && dim(i) > 1;
    if (!fits || whole || !slipBounds(law, in, held[i], slip, bounds_[i])) {
      ownFault_ = "the smooth phases of <" + law.type() +
                  "> have no closed form here (it tells no shape of its set): give a step "
                  "and another scheme";
      fault_ = ownFault_;
      return false;
    }
    form_[i] = bounds_[i].form;
    const double bound = held[i].sign > 0.0 ? bounds_[i].lower : bounds_[i].upper;
    const bool given = form_[i] == Form::given && dim(i) == 1;
    if (!held[i].slips || !(form_[i] == Form::joint || (given && std::isinf(bound)))) continue;
    fault_ = kOtherSet, lost_ = held[i].key;
    return false;
  }
  return true;
}

void FrozenPhase::startDirections(const Evaluation& e) {
  for (int i = 0; i < kMostSlipTurns && turnStarting() > kTurned; ++i) solve(e, W_, bias_);
}

bool FrozenPhase::accelerate(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a) {
  fault_ = {};
  if (!gather(e, u) || !shapes(e)) return false;
  solve(e, W_, bias_);
  startDirections(e);
  a = free_;
  finish(e, u);
  return true;
}

void FrozenPhase::solve(const Evaluation& e, const Eigen::MatrixXd& R,
                        const Eigen::VectorXd& bias) {
  const int n = rows();
  P_.setZero(n, n), p0_.setZero(n), kept_.clear();
  for (std::size_t i = 0; i < held.size(); ++i) columns(i);
  // (Sᵀ G P) d = −Sᵀ(Wᵀ M⁻¹(h + W(p₀ + P π₀)) + w̄),  π₀ of the last decision.
  free_.resize(e.h.size());
  e.mass.applyInverse(view(e.h), view(free_));
  const auto m = static_cast<Eigen::Index>(kept_.size());
  lambda_ = p0_;
  work_.resize(m);
  std::size_t of = 0;
  for (Eigen::Index k = 0; k < m; ++k) {
    const int row = kept_[static_cast<std::size_t>(k)];
    while (row >= row0_[of + 1]) ++of;
    work_[k] = held[of].lambda[static_cast<std::size_t>(row - row0_[of])];
  }
  lambda_.noalias() += P_.leftCols(m) * work_;
  free_.noalias() += MInvW_ * lambda_;
  redundant_ = false;
  if (m == 0) return;
  A_.resize(m, m), rhs_.resize(m);
  multiplyByP();
  for (Eigen::Index k = 0; k < m; ++k) {
    const int row = kept_[static_cast<std::size_t>(k)];
    rhs_[k] = -(R.col(row).dot(free_) + bias[row]);
    if (&R != &W_) {  // R at another position, where contacts may act on other velocities
      A_.row(k).noalias() = R.col(row).transpose() * MP_;
      continue;
    }
    A_.row(k).setZero();
    for (const Moved& p : moved(row))
      A_.row(k).noalias() +=
          R.col(row).segment(p.u0, p.nu).transpose() * MP_.middleRows(p.u0, p.nu);
  }
  // Redundant forces are smallest in units of what each contact carries: a contact that presses
  // hard takes more of them.
  scale_.resize(m);
  of = 0;
  for (Eigen::Index k = 0; k < m; ++k) {
    while (kept_[static_cast<std::size_t>(k)] >= row0_[of + 1]) ++of;
    scale_[k] = held[of].weight;
    A_.col(k) *= scale_[k];
  }
  inverse_.compute(A_);
  redundant_ = inverse_.rank() < m;
  inverse_.solve(rhs_, work_);
  work_.array() *= scale_.array();
  free_.noalias() += MP_ * work_;
  lambda_.noalias() += P_.leftCols(m) * work_;
}

double FrozenPhase::leastMargin() const {
  double least = 1e300, value = 0.0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (margin(i, value)) least = std::min(least, value);
  return least;
}

bool FrozenPhase::share(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a) {
  if (!accelerate(e, u, a)) return false;
  if (!redundant_) return true;
  const std::vector<Held> decided = held;
  const auto take = [&](double part, bool weighted) {
    for (std::size_t i = 0; i < held.size(); ++i) {
      held[i].weight = weighted ? decided[i].weight : 1.0;
      for (std::size_t r = 0; r < held[i].lambda.size(); ++r)
        held[i].lambda[r] = part * decided[i].lambda[r];
    }
  };
  // Where slips differ, the motion depends on how redundant rows share. The smallest forces, if all
  // bounds permit them, are a choice that depends neither on rounding nor on a solver.
  double best = 1.0, least = leastMargin();
  bool bestWeighted = true;
  take(0.0, false);
  if (!accelerate(e, u, a)) return false;
  if (leastMargin() > kClearMargin * forceScale_) return true;
  for (const bool weighted : {true, false})
    for (const double part : {0.0, 0.25, 0.5, 0.75}) {
      take(part, weighted);
      if (!accelerate(e, u, a)) return false;
      if (const double margin = leastMargin(); margin > least)
        least = margin, best = part, bestWeighted = weighted;
    }
  take(best, bestWeighted);
  return accelerate(e, u, a);
}

double FrozenPhase::turnStarting() {
  // t ← −(λ_T − r γ̇_T)/|…| with r = 1/G_TT: the fixed point is −γ̇_T ∈ N_C(λ_T).
  double change = 0.0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    Held& h = held[i];
    const int first = slip0(i), k = slipRows(i);
    if (!h.starts || k < 2) continue;
    double r[kMostRows], z[kMostRows], y[kMostRows];
    double G = 0.0;
    for (int n = 0; n < k; ++n) {
      r[n] = 1.0 / W_.col(first + n).dot(MInvW_.col(first + n));
      G += 1.0 / (r[n] * k);
    }
    for (int n = 0; n < k; ++n) {
      if (form_[i] != Form::reservoir) r[n] = 1.0 / G;
      y[n] = z[n] = lambda_[first + n] - r[n] * (W_.col(first + n).dot(free_) + bias_[first + n]);
    }
    if (form_[i] == Form::reservoir)
      bounds_[i].set->project({dim(i), 1.0, gamma_.data() + row0_[i], nullptr}, lambda_[row0_[i]],
                              r, k, y);
    for (int n = 0; n < k; ++n) y[n] = form_[i] == Form::reservoir ? (y[n] - z[n]) / r[n] : -z[n];
    const double length = slipSpeed(bounds_[i], k, y);
    if (!(length > 0.0)) continue;
    for (int n = 0; n < k; ++n) {
      const auto at = static_cast<std::size_t>(n);
      change = std::max(change, bounds_[i].weight[at] * std::abs(y[n] / length - h.direction[at]));
      h.direction[at] = y[n] / length;
    }
  }
  return change;
}

void FrozenPhase::finish(const Evaluation& e, const Eigen::VectorXd& u) {
  gammaDot_.noalias() = W_.transpose() * free_;
  gammaDot_ += bias_;
  forceScale_ = lambda_.size() > 0 ? lambda_.lpNorm<Eigen::Infinity>() : 0.0;
  for (const Bounds& b : bounds_)
    if ((b.form == Form::given || b.form == Form::notch) && std::isfinite(b.upper))
      forceScale_ = std::max(forceScale_, b.upper);
  power_ = {e.hNonPotential.dot(u), 0.0, 0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < held.size(); ++i)
    for (int r = 0; r < dim(i); ++r) {
      const int row = row0_[i] + r;
      const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(index_[i])];
      bookWork(power_, law.rowKind(held[i].first + r), lambda_[row], gamma_[row], chi_[row]);
    }
}

}  // namespace dynamy
