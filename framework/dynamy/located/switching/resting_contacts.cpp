#include <algorithm>
#include <cmath>
#include <dynamy/located/switching/notches.hpp>
#include <dynamy/located/switching/resting_contacts.hpp>

namespace dynamy {
namespace {

constexpr double kZeno = 0.1;  ///< z: heights below z tol L count as zero
constexpr double kZenoFloor = 1e-12;
/// Of L: the same for a contact that nothing has hit, whose gap is below zero by rounding.
constexpr double kRounding = 2e-14;
constexpr int kMostOffered = 16;  ///< most rows of a contact, also of laws that are refused

bool has(const std::vector<ContactKey>& keys, ContactKey key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// z tol, as a part of L: a contact that would rise no higher stays closed.
double zenoHeight(const ErrorNorm& norm) { return std::max(kZeno * norm.tolerance(), kZenoFloor); }

/// −γ̇ of the first row of contact i with the accelerations a.
double closing(const ContactSet& c, std::size_t i, const Eigen::VectorXd& a) {
  double back = -c.bias[static_cast<std::size_t>(c.row0[i])];
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& segment = c.segment[static_cast<std::size_t>(k)];
    for (int j = 0; j < segment.nu; ++j)
      back -= c.W[static_cast<std::size_t>(segment.w + j)] * a[segment.u0 + j];
  }
  return back;
}

}  // namespace

void RestingContacts::shut(OngoingEvent& at, const EventImpact& impact,
                           EventProjection& projection) {
  // Projects velocities in the metric of the mass, without a percussion of friction; closed
  // contacts stay closed.
  const ContactSet& c = at.s.slot(0).contacts;
  const Eigen::VectorXd& gamma = impact.gamma();
  resting_.clear();
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    const bool unilateral = c.law[i]->unilateral();
    if (unilateral && !has(shut_, c.key[i]) && gamma[c.row0[i]] > impact.leaves()) continue;
    // Parts that stick continue to stick.
    const int dim = c.dim(static_cast<int>(i));
    statusParts(*c.law[i], dim, parts_);
    for (const auto& [first, rows] : parts_) {
      double slip = 0.0;
      for (int k = unilateral && first == 0 ? 1 : first; k < first + rows; ++k)
        slip = std::max(slip, std::abs(gamma[c.row0[i] + k]));
      Held h;
      h.key = c.key[i], h.first = first, h.rows = rows;
      h.slips = !holds(c.law[i]->rowKind(0)) && slip > at.slipSpeed();
      if (notchSide(c, i, gamma.data() + c.row0[i], at) != 0.0) h.slips = !has(shut_, c.key[i]);
      resting_.push_back(h);
    }
  }
  projection.velocities(at.s, resting_, at.p.x);
}

void RestingContacts::evaluate(const OngoingEvent& at) {
  const ContactSet& c = at.s.slot(0).contacts;
  gamma_.resize(c.rows());
  c.gamma(view(std::as_const(at.p.x.u)), view(gamma_));
}

bool RestingContacts::findClosed(OngoingEvent& at, const EventImpact& impact,
                                 const std::vector<Held>& held) {
  const ContactSet& c = at.s.slot(0).contacts;
  evaluate(at);
  const double height = zenoHeight(at.norm) * at.norm.length();
  bool any = false;
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    if (!c.law[i]->unilateral() || findHeld(held, c.key[i]) != nullptr) continue;
    const double v = gamma_[c.row0[i]];
    if (!(v > impact.leaves())) continue;
    const double back = closing(c, i, at.p.a);
    // A contact that rebounds takes the impact once more without rebound; others are projected.
    const std::vector<Percussion>& hits = impact.percussions();
    const auto hit = std::find_if(hits.begin(), hits.end(),
                                  [&](const Percussion& q) { return q.key == c.key[i]; });
    const bool struck = hit != hits.end() && hit->gammaMinus[0] < -impact.leaves();
    const double most = c.key[i] == at.closes && !struck ? kRounding * at.norm.length() : height;
    if (!(back > 0.0 && v * v <= 2.0 * back * most)) continue;
    double epsilon[kMostOffered] = {};
    c.law[i]->epsilon(c.dim(static_cast<int>(i)), epsilon);
    if (struck && epsilon[0] > 0.0 && !has(plastic_, c.key[i]))
      plastic_.push_back(c.key[i]);
    else if (!has(shut_, c.key[i]))
      shut_.push_back(c.key[i]);
    else
      continue;
    // The rest of the sequence of impacts takes 2v/(a(1 − ε)).
    const double rebound = struck ? std::min(epsilon[0], 0.999999) : 0.0;
    at.result.accumulationEnd = at.p.x.t + 2.0 * v / (back * (1.0 - rebound));
    any = true, ++at.result.accumulations;
  }
  return any;
}

bool RestingContacts::close(const OngoingEvent& at, const EventImpact& impact) {
  const ContactSet& c = at.s.slot(0).contacts;
  const auto found = std::find(c.key.begin(), c.key.end(), at.closes);
  if (found == c.key.end() || has(shut_, at.closes)) return false;
  if (gamma_[c.row0[static_cast<std::size_t>(found - c.key.begin())]] > impact.leaves())
    return false;
  shut_.push_back(at.closes);
  return true;
}

bool RestingContacts::findInNotch(OngoingEvent& at, const Eigen::VectorXd& aBefore,
                                  const std::vector<Held>& old, const std::vector<Held>& held) {
  // A displacement that forces drive back from both sides, within the tolerance, has come to rest.
  const ContactSet& c = at.s.slot(0).contacts;
  evaluate(at);
  const double height = zenoHeight(at.norm) * std::min(at.norm.length(), 1.0);  // x may be an angle
  bool any = false;
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    if (!notched(c, i)) continue;
    const Held *before = findHeld(old, c.key[i]), *now = findHeld(held, c.key[i]);
    if (before == nullptr || now == nullptr || !before->slips || !now->slips) continue;
    const auto row = static_cast<std::size_t>(c.row0[i]);
    const double v = now->sign * gamma_[c.row0[i]];
    if (before->sign == now->sign || !(v > 0.0) || std::abs(c.position[row]) > notchMiddle(at.norm))
      continue;
    const double back = now->sign * closing(c, i, at.p.a);
    const double drawn = -now->sign * closing(c, i, aBefore);
    if (!(back > 0.0 && drawn > 0.0 && v * v <= 2.0 * back * height)) continue;
    if (has(shut_, c.key[i])) continue;
    shut_.push_back(c.key[i]);
    at.result.accumulationEnd = at.p.x.t + 2.0 * v / back;
    any = true, ++at.result.accumulations;
  }
  return any;
}

}  // namespace dynamy
