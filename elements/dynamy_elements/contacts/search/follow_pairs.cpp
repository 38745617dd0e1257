// Pairs of features of boxes, polyhedra and polygons one by one, for runs that follow their gaps.
#include <dynamy_elements/contacts/search/feature_pairs.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>

namespace dynamy {
namespace {

/// Of the thickness of the thinner: features nearer than this are noted in any case.
constexpr double kNear = 1e-3;
/// What bodies move between two looks at most, over what their speeds at one of them say.
constexpr double kFaster = 1.5;

/// How far B moves against A in the time τ near the smaller of the two.
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
  within.reach += std::max(0.0, -2.0 * gap);  // those of bodies that overlap already lie deeper
  near_.clear();
  nearFeatures(a, b, within, near_);
  for (const int f : near_) sink.note(first + static_cast<std::uint64_t>(f));
}

}  // namespace dynamy
