// Distance at which each shape finds others, and near pairs that cannot
// touch within the step (theory 38.3).
#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/search/near_pairs.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Least distance at which a shape among many is found, as a part of its thickness.
constexpr double kAtRest = 0.05;
/// Most passes in which deflections are handed on from shape to shape.
constexpr int kMostSearches = 8;
/// Part of a deflection that is handed on.
constexpr double kShared = 0.5;

double restReach(const TouchingShape& s) {
  return std::isfinite(s.thickness) ? kAtRest * s.thickness : 0.0;
}

}  // namespace

/// Each shape is found within the distance that it moves while the fastest one moves by the requested
/// reach. A reach τ max |u| is thus τ (|v| + l |Ω|) for a single shape. If shapes are few, they are
/// found early besides, so that their gaps can be followed.
void NearPairs::lookAhead(const Kinematics& k, const ContactRequest& request) {
  const std::vector<TouchingShape>& shapes = shapes_->inSpace();
  const double all = std::max(request.gTol, 0.0);
  const bool few = !rules_->few().empty();
  tau_ = 0.0;
  if (few || request.refresh) {
    // Contacts that are to count as closed are searched at any distance.
    const double further = request.refresh ? std::numeric_limits<double>::infinity() : 0.0;
    for (std::size_t i = 0; i < shapes.size(); ++i) reach_[i] = shapes_->early(i) + further;
    if (request.refresh) return;
  }
  double fastest = 0.0;
  for (const int i : moving_) {
    const Frame& f = k.frame(shapes[static_cast<std::size_t>(i)].frame);
    fastest = std::max(fastest, f.v_S_I.norm() + f.Omega_I.norm());
  }
  const double tau = fastest > 0.0 ? all / fastest : 0.0;
  if (!few && all > kAtRest * shapes_->thinnest()) tau_ = tau;
  for (const int m : moving_) {
    const auto i = static_cast<std::size_t>(m);
    const TouchingShape& s = shapes[i];
    const Frame& f = k.frame(s.frame);
    const double arm = s.p_K.norm() + (s.kind == TouchingShape::Kind::ball ? 0.0 : s.bound);
    const double w = f.v_S_I.norm() + (std::isfinite(arm) ? arm : 0.0) * f.Omega_I.norm();
    // Where nothing moves yet, all is what forces add to velocities, of any body. For an endless
    // reach, τ is endless: a shape that rests still moves by nothing.
    const double moves = w > 0.0 ? std::min(tau * w, all) : 0.0;
    reach_[i] =
        (fastest > 0.0 ? moves : 0.5 * all) + std::max(restReach(s), few ? shapes_->early(i) : 0.0);
  }
}

/// Balls that move side by side or past each other do not touch, however fast they are: the
/// distance of convex shapes is a convex function of their shift. Hence g ≥ g_A + t ġ_A as long as
/// they move straight on without turning. In the time τ two of them close by τ max(0, −ġ_ij). The
/// deflection w_i, stored in turned_, is how far a shape may be thrown off its course:
///
///   w_i = max_j (τ max(0, −ġ_ij) − g_ij),   then   w_i ← max(w_i, (w_j − g_ij)/2)
///
/// A shape that is off its course by w_j moves the next one by w_j less their gap, and two equal
/// shapes that collide share this. Walls are not deflected. Pairs are left out if their
/// g_ij > τ max(0, −ġ_ij) + w_i + w_j. The factor 1/2 is a forecast, no bound: a body that is
/// pushed from behind hands on more. For this reason τ is twice the step. Other shapes than balls
/// and boxes count with all of their reach.
void NearPairs::followTurns(const Kinematics& k, const std::vector<BroadPhase::Pair>& near) {
  const std::vector<TouchingShape>& shapes = shapes_->inSpace();
  gap_.resize(near.size()), way_.resize(near.size());
  const auto moves = [&](std::size_t m) { return k.frame(shapes[m].frame).block >= 0; };
  for (std::size_t n = 0; n < near.size(); ++n) {
    const auto i = static_cast<std::size_t>(near[n].first),
               j = static_cast<std::size_t>(near[n].second);
    const Approach at = approach(k, i, j);
    gap_[n] = at.gap, way_[n] = std::min(reach_[i] + reach_[j], tau_ * std::max(0.0, -at.rate));
    for (const std::size_t m : {i, j})
      if (moves(m)) turned_[m] = std::max(turned_[m], way_[n] - gap_[n]);
  }
  bool again = true;
  for (int pass = 0; pass < kMostSearches && again; ++pass) {
    again = false;
    for (std::size_t n = 0; n < near.size(); ++n) {
      const auto i = static_cast<std::size_t>(near[n].first),
                 j = static_cast<std::size_t>(near[n].second);
      double &a = turned_[i], &b = turned_[j];
      const double gap = std::max(gap_[n], 0.0), toB = kShared * (a - gap);
      if (b < toB && moves(j)) b = toB, again = true;
      const double toA = kShared * (b - gap);
      if (a < toA && moves(i)) a = toA, again = true;
    }
  }
  for (std::size_t n = 0; n < near.size(); ++n)
    for (const int m : {near[n].first, near[n].second})
      way_[n] +=
          turned_[static_cast<std::size_t>(m)] + restReach(shapes[static_cast<std::size_t>(m)]);
}

/// Gap of two near shapes and its rate, or lower bounds of both.
NearPairs::Approach NearPairs::approach(const Kinematics& k, std::size_t i, std::size_t j) const {
  const TouchingShape &a = shapes_->inSpace()[i], &b = shapes_->inSpace()[j];
  const Frame &A = k.frame(a.frame), &B = k.frame(b.frame);
  if (a.isBall() && b.isBall()) {
    const Vec3 d = balls_[j].c - balls_[i].c;
    const double distance = d.norm();
    // Balls about the same point may approach in any direction.
    const Vec3 v = B.v_S_I - A.v_S_I;
    const double rate = distance > 0.0 ? d.dot(v) / distance : -v.norm();
    return {distance - a.bound - b.bound, rate};
  }
  const bool ballIsA = a.isBall();
  const TouchingShape &box = ballIsA ? b : a, &ball = ballIsA ? a : b;
  const Frame &F = ballIsA ? B : A, &ofBall = ballIsA ? A : B;
  if (ball.isBall() && box.kind == TouchingShape::Kind::box && rules_->touchInSpace(i, j) &&
      F.Omega_I.isZero(0.0)) {
    const Mat3 axes = F.A_IK * box.A_KB;
    const Vec3 c = axes.transpose() * (balls_[ballIsA ? i : j].c - balls_[ballIsA ? j : i].c);
    const Vec3 d = c - c.cwiseMax(-box.half).cwiseMin(box.half);
    if (const double distance = d.norm(); distance > 0.0)
      return {distance - ball.bound, (axes * d).dot(ofBall.v_S_I - F.v_S_I) / distance};
  }
  // Bounding balls may overlap by far: no shape is deflected further than it moves itself.
  const double apart = (balls_[j].c - balls_[i].c).norm() - a.bound - b.bound;
  return {std::max(apart, 0.0), -std::numeric_limits<double>::infinity()};
}

/// Lists the shapes that move, and places the others where they rest, whenever others rest.
void NearPairs::findResting(const Kinematics& k) {
  if (stamp_ == k.stamp()) return;
  stamp_ = k.stamp();
  const std::vector<TouchingShape>& shapes = shapes_->inSpace();
  moving_.clear(), resting_.clear();
  rests_.assign(shapes.size(), 0), balls_.resize(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Frame& f = k.frame(shapes[i].frame);
    rests_[i] = f.rests() ? 1 : 0;
    (f.rests() ? resting_ : moving_).push_back(static_cast<int>(i));
    if (f.rests()) balls_[i].c = centre(shapes[i], f), reach_[i] = restReach(shapes[i]);
  }
}

void NearPairs::place(const Kinematics& k, const ContactRequest& request) {
  findResting(k);
  lookAhead(k, request);
  const std::vector<TouchingShape>& shapes = shapes_->inSpace();
  for (const int m : moving_) {
    const auto i = static_cast<std::size_t>(m);
    const TouchingShape& s = shapes[i];
    const Frame& f = k.frame(s.frame);
    const bool bounded = std::isfinite(s.bound) && !f.absent;
    balls_[i] = {centre(s, f), bounded ? s.bound + reach_[i] : -1.0};
  }
  if (!resting_.empty()) placeResting();
  if (request.refresh) stamp_ = kUnknown;  // shapes at rest have seen further than they do
}

/// Leaves out the resting balls that are far from all moving ones. A half space that moves meets all.
void NearPairs::placeResting() {
  const std::vector<TouchingShape>& shapes = shapes_->inSpace();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  bool everywhere = false;
  for (const int i : moving_) {
    const BroadPhase::Ball& ball = balls_[static_cast<std::size_t>(i)];
    if (!std::isfinite(shapes[static_cast<std::size_t>(i)].bound)) everywhere = true;
    if (ball.radius < 0.0) continue;
    low = low.cwiseMin((ball.c.array() - ball.radius).matrix());
    high = high.cwiseMax((ball.c.array() + ball.radius).matrix());
  }
  for (const int r : resting_) {
    const auto i = static_cast<std::size_t>(r);
    const double bound = shapes[i].bound, radius = std::isfinite(bound) ? bound + reach_[i] : -1.0;
    const Vec3& c = balls_[i].c;
    const bool near =
        everywhere || ((c - low).minCoeff() >= -radius && (high - c).minCoeff() >= -radius);
    balls_[i].radius = near ? radius : -1.0;
  }
}

/// Centre of a shape's ball [m]. A shape without a finite place, in a trial step that was too long,
/// is near all others: pairs of features that are requested by key are still reported.
Vec3 NearPairs::centre(const TouchingShape& s, const Frame& f) const {
  const Vec3 c = f.r_OS_I + f.A_IK * s.p_K;
  return c.allFinite() ? c : Vec3(Vec3::Zero());
}

void NearPairs::placeOnPath(const Kinematics& start, const PathReach& reach) {
  const Vec3 everywhere = Vec3::Constant(std::numeric_limits<double>::infinity());
  boxes_.assign(shapes_->size(), {});
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const TouchingShape& s = shapes_->inSpace()[i];
    const Frame& f = start.frame(s.frame);
    if (!std::isfinite(s.bound) || f.absent) continue;
    const BroadPhase::Box box = reach.places(s.frame, centre(s, f), s.p_K.norm());
    const bool known = box.min().allFinite() && box.max().allFinite();
    const Vec3 bound = Vec3::Constant(s.bound);
    boxes_[i] = known ? BroadPhase::Box(box.min() - bound, box.max() + bound)
                      : BroadPhase::Box(-everywhere, everywhere);
  }
}

bool NearPairs::meetsOnPath(const Flat& flat, std::size_t h, std::size_t i,
                            const PathReach& reach) const {
  const BroadPhase::Box& box = boxes_[i];
  if (box.isEmpty()) return false;
  const TouchingShape& half = shapes_->inSpace()[h];
  // The corner of the box that is nearest to the plane, and the one that turning moves most.
  const Vec3 nearest = (flat.n.array() > 0.0).select(box.min(), box.max());
  const double arm = (box.min() - flat.A.r_OS_I)
                         .cwiseAbs()
                         .cwiseMax((box.max() - flat.A.r_OS_I).cwiseAbs())
                         .norm();
  return !(flat.n.dot(nearest - flat.p) > reach.way(half.frame, arm));
}

/// Can shape i touch the half space h? Then turned_ learns how far the half space throws it off.
bool NearPairs::meets(const Flat& flat, std::size_t h, std::size_t i, const Kinematics& k,
                      bool all) {
  const BroadPhase::Ball& ball = balls_[i];
  const double beyond = ball.radius + reach_[h] - flat.n.dot(ball.c - flat.p);
  if (flat.A.absent || ball.radius < 0.0 || (!all && beyond < 0.0)) return false;
  // A body that falls along a wall is not deflected by it.
  const TouchingShape& shape = shapes_->inSpace()[i];
  const double toIt = std::max(
      0.0, flat.n.dot(flat.A.velocity(ball.c - flat.A.r_OS_I) - k.frame(shape.frame).v_S_I));
  const double way = shape.isBall() ? std::min(reach_[i], tau_ * toIt) : reach_[i];
  turned_[i] = std::max(turned_[i], beyond - reach_[i] - reach_[h] + way);
  return true;
}

const std::vector<BroadPhase::Pair>& nearPairs(const BroadPhase& broad,
                                               const std::vector<BroadPhase::Pair>& near,
                                               const ShapeSet& shapes) {
  if (!broad.overfull()) return near;
  const auto name = [&](int i) { return shapes.name(static_cast<std::size_t>(i)); };
  throw ModelError("more than " + std::to_string(near.size() - 1) + " pairs of " +
                       std::to_string(shapes.size()) + " shapes are near each other, \"" +
                       name(near.back().first) + "\" and \"" + name(near.back().second) +
                       "\" are one: no step could take them all",
                   "do bodies start inside each other, or did one copy too many?");
}

}  // namespace dynamy
