// Contacts of the shapes that are near each other.
#include <algorithm>
#include <cmath>
#include <dynamy/contact/rolling_contact.hpp>
#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/contour_motion.hpp>
#include <dynamy_elements/contacts/pairs/disc_on_mesh.hpp>
#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/pairs/round_contact.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <dynamy_elements/contacts/pairs/surface_contact.hpp>
#include <dynamy_elements/contacts/search/grain.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>

namespace dynamy {
namespace {

/// The lowest corner of a box among those that may be closed; null: B is no box. If contacts are
/// requested by key, a corner that is not requested must not move them when it passes below.
const SupportFeature* lowestCorner(const OverHalfSpace& over, const TouchingShape& B,
                                   std::uint64_t id, const ContactSink& sink) {
  if (B.kind != TouchingShape::Kind::box) return nullptr;
  const SupportFeature* lowest = nullptr;
  for (std::size_t f = 0; f < B.features.size(); ++f)
    if (!sink.leftOut(id + f) && (!lowest || over.gap(B.features[f]) < over.gap(*lowest)))
      lowest = &B.features[f];
  return lowest;
}

/// The point of contact moves with Ṗ, not with a body.
void addBias(ContactRows& rows, const ContactPoint& at, const Frame& A, const Frame& B) {
  const Vec3 rhoA = at.P - A.r_OS_I, rhoB = at.P - B.r_OS_I;
  const Vec3 v_BA = B.velocity(rhoB) - A.velocity(rhoA);
  const Vec3 a_BA = B.bias_S_I + B.bias_R_I.cross(rhoB) + B.Omega_I.cross(at.Pdot - B.v_S_I) -
                    A.bias_S_I - A.bias_R_I.cross(rhoA) - A.Omega_I.cross(at.Pdot - A.v_S_I);
  for (int r = 0; r < rows.dim() && r < 3; ++r)
    rows.bias(r) = at.ddot[r].dot(v_BA) + at.d[r].dot(a_BA);
  // Angular velocities: spin about the normal, and about the tangents.
  const int first = rows.dim() == 5 ? 1 : 0;
  for (int r = 3; r < rows.dim() && r < 6; ++r) {
    const int k = first + r - 3;
    rows.bias(r) = at.ddot[k].dot(B.Omega_I - A.Omega_I) + at.d[k].dot(B.bias_R_I - A.bias_R_I);
  }
}

}  // namespace

/// Reports the contacts of those pairs only that are requested by key.
void ShapeContacts::namedAlone(const Kinematics& k, ContactSink& sink) const {
  const std::uint64_t n = shapes_[0].size();
  std::uint64_t last = n * n;
  for (const ContactKey key : sink.asked(0, n * n * features_)) {
    const std::uint64_t number = contactNumber(key) / features_;
    if (number == last) continue;
    last = number;
    const Pair pair = pairOf(static_cast<int>(number / n), static_cast<int>(number % n));
    if (!pair) continue;
    if (pair.rule->meets == Meeting::overHalfSpace)
      overHalfSpace(pair, k, sink);
    else if (sink.request().follow && comesAndGoes(pair))
      follow(pair, k, sink);
    else
      narrow(pair, k, sink);
  }
}

void ShapeContacts::contacts(const Kinematics& k, ContactSink& sink) const {
  if (sink.request().refresh && sink.request().gTol < 0.0) return namedAlone(k, sink);
  const std::vector<TouchingShape>& shapes = shapes_[0];
  const int n = static_cast<int>(shapes.size());
  lookAhead(k, sink.request());
  balls_.clear();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const TouchingShape& s = shapes[i];
    const Frame& f = k.frame(s.frame);
    const bool bounded = std::isfinite(s.bound) && !f.absent;
    // A shape without a finite place, in a trial step that was too long, is near all others: pairs
    // of features that are requested by key are still reported.
    const Vec3 c = f.r_OS_I + f.A_IK * s.p_K;
    balls_.push_back(
        {c.allFinite() ? c : Vec3(Vec3::Zero()), bounded ? s.bound + reach_[i] : -1.0});
  }
  turned_.assign(shapes.size(), 0.0);
  // Half spaces report all contacts of few shapes, to follow their gaps, and near ones of many.
  const bool all = !namedPairs_.empty() || sink.request().refresh;
  for (const int h : flats_) {
    const auto at = static_cast<std::size_t>(h);
    const TouchingShape& flat = shapes[at];
    const Frame& A = k.frame(flat.frame);
    const Vec3 normal = A.A_IK * flat.n_K;
    const Vec3 onPlane = A.r_OS_I + A.A_IK * flat.p_K;
    for (int i = 0; i < n; ++i) {
      const BroadPhase::Ball& ball = balls_[static_cast<std::size_t>(i)];
      const double beyond = ball.radius + reach_[at] - normal.dot(ball.c - onPlane);
      if (ball.radius < 0.0 || (!all && beyond < 0.0)) continue;
      const auto ofBall = static_cast<std::size_t>(i);
      // A body that falls along a wall is not deflected by it.
      const double toIt = std::max(
          0.0, normal.dot(A.velocity(ball.c - A.r_OS_I) - k.frame(shapes[ofBall].frame).v_S_I));
      const double way =
          shapes[ofBall].isBall() ? std::min(reach_[ofBall], tau_ * toIt) : reach_[ofBall];
      turned_[ofBall] = std::max(turned_[ofBall], beyond - reach_[ofBall] - reach_[at] + way);
      if (const Pair pair = pairOf(h, i)) overHalfSpace(pair, k, sink);
    }
  }
  const std::vector<BroadPhase::Pair>& near =
      nearPairs(tau_ > 0.0 ? BroadPhase::kPassed : BroadPhase::kNeighbours);
  if (tau_ > 0.0) followTurns(k, near);
  for (std::size_t m = 0; m < near.size(); ++m) {
    if (tau_ > 0.0 && gap_[m] > way_[m]) continue;
    const Pair pair = pairOf(near[m].first, near[m].second);
    if (!pair) continue;
    if (sink.request().follow && comesAndGoes(pair))
      follow(pair, k, sink);
    else if (sink.request().follow && (jumps(pair) || waits(pair)))
      watch(pair, k, sink);
    else
      narrow(pair, k, sink);
  }
}

void ShapeContacts::overHalfSpace(const Pair& pair, const Kinematics& k, ContactSink& sink) const {
  const OverHalfSpace over(k.frame(pair.A->frame), *pair.A, k.frame(pair.B->frame));
  const Vec3& plane = planes_[pair.rule->plane];
  const SupportFeature* lowest = lowestCorner(over, *pair.B, pair.id, sink);
  const bool follows = sink.request().follow;
  if (follows) watchFlat(pair, over, k, sink);
  for (std::size_t f = 0; f < pair.B->features.size(); ++f) {
    const SupportFeature& feature = pair.B->features[f];
    // A rim that lies flat is followed as one of its points, as all have the same height.
    const bool touches = over.touches(feature), isRim = feature.kind == SupportFeature::Kind::rim;
    if (follows ? feature.flatOnly : !touches) continue;
    emit(pair, f, over.gap(feature), k, sink, [&] {
      const bool lies = isRim && !touches;
      ContactPoint at = over.contact(lies ? pair.B->features[f + 1] : feature, plane);
      if (lowest && &feature != lowest)
        intoPlane(at.d[0], at.ddot[0], over.contact(*lowest, plane), at);
      return at;
    });
  }
}

/// Largest gap of B reported on a surface of A, which has one side: at most B's size [m].
double ShapeContacts::seenFrom(const Pair& pair, const ContactSink& sink) const {
  if (sink.request().refresh) return pair.B->bound;
  return std::min(pair.B->bound, 0.5 * pair.B->thickness + std::max(sink.request().gTol, 0.0));
}

/// Up to which gap contacts of two shapes are reported [m].
double ShapeContacts::reachOf(const Pair& pair, const ContactSink& sink) const {
  if (!namedPairs_.empty() || sink.request().refresh)
    return std::numeric_limits<double>::infinity();
  return reach_[pair.i] + reach_[pair.j];
}

void ShapeContacts::narrow(const Pair& pair, const Kinematics& k, ContactSink& sink) const {
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  const Vec3& plane = planes_[pair.rule->plane];
  switch (pair.rule->meets) {
    case Meeting::balls: {
      const ContactPoint at = betweenBalls(A, pair.A->features[0], B, pair.B->features[0], plane);
      emit(pair, 0, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
      return;
    }
    case Meeting::ballOnBox: {
      const ContactPoint at = ballOnBox(A, *pair.A, B, pair.B->features[0], plane);
      // The contact is reported at the same distance as that of two balls.
      const double reach = 0.5 * (pair.B->bound + pair.A->half.minCoeff());
      if (sink.request().refresh || at.g <= reach)
        emit(pair, 0, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
      return;
    }
    case Meeting::ballOnCapsule:
    case Meeting::ballOnCylinder:
    case Meeting::ballOnCone: {
      const RoundFeature& ball = pair.B->features[0];
      const Meeting meets = pair.rule->meets;
      const ContactPoint at =
          meets == Meeting::ballOnCapsule ? ballOnCapsule(A, *pair.A, B, ball, plane)
          : meets == Meeting::ballOnCone  ? ballOnCone(discBody(A, *pair.A), B, ball)
                                          : ballOnCylinder(A, *pair.A, B, ball);
      emit(pair, 0, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
      return;
    }
    case Meeting::capsules:
    case Meeting::capsuleOnBox: {
      RoundContacts found;
      const int n = pair.rule->meets == Meeting::capsules
                        ? betweenCapsules(A, *pair.A, B, *pair.B, plane, found)
                        : capsuleOnBox(A, *pair.A, B, *pair.B, found);
      return emitAll(pair, found, n, k, sink);
    }
    default:
      return narrowSmooth(pair, k, sink);
  }
}

void ShapeContacts::narrowSmooth(const Pair& pair, const Kinematics& k, ContactSink& sink) const {
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  switch (pair.rule->meets) {
    case Meeting::smooth:
    case Meeting::smoothOnPolyhedron: {
      const SupportFeature& b = pair.B->features[0];
      const ContactPoint at = pair.rule->meets == Meeting::smooth
                                  ? betweenSmooth(A, pair.A->features[0], B, b)
                                  : smoothOnPolyhedron(placedPolyhedron(A, *pair.A), B, b);
      return emit(pair, 0, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
    }
    case Meeting::smoothOnDisc: {
      const ContactPoint at = discOnSmooth(A, pair.A->features[0], discBody(B, *pair.B));
      return emit(pair, 0, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
    }
    default:
      return narrowOnSurface(pair, k, sink);
  }
}

void ShapeContacts::narrowOnSurface(const Pair& pair, const Kinematics& k,
                                    ContactSink& sink) const {
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  switch (pair.rule->meets) {
    case Meeting::ballOnSurface: {
      SurfaceContacts found;
      const double further = sink.request().refresh ? std::numeric_limits<double>::infinity()
                                                    : std::max(sink.request().gTol, 0.0);
      const RoundFeature& ball = pair.B->features[0];
      const int n = pair.A->surface->contacts(A, B, ball, 0.5 * ball.radius + further, found);
      if (!pair.A->polyhedron || !sink.request().refresh || n == 0)
        return emitAll(pair, found, n, k, sink);
      // The point nearest to the ball moves over a convex body without a jump. It is one contact,
      // whose gap can be followed.
      found[0] = *std::min_element(
          found.begin(), found.begin() + n,
          [](const SurfaceContact& a, const SurfaceContact& b) { return a.at.g < b.at.g; });
      found[0].id = pair.A->surface->features();
      return emitAll(pair, found, 1, k, sink);
    }
    case Meeting::capsuleOnSurface: {
      OnSurfaceContacts found;
      const int n = capsuleOnSurface(A, *pair.A->surface, B, *pair.B, seenFrom(pair, sink), found);
      return emitAll(pair, found, n, k, sink);
    }
    case Meeting::discOnMesh: {
      OnSurfaceContacts found;
      const int n =
          discOnMesh(A, *pair.A->surface, discBody(B, *pair.B), seenFrom(pair, sink), found);
      return emitAll(pair, found, n, k, sink);
    }
    case Meeting::smoothOnMesh: {
      OnSurfaceContacts found;
      const int n =
          smoothOnMesh(A, *pair.A->surface, B, pair.B->features[0], seenFrom(pair, sink), found);
      return emitAll(pair, found, n, k, sink);
    }
    case Meeting::polyhedronOnMesh: {
      OnSurfaceContacts found;
      return emitAll(pair, found,
                     polyhedronOnMesh(A, *pair.A->surface, placedPolyhedron(B, *pair.B),
                                      seenFrom(pair, sink), sink.request().bias, found),
                     k, sink);
    }
    default:
      return narrowFaceted(pair, k, sink);
  }
}

void ShapeContacts::narrowFaceted(const Pair& pair, const Kinematics& k, ContactSink& sink) const {
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  switch (pair.rule->meets) {
    case Meeting::discs:
    case Meeting::discOnPolyhedron: {
      DiscContacts found;
      const ContactRequest& asked = sink.request();
      const double reach = reachOf(pair, sink);
      const DiscBody b = discBody(B, *pair.B);
      const int n =
          pair.rule->meets == Meeting::discs
              ? betweenDiscs(discBody(A, *pair.A), b, reach, asked.gTol, asked.bias, found)
              : discOnPolyhedron(placedPolyhedron(A, *pair.A), b, reach, asked.gTol, asked.bias,
                                 found);
      return emitAll(pair, found, n, k, sink);
    }
    case Meeting::polyhedra: {
      PolyhedraContacts found;
      const PlacedPolyhedron a = placedPolyhedron(A, *pair.A);
      const ContactRequest& asked = sink.request();
      const double reach = reachOf(pair, sink);
      const int n = betweenPolyhedra(a, placedPolyhedron(B, *pair.B), reach, asked.bias, found);
      closeTogether(a, asked.gTol, asked.bias, {found.data(), static_cast<std::size_t>(n)});
      return emitAll(pair, found, n, k, sink);
    }
    case Meeting::boxes: {
      std::array<BoxContact, kMostBoxContacts> found;
      const PlacedBox a = placedBox(A, *pair.A);
      const ContactRequest& asked = sink.request();
      const int n = betweenBoxes(a, placedBox(B, *pair.B), asked.bias, found);
      closeTogether(a, asked.gTol, asked.bias, {found.data(), static_cast<std::size_t>(n)});
      return emitAll(pair, found, n, k, sink);
    }
    default:
      return narrowInPlane(pair, k, sink);
  }
}

/// The one contact of two shapes in a plane.
ContactPoint ShapeContacts::singleInPlane(const Pair& pair, const Frame& A, const Frame& B,
                                          const Vec3& plane) {
  const PlacedPolygon polygon{&A, &pair.A->polygon_K, plane};
  const SupportFeature &a = pair.A->features[0], &b = pair.B->features[0];
  switch (pair.rule->meets) {
    case Meeting::smoothInPlane:
      return smoothInPlane(A, a, B, b, plane);
    case Meeting::smoothOnPolygon:
      return smoothOnPolygon(polygon, B, b);
    case Meeting::capsuleOnSmooth:
      return capsuleOnSmooth(A, a, B, *pair.B, plane);
    case Meeting::ballOnPolygon:
      return ballOnPolygon(polygon, B, b);
    default:
      return ballOnContour(A, a, B, b, plane);
  }
}

void ShapeContacts::narrowInPlane(const Pair& pair, const Kinematics& k, ContactSink& sink) const {
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  const Vec3& plane = planes_[pair.rule->plane];
  const PlacedPolygon a{&A, &pair.A->polygon_K, plane}, b{&B, &pair.B->polygon_K, plane};
  switch (pair.rule->meets) {
    case Meeting::polygons: {
      PolygonContacts found;
      const ContactRequest& asked = sink.request();
      const double infinity = std::numeric_limits<double>::infinity();
      const int n = betweenPolygons(a, b, infinity, asked.bias, found);
      closeTogether(a, asked.gTol, asked.bias, {found.data(), static_cast<std::size_t>(n)});
      return emitAll(pair, found, n, k, sink);
    }
    case Meeting::capsuleOnPolygon: {
      CapsuleOnPolygon found;
      return emitAll(pair, found, capsuleOnPolygon(a, B, *pair.B, found), k, sink);
    }
    default: {
      const ContactPoint at = singleInPlane(pair, A, B, plane);
      return emit(pair, 0, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
    }
  }
}

template <class Found>
void ShapeContacts::emitAll(const Pair& pair, const Found& found, int n, const Kinematics& k,
                            ContactSink& sink) const {
  for (auto c = found.begin(); c != found.begin() + n; ++c)
    emit(pair, static_cast<std::size_t>(c->id), c->at.g, k, sink,
         [&]() -> const ContactPoint& { return c->at; });
}

void ShapeContacts::emitPoint(const Pair& pair, std::size_t feature, const ContactPoint& at,
                              const Kinematics& k, ContactSink& sink) const {
  emit(pair, feature, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
}

template <class At>
void ShapeContacts::emit(const Pair& pair, std::size_t feature, double g, const Kinematics& k,
                         ContactSink& sink, At&& closed) const {
  // Among many shapes only contacts that can close in the step are reported.
  if (g > reachOf(pair, sink)) return;
  ContactRows rows = sink.add(pair.id + feature, g, *pair.rule->law, pair.rule->rows);
  if (!rows) return;
  const ContactPoint& found = closed();
  const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
  ContactPoint turned;
  if (pair.rule->grain) {
    const bool ofA = !pair.A->grain_K.isZero(0.0);
    const Frame& f = ofA ? A : B;
    turned = found;
    alongGrain(turned, f.A_IK * (ofA ? pair.A : pair.B)->grain_K, f.Omega_I);
  }
  const ContactPoint& at = pair.rule->grain ? turned : found;
  const Vec3 rhoA = at.P - A.r_OS_I, rhoB = at.P - B.r_OS_I;
  if (rows.dim() <= 4) {
    pointContact(rows, A, rhoA, B, rhoB, at.d[0], at.d[1], at.d[2]);
    if (rows.wantsBias()) addBias(rows, at, A, B);
    return;
  }
  if (rows.dim() <= 6) {
    rollingContact(rows, A, rhoA, B, rhoB, at.d[0], at.d[1], at.d[2], nullptr);
    if (rows.wantsBias()) addBias(rows, at, A, B);
    return;
  }
  const ContourMotion contour(pair.B->features[feature], A, B, at, rows.wantsBias());
  rollingContact(rows, A, rhoA, B, rhoB, at.d[0], at.d[1], at.d[2], contour.c);
  if (!rows.wantsBias()) return;
  addBias(rows, at, A, B);
  for (int i = 0; i < 2; ++i)
    rows.bias(6 + i) =
        contour.cdot[i].dot(B.Omega_I - A.Omega_I) + contour.c[i].dot(B.bias_R_I - A.bias_R_I);
}

}  // namespace dynamy
