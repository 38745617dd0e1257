#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_name.hpp>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/missing_bias.hpp>
#include <limits>

namespace dynamy {
namespace {

/// True: contact i leaves the bias of all its rows zero.
bool isSilent(const ContactSet& c, int i) {
  const auto first = c.bias.begin() + c.row0[static_cast<std::size_t>(i)];
  return std::all_of(first, first + c.dim(i), [](double w) { return w == 0.0; });
}

}  // namespace

void MissingBias::elements(const ErrorNorm& norm, std::vector<int> without) {
  elements_ = std::move(without);
  use(norm);
}

bool MissingBias::has(int element) const {
  return std::binary_search(elements_.begin(), elements_.end(), element);
}

bool MissingBias::isFresh(const ContactSet& c, int i, const std::vector<ContactKey>& keys,
                          bool held) const {
  const auto at = static_cast<std::size_t>(i);
  return isSilent(c, i) && !has(c.element[at]) &&
         (held || !std::binary_search(keys.begin(), keys.end(), c.key[at]));
}

bool MissingBias::find(const MechanicalSystem& s, const State& x, const ErrorNorm& norm,
                       const PhaseRequest& phase, bool held) {
  const std::vector<ContactKey>& keys = phase.keys;
  // Checks contacts that report a zero bias: those that have just closed, and held contacts where a
  // projection had to make a large correction.
  const ContactSet& c = s.slot(0).contacts;
  bool any = false;
  for (int i = 0; i < c.size() && !any; ++i) any = isFresh(c, i, keys, held);
  if (!any) return false;
  asked_.assign(c.key.begin(), c.key.end());
  std::sort(asked_.begin(), asked_.end());
  std::vector<int> found;
  if (!reports(s, x, norm, found, keys, held)) return false;
  elements_.insert(elements_.end(), found.begin(), found.end());
  std::sort(elements_.begin(), elements_.end());
  elements_.erase(std::unique(elements_.begin(), elements_.end()), elements_.end());
  use(norm);
  return true;
}

/// `found`: the elements whose contacts report no bias although γ changes along the motion. True:
/// there are such elements.
bool MissingBias::reports(const MechanicalSystem& s, const State& x, const ErrorNorm& norm,
                          std::vector<int>& found, const std::vector<ContactKey>& keys, bool held) {
  const ContactSet& c = s.slot(0).contacts;
  const HeldContacts all{.keys = asked_, .follow = true};
  if (!differences_.rates(s, x, all, rates_) || rates_.size() != c.rows()) return false;
  const double T = norm.time(),
               least = BiasConstants::noRate * std::max(1.0, norm.length()) / (T * T);
  const auto note = [&](auto&& counts) {
    found.clear();
    for (int i = 0; i < c.size(); ++i) {
      const int first = c.row0[static_cast<std::size_t>(i)];
      for (int r = first; isFresh(c, i, keys, held) && r < first + c.dim(i); ++r)
        if (counts(r)) found.push_back(c.element[static_cast<std::size_t>(i)]);
    }
    return !found.empty();
  };
  if (!note([&](int r) { return std::abs(rates_[r]) > least; })) return false;
  // A rate that appears only with a kink within the difference (an edge that a ball rolls over) is
  // no missing bias.
  Eigen::VectorXd before, after;
  if (!differences_.rates(s, x, all, before, -BiasConstants::oneSided) ||
      !differences_.rates(s, x, all, after, BiasConstants::oneSided))
    return false;
  return note([&](int r) {
    return std::abs(rates_[r]) > least && std::abs(before[r]) > least && std::abs(after[r]) > least;
  });
}

int MissingBias::columns(const FrozenPhase& phase, double tolerance) const {
  const auto missing = [&](const Held& h) { return has(elementOf(h.key)); };
  if (!std::any_of(phase.held.begin(), phase.held.end(), missing)) return 0;
  return tolerance < BiasConstants::tight ? BiasConstants::tightColumns
                                          : BiasConstants::looseColumns;
}

void MissingBias::gammaAt(MechanicalSystem& s, const PhasePoint& p, const PhaseRequest& phase,
                          double tau, Eigen::VectorXd& gamma) {
  at_ = p.x;
  rates_ = p.x.u + 0.5 * tau * p.a;
  s.move(at_, rates_, tau);
  at_.u += tau * p.a;
  s.evaluate(at_, phase.in(1));
  gamma.resize(s.slot(1).contacts.rows());
  s.slot(1).contacts.gamma(view(std::as_const(at_.u)), view(gamma));
}

MissingBias::Verdict MissingBias::check(MechanicalSystem& s, const PhasePoint& p,
                                        const ErrorNorm& norm, const PhaseRequest& phase) {
  if (find(s, p.x, norm, phase, true)) return Verdict::missing;
  // The difference of γ along the motion is accurate up to (δ/T)² = 1e-8. T is that of the motion
  // here: mechanisms beside a singular position are a hundred times as fast as at the start. Where
  // γ has a kink close by (a formula with clamp, an edge that a ball rolls over), the difference is
  // taken on one side of the kink.
  double faster = 1.0;
  for (Eigen::Index i = 0; i < p.a.size(); ++i) {
    const double u = norm.velocity(i, p.x.u[i], 0.0), a = norm.velocity(i, p.a[i], 0.0);
    faster =
        std::max({faster, norm.tolerance() * u, std::sqrt(norm.tolerance() * a * norm.time())});
  }
  const double d = BiasConstants::difference * norm.time() / faster;
  Eigen::VectorXd before, after, now, far;
  gammaAt(s, p, phase, -d, before), gammaAt(s, p, phase, d, after);
  found_ = (after - before) / (2.0 * d);
  if (firstWrong(s, p, norm, d) < 0) return Verdict::right;
  gammaAt(s, p, phase, 0.0, now);
  int wrong = 0;
  for (const double side : {1.0, -1.0}) {
    gammaAt(s, p, phase, 2.0 * side * d, far);
    found_ = (4.0 * (side > 0.0 ? after : before) - 3.0 * now - far) / (2.0 * side * d);
    wrong = firstWrong(s, p, norm, d);
    if (wrong < 0) return Verdict::right;
  }
  return complain(s, wrong);
}

/// First row whose γ̇ by the bias of elements is not found_, a difference over d seconds; −1: none.
int MissingBias::firstWrong(const MechanicalSystem& s, const PhasePoint& p, const ErrorNorm& norm,
                            double d) {
  const double T = norm.time(),
               noise = BiasConstants::noise * std::max(1.0, norm.length()) / (T * T);
  const ContactSet& c = s.slot(0).contacts;
  reported_.resize(c.rows());
  c.gamma(view(p.a), view(reported_));
  rates_ = p.a.cwiseAbs();
  sums_.assign(static_cast<std::size_t>(c.rows()), 0.0);
  c.addAbsolute(view(std::as_const(rates_)), sums_.data());
  // The difference holds the rounding of γ over d, and its truncation. W turns with a body, and so both
  // are in a row across the motion what they are in the row along it.
  rates_ = p.x.u.cwiseAbs();
  gammaSums_.assign(static_cast<std::size_t>(c.rows()), 0.0);
  c.addAbsolute(view(std::as_const(rates_)), gammaSums_.data());
  const double truncation = BiasConstants::truncation;
  const double ofSpeed = (BiasConstants::roundings * std::numeric_limits<double>::epsilon() +
                          truncation * BiasConstants::difference) /
                         d;
  for (int i = 0; i < c.size(); ++i) {
    // The lowest point of a circle may run around it within d.
    if (c.features.isOnCircle(i)) continue;
    const int row0 = c.row0[static_cast<std::size_t>(i)], end = row0 + c.dim(i);
    double speed = 0.0, rate = 0.0;
    for (int r = row0; r < end; ++r)
      speed = std::max(speed, gammaSums_[static_cast<std::size_t>(r)]),
      rate = std::max(rate, sums_[static_cast<std::size_t>(r)]);
    for (int r = row0; r < end; ++r) {
      const auto row = static_cast<std::size_t>(r);
      reported_[r] += c.bias[row] - c.chi[row];
      if (std::abs(found_[r] - reported_[r]) >
          BiasConstants::share * (sums_[row] + std::abs(found_[r])) + noise + truncation * rate +
              ofSpeed * speed)
        return r;
    }
  }
  return -1;
}

MissingBias::Verdict MissingBias::complain(const MechanicalSystem& s, int row) {
  const ContactSet& c = s.slot(0).contacts;
  std::size_t i = 0;
  while (c.row0[i + 1] <= row) ++i;
  const NonSmoothElement& e = *s.parts().contacts[static_cast<std::size_t>(c.element[i])];
  lost_ = c.key[i];
  const std::string wrong = " a wrong bias of its row " + std::to_string(row - c.row0[i]) +
                            ": with it γ changes by " + numberText(reported_[row]) +
                            " a second, along the motion by " + numberText(found_[row]);
  std::vector<FrameHandle> surfaces;  // of two shapes, whose bias is the framework's own
  if (e.framesOf(contactNumber(lost_), surfaces)) {
    why_ = "the gap of contact " +
           contactName(e, static_cast<std::size_t>(c.element[i]), contactNumber(lost_)) +
           " has a kink, or its shapes tell" + wrong + "; run with a step";
    return Verdict::kinked;
  }
  const std::string name = e.name().empty() ? "" : " name=\"" + e.name() + "\"";
  why_ = "<" + e.type() + name + "> tells" + wrong +
         "; let contacts() tell γ̇ − Wᵀu̇, or run with a step";
  return Verdict::wrong;
}

}  // namespace dynamy
