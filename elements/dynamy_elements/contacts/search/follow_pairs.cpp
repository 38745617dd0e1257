// Contacts for simulations that follow gaps (theory 50.9, 50.11): pairs of features of boxes,
// polyhedra and polygons one by one, and pairs of shapes that are noted before they touch.
#include <algorithm>
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/search/feature_pairs.hpp>
#include <dynamy_elements/contacts/search/seen_apart.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>

namespace dynamy {
namespace {

/// Part of the thickness of the thinner shape; features nearer than this are always noted.
constexpr double kNear = 1e-3;
/// Factor on the motion that the speeds predict, so that it bounds the motion between two checks.
constexpr double kFaster = 1.5;

/// Motion of B relative to A in the time τ near the smaller of the two.
Nearness movesWithin(const TouchingShape& a, const TouchingShape& b, const Frame& A, const Frame& B,
                     double tau) {
  const bool small = b.bound < a.bound;
  const Frame& f = small ? B : A;
  const TouchingShape& shape = small ? b : a;
  const Vec3 c = f.r_OS_I + f.A_IK * shape.p_K;
  const double speed = (B.velocity(c - B.r_OS_I) - A.velocity(c - A.r_OS_I)).norm(),
               turn = (B.Omega_I - A.Omega_I).norm();
  return {kNear * std::min(a.thickness, b.thickness) + kFaster * tau * (speed + turn * shape.bound),
          kFaster * tau * turn};
}

}  // namespace

bool ShapeContacts::comesAndGoes(const Pair& pair) {
  const Meeting m = pair.rule->meets;
  return m == Meeting::boxes || m == Meeting::polyhedra || m == Meeting::polygons;
}

/// Does the pair have contacts that no gap can follow, since they jump
/// between features while they touch?
bool ShapeContacts::jumps(const Pair& pair) {
  switch (pair.rule->meets) {
    case Meeting::capsules:
    case Meeting::capsuleOnBox:
    case Meeting::capsuleOnSurface:
    case Meeting::capsuleOnPolygon:
    case Meeting::polyhedronOnMesh:
    case Meeting::smoothOnMesh:
    case Meeting::discOnPolyhedron:
    case Meeting::discOnMesh:
      return true;
    case Meeting::discs:
      return pair.B->kind != TouchingShape::Kind::ball;
    case Meeting::ballOnSurface:
      return !pair.A->polyhedron;
    default:
      return false;
  }
}

/// Among many shapes: does the pair's gap take a search, so that it is computed for near pairs
/// only?
bool ShapeContacts::waits(const Pair& pair) const {
  const Meeting m = pair.rule->meets;
  return namedPairs_.empty() &&
         (m == Meeting::smooth || m == Meeting::smoothOnPolyhedron || m == Meeting::smoothOnDisc);
}

/// Can the gap of the pair close within the time that is looked ahead? In a listing, where nothing
/// is requested by key, always true.
template <class Gap>
bool ShapeContacts::mayClose(const Pair& pair, const Kinematics& k, const ContactSink& sink,
                             Gap&& gap) const {
  const ContactRequest& request = sink.request();
  if (request.ahead < 0.0) return request.frozen.empty();
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  const double reach = movesWithin(*pair.A, *pair.B, A, B, request.ahead).reach;
  const Vec3 way = B.r_OS_I + B.A_IK * pair.B->p_K - A.r_OS_I - A.A_IK * pair.A->p_K;
  if (way.norm() > pair.A->bound + pair.B->bound + reach) return false;
  // If `reach` is beyond the bodies' bounds, surfaces count as near whatever their gap is.
  const bool small = reach < std::min(pair.A->bound, pair.B->bound) && pair.rule->plane == 0;
  if (small && seenApart(*pair.A, *pair.B, A, B, reach)) return false;
  return gap(A, B) <= reach;
}

/// Reports the contacts of the pair if some of them are requested by key, and notes its contacts if
/// they may close.
void ShapeContacts::watch(const Pair& pair, const Kinematics& k, ContactSink& sink) const {
  const std::uint64_t end = pair.id + pair.rule->features;
  const auto near = [&](const Frame& A, const Frame& B) {
    // Contacts on surfaces are found up to the smaller of the two bounds only.
    return std::min(gap(pair, 0, A, B), std::min(pair.A->bound, pair.B->bound));
  };
  if (!sink.asked(pair.id, end).empty()) narrow(pair, k, sink);
  if (!mayClose(pair, k, sink, near)) return;
  if (sink.request().ahead < 0.0) return sink.note(pair.id);
  ContactRequest all;
  all.refresh = true;
  ContactSet found;
  ContactSink into(found, all);
  narrow(pair, k, into);
  for (const ContactKey key : found.candidateKey) sink.note(contactNumber(key));
  // The key of the pair itself has no contact: the pair is near, but nothing of it can be followed.
  if (found.candidateKey.empty()) sink.note(pair.id);
}

/// Rims over a half space are followed unless one lies flat, where four of its points touch. A spin
/// about the rim's own axis brings it no nearer to lying flat.
void ShapeContacts::watchFlat(const Pair& pair, const OverHalfSpace& over, const Kinematics& k,
                              ContactSink& sink) const {
  const std::vector<SupportFeature>& features = pair.B->features;
  const auto point = std::find_if(features.begin(), features.end(),
                                  [](const SupportFeature& f) { return f.flatOnly; });
  const ContactRequest& request = sink.request();
  if (point == features.end() || (request.ahead < 0.0 && !request.frozen.empty())) return;
  const std::uint64_t number = pair.id + static_cast<std::uint64_t>(point - features.begin());
  if (request.ahead < 0.0) return sink.note(number);
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  const Vec3 axis = B.A_IK * point->axis_K, Omega = B.Omega_I - A.Omega_I;
  const Vec3 level = axis.cross(A.A_IK * pair.A->n_K);  // the rim tilts about this axis
  const double turn = axis.cross(Omega).norm(), sine = level.norm(), tau = request.ahead,
               tilt = sine > 0.0 ? std::abs(Omega.dot(level)) / sine : turn;
  const double rate = std::min(turn, tilt + kFaster * tau * Omega.norm() * turn);
  const double margin = kNear * pair.B->thickness;
  const Vec3 c = B.A_IK * pair.B->p_K;
  const double speed = (B.velocity(c) - A.velocity(B.r_OS_I + c - A.r_OS_I)).norm();
  double lowest = std::numeric_limits<double>::infinity(), rho = 0.0;
  for (const SupportFeature& f : features)
    if (f.kind == SupportFeature::Kind::rim)
      lowest = std::min(lowest, over.gap(f)), rho = std::max(rho, f.rho);
  if (rho * (sine - DiscBody::kFlat - kFaster * tau * rate) > margin) return;
  if (lowest <= margin + kFaster * tau * (speed + turn * pair.B->bound)) sink.note(number);
}

void ShapeContacts::follow(const Pair& pair, const Kinematics& k, ContactSink& sink) const {
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  if (pair.rule->meets != Meeting::polygons)
    return followBodies(pair, placedPolyhedron(A, *pair.A), placedPolyhedron(B, *pair.B), k, sink);
  const Vec3& plane = planes_[pair.rule->plane];
  followBodies(pair, PlacedPolygon{&A, &pair.A->polygon_K, plane},
               PlacedPolygon{&B, &pair.B->polygon_K, plane}, k, sink);
}

template <class Body>
void ShapeContacts::followBodies(const Pair& pair, const Body& a, const Body& b,
                                 const Kinematics& k, ContactSink& sink) const {
  sink.comesAndGoes();
  const std::uint64_t first = pair.id + pair.rule->followed, end = pair.id + pair.rule->features;
  for (const ContactKey key : sink.asked(first, end)) {
    const auto feature = static_cast<int>(contactNumber(key) - first);
    double presence = 0.0;
    const ContactPoint at = featurePair(a, b, feature, sink.request().bias, presence);
    emitPoint(pair, contactNumber(key) - pair.id, at, k, sink);
    sink.presence(presence);
  }
  const double tau = sink.request().ahead;
  if (tau < 0.0) return;
  const Frame &A = *a.frame, &B = *b.frame;
  Nearness within = movesWithin(*pair.A, *pair.B, A, B, tau);
  const Vec3 way = B.r_OS_I + B.A_IK * pair.B->p_K - A.r_OS_I - A.A_IK * pair.A->p_K;
  if (way.norm() > pair.A->bound + pair.B->bound + within.reach) return;
  const double gap = separation(a, b);
  if (gap > within.reach) return;
  sink.overlap(-gap);
  within.reach += std::max(0.0, -2.0 * gap);  // for bodies that overlap already
  near_.clear();
  nearFeatures(a, b, within, near_);
  for (const int f : near_) sink.note(first + static_cast<std::uint64_t>(f));
}

}  // namespace dynamy
