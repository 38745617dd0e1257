#include <algorithm>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>
#include <dynamy_elements/contacts/pairs/seen_apart.hpp>

namespace dynamy {
namespace {

/// Part of the thickness of the thinner shape; features nearer than this are always noted.
constexpr double kNear = 1e-3;
/// Factor on the motion that the speeds predict, so that it bounds the motion between two checks.
constexpr double kFaster = 1.5;
/// Part of the size within which gaps are known by which bodies move at most between two looks at a path: one of the
/// looks then sees them meet.
constexpr double kPath = 0.5;
/// Work of one pair of features, as a part of that of a gap; of the gap and of all that are near.
constexpr double kOneWork = 0.1, kAllWork = 2.0;

/// Motion of B relative to A in the time τ near the smaller of the two.
Nearness movesWithin(const PosedPair& pair, double tau) {
  const auto& [a, b, A, B, plane] = pair;
  const bool small = b.bound < a.bound;
  const Frame& f = small ? B : A;
  const TouchingShape& shape = small ? b : a;
  const Vec3 c = f.r_OS_I + f.A_IK * shape.p_K;
  const double speed = (B.velocity(c - B.r_OS_I) - A.velocity(c - A.r_OS_I)).norm(),
               turn = (B.Omega_I - A.Omega_I).norm();
  return {kNear * std::min(a.thickness, b.thickness) + kFaster * tau * (speed + turn * shape.bound),
          kFaster * tau * turn};
}

/// Are the balls around the two shapes further than `reach` apart?
bool farApart(const PosedPair& pair, double reach) {
  const auto& [a, b, A, B, plane] = pair;
  const Vec3 way = B.r_OS_I + B.A_IK * b.p_K - A.r_OS_I - A.A_IK * a.p_K;
  return way.norm() > a.bound + b.bound + reach;
}

/// Are the shapes of the pair further than `reach` apart at a glance?
bool apartAtOnce(const PairReport& report, double reach) {
  const PosedPair& pair = report.pair();
  if (farApart(pair, reach)) return true;
  return report.rule().plane == 0 && seenApart(pair.a, pair.b, pair.A, pair.B, reach);
}

/// Gap of the pair, infinite if it cannot close within the time that is looked ahead.
double closingGap(const PairReport& report) {
  const PosedPair& pair = report.pair();
  const double reach = movesWithin(pair, report.request().ahead).reach;
  if (apartAtOnce(report, reach)) return kInfinity;
  const double bound = std::min(pair.a.bound, pair.b.bound);
  // Contacts on surfaces are found up to the smaller of the two bounds only.
  const double gap = report.rule().kernel->gap(pair, 0);
  if (std::min(gap, bound) > reach) return kInfinity;
  return gap;
}

/// True: the pair may move so far within the time that is looked ahead that no look at its path sees
/// them meet, since gaps and overlaps are known up to the size of the smaller one only. `gap`: that of
/// closingGap().
bool passesUnseen(const PairReport& report, double gap) {
  const auto& [a, b, A, B, plane] = report.pair();
  const PairKernel& kernel = *report.rule().kernel;
  const double seen = kernel.seen(b),
               known = std::min(gap >= seen ? seen : kInfinity, kernel.seenBelow(b));
  return movesWithin(report.pair(), report.request().ahead).reach > kPath * known;
}

/// Reports the contacts `asked` of a pair whose contacts jump, in this order: contacts that the
/// kernel does not find there are absent.
void reportAsked(PairReport& report, std::span<const ContactKey> asked) {
  ContactSink& sink = report.sink();
  sink.comesAndGoes();
  ContactRequest those = sink.request();
  those.frozen = asked;
  ContactSet found;
  found.clear();
  ContactSink into = sink.into(found, those);
  PairReport listing(report, kInfinity, into);
  const PairRule& rule = report.rule();
  rule.kernel->contacts(listing);
  const PosedPair& pair = report.pair();
  double size = std::min(pair.a.thickness, pair.b.thickness);
  if (!(size > 0.0)) size = std::min(pair.a.bound, pair.b.bound);  // of a thin shape
  // Bodies near each other of which no contact is known cannot be followed.
  if (found.candidateKey.empty() && rule.kernel->gap(pair, 0) <= kNear * size) return;
  for (const ContactKey key : asked) {
    const auto at = std::find(found.key.begin(), found.key.end(), key);
    if (at != found.key.end())
      sink.add(found, static_cast<int>(at - found.key.begin()), rule.rows);
    else
      sink.add(contactNumber(key), size, *rule.law, rule.rows);
    sink.presence(at != found.key.end() ? size : -size);
  }
}

/// Two bodies with flat faces.
template <class Body>
struct Facets {
  const Body &a, &b;
  double separation() const { return dynamy::separation(a, b); }
  FollowedPair pair(int f, bool rates) const {
    FollowedPair out;
    out.at = featurePair(a, b, f, rates, out.presence);
    return out;
  }
  void near(const Nearness& within, std::vector<int>& out) const {
    nearFeatures(a, b, within, out);
  }
};

/// A round body and another one.
template <class Features>
struct OfRound {
  const PairReport& report;
  const Features& pairs;
  double separation() const { return report.rule().kernel->gap(report.pair(), 0); }
  FollowedPair pair(int f, bool) const { return pairs.pair(f); }
  void near(const Nearness& within, std::vector<int>& out) const { pairs.near(within, out); }
};

/// `pairs`: pair(f, rates), separation() of the bodies and near(within, out).
template <class Pairs>
void followPairs(PairReport& report, const Pairs& pairs) {
  ContactSink& sink = report.sink();
  sink.comesAndGoes();
  const std::uint64_t first = report.id() + report.rule().followed,
                      end = report.id() + report.rule().features;
  for (const ContactKey key : sink.asked(first, end)) {
    const auto feature = static_cast<int>(contactNumber(key) - first);
    const FollowedPair pair = pairs.pair(feature, sink.request().bias);
    sink.searched(kOneWork * report.rule().work);
    report.add(contactNumber(key) - report.id(), pair.at);
    pair.circle >= 0.0 ? sink.circle(pair.circle) : sink.presence(pair.presence);
  }
  const double tau = sink.request().ahead;
  if (tau < 0.0) return;
  Nearness within = movesWithin(report.pair(), tau);
  if (apartAtOnce(report, within.reach)) return;
  sink.searched(kAllWork * report.rule().work);
  const double gap = pairs.separation();
  if (gap > within.reach) return;
  sink.overlap(-gap, report.id(), false);
  within.reach += std::max(0.0, -2.0 * gap);  // for bodies that overlap already
  std::vector<int>& near = report.near();
  near.clear();
  pairs.near(within, near);
  for (const int f : near) sink.note(first + static_cast<std::uint64_t>(f));
}

}  // namespace

void followFeatures(PairReport& report, const PlacedPolyhedron& a, const PlacedPolyhedron& b) {
  followPairs(report, Facets<PlacedPolyhedron>{a, b});
}

void followFeatures(PairReport& report, const PlacedPolygon& a, const PlacedPolygon& b) {
  followPairs(report, Facets<PlacedPolygon>{a, b});
}

void followFeatures(PairReport& report, const CapsuleFeatures& pairs) {
  followPairs(report, OfRound<CapsuleFeatures>{report, pairs});
}

void followFeatures(PairReport& report, const TwoCapsules& pairs) {
  followPairs(report, OfRound<TwoCapsules>{report, pairs});
}

void followFeatures(PairReport& report, const DiscFeatures& pairs) {
  followPairs(report, OfRound<DiscFeatures>{report, pairs});
}

void followFeatures(PairReport& report, const TwoDiscs& pairs) {
  followPairs(report, OfRound<TwoDiscs>{report, pairs});
}

void watch(PairReport& report) {
  const std::uint64_t id = report.id();
  const PairKernel& kernel = *report.rule().kernel;
  ContactSink& sink = report.sink();
  const ContactRequest& request = sink.request();
  const std::span<const ContactKey> asked = sink.asked(id, id + report.rule().features);
  const bool jumps = report.rule().following == Following::jumping && request.absent;
  if (!asked.empty()) jumps ? reportAsked(report, asked) : kernel.contacts(report);
  if (request.ahead < 0.0) {
    if (request.frozen.empty()) sink.note(id);  // a listing
    return;
  }
  const double gap = closingGap(report);
  if (gap == kInfinity) return;
  if (passesUnseen(report, gap)) sink.unseen();
  if (jumps) sink.comesAndGoes(), sink.overlap(-gap, id, true);
  ContactRequest all;
  all.refresh = true;
  ContactSet found;
  ContactSink into(found, all);
  PairReport listing(report, kInfinity, into);
  kernel.contacts(listing);
  for (const ContactKey key : found.candidateKey) sink.note(contactNumber(key));
  // The key of the pair itself has no contact: the pair is near, but nothing of it can be followed.
  if (found.candidateKey.empty()) sink.note(id);
}

/// A spin about the rim's own axis brings it no nearer to lying flat.
void noteFlat(PairReport& report, const OverHalfSpace& over) {
  const auto& [a, b, A, B, plane] = report.pair();
  const std::vector<SupportFeature>& features = b.features;
  const auto point = std::find_if(features.begin(), features.end(),
                                  [](const SupportFeature& f) { return f.flatOnly; });
  const ContactRequest& request = report.request();
  if (point == features.end() || (request.ahead < 0.0 && !request.frozen.empty())) return;
  const auto note = [&](const SupportFeature& f) {
    report.sink().note(report.id() + static_cast<std::uint64_t>(&f - features.data()));
  };
  if (request.ahead < 0.0) return note(*point);
  const Vec3 axis = B.A_IK * point->axis_K, Omega = B.Omega_I - A.Omega_I;
  const Vec3 level = axis.cross(A.A_IK * a.n_K);  // the rim tilts about this axis
  const double turn = axis.cross(Omega).norm(), sine = level.norm(), tau = request.ahead,
               tilt = sine > 0.0 ? std::abs(Omega.dot(level)) / sine : turn;
  const double rate = std::min(turn, tilt + kFaster * tau * Omega.norm() * turn);
  const double margin = kNear * b.thickness;
  if (point->rho * (sine - kFaster * tau * rate) > margin + request.flat) return;
  const Vec3 c = B.A_IK * b.p_K;
  const double speed = (B.velocity(c) - A.velocity(B.r_OS_I + c - A.r_OS_I)).norm(),
               reach = margin + kFaster * tau * (speed + turn * b.bound);
  for (const SupportFeature& f : features)
    if (f.flatOnly && over.gap(f) <= reach) note(f);
}

}  // namespace dynamy
