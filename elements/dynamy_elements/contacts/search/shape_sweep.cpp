#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/search/first_below.hpp>
#include <dynamy_elements/contacts/search/moving_frame.hpp>
#include <dynamy_elements/contacts/search/near_pairs.hpp>
#include <dynamy_elements/contacts/search/shape_sweep.hpp>

namespace dynamy {
namespace {

using SweptTouch = TouchingShape::Kind;

/// Overlap, as a part of the thickness, that does not matter. A ball whose overlap with another
/// stays below it would have been turned by less than sqrt(2e-6) = 0.08° of its velocity.
constexpr double kDepth = 1e-6;
/// The same of a contact that is closed at the start and does not open before it overlaps more: every
/// scheme sees it. A corner that slides on a turning body sinks in by ½ (ωΔt)² r on the straight
/// path: with kDepth it would be passed again and again, 300 times in a step.
constexpr double kLastingDepth = 1e-2;
/// Way by which such a contact opens, as a part of the thickness, before it counts as open.
constexpr double kOpened = 1e-4;
/// Least depth at which a passing is detected, in units of g_tol.
constexpr double kLeastDepth = 16.0;
/// Error of the instant of an impact, as a part of the depth at which a passing is detected.
constexpr double kTiming = 0.1;
/// Largest turn of one piece [rad].
constexpr double kLargestTurn = 0.5;
/// Most parts of a piece; within a part bodies are taken to move straight.
constexpr int kMostSweptParts = 64;
/// Most pieces of half a step: bodies that turn by more than a thousand
/// radians in it are resolved no further.
constexpr int kMostHalf = 2048;
/// Most parts of a piece if a gap is only known up to a reach, which a part must not exceed.
constexpr int kMostReaches = 4096;

/// Largest distance of a point of the shape that can touch from the origin of the frame [m].
double lever(const TouchingShape& s) {
  return s.p_K.norm() + (s.kind == SweptTouch::ball ? 0.0 : s.bound);
}

/// Displacement per angle that a turn of A's frame gives to a point of A that B may touch [m]. A
/// ball turns in place.
template <class Pose>
double leverOfA(const TouchingShape& a, const TouchingShape& b, const Pose& A, const Pose& B) {
  return a.kind == SweptTouch::ball ? lever(a) : (B.r_OS_I - A.r_OS_I).norm() + lever(b);
}

/// Lower bound of the distance of two shapes [m].
template <class Pose>
double apart(const TouchingShape& a, const TouchingShape& b, const Pose& A, const Pose& B) {
  const Vec3 r = B.r_OS_I + B.A_IK * b.p_K - A.r_OS_I - A.A_IK * a.p_K;
  const bool flat = a.kind == SweptTouch::halfSpace;
  return (flat ? r.dot(A.A_IK * a.n_K) : r.norm() - a.bound) - b.bound;
}

/// Both shapes on one piece of the path.
struct PairPiece {
  FramePiece a, b;
  double L;     ///< bound of the change of the gap
  double bend;  ///< bound of the second derivative of B's points, seen from A
  PairPiece(const TouchingShape& A, const TouchingShape& B, const SweptPath& path,
            const std::vector<Vec3>& turns, int k)
      : a(path, turns, A.frame, k), b(path, turns, B.frame, k) {
    const double go = (b.way() - a.way()).norm(), turnA = a.theta_K.norm(),
                 turnB = b.theta_K.norm(), leverB = lever(B), own = turnB * leverB;
    const bool round = A.kind == SweptTouch::ball;
    const double leverA = leverOfA(A, B, *a.a, *b.a) + (round ? 0.0 : go);
    L = go + turnA * leverA + own;
    bend = (round ? 0.0 : 2.0 * turnA * (go + own)) + turnA * turnA * leverA + turnB * own;
  }
};

/// Lower bound of the distance on one piece, from the balls about the origins of the frames that
/// enclose the shapes; −∞ over a half space that turns.
double clearance(const TouchingShape& A, const TouchingShape& B, const FramePiece& a,
                 const FramePiece& b) {
  const Vec3 r = b.a->r_OS_I - a.a->r_OS_I, way = b.way() - a.way();
  const double ofB = B.p_K.norm() + B.bound;
  if (A.kind == SweptTouch::halfSpace) {
    if (!a.theta_K.isZero(0.0)) return -kInfinity;
    const Vec3 n = a.a->A_IK * A.n_K;
    const double at = n.dot(r - a.a->A_IK * A.p_K);
    return std::min(at, at + n.dot(way)) - ofB;
  }
  const double square = way.squaredNorm();
  const double nearest = square > 0.0 ? std::clamp(-r.dot(way) / square, 0.0, 1.0) : 0.0;
  return (r + nearest * way).norm() - A.p_K.norm() - A.bound - ofB;
}

/// Where `gap` falls below `level` between a (above) and b (below).
template <class Gap>
double crossing(Gap& gap, double a, double b, double level, double width) {
  while (b - a > width) {
    const double m = 0.5 * (a + b);
    if (!(m > a && m < b)) break;
    (gap(m) < level ? b : a) = m;
  }
  return a;
}

double thickness(const TouchingShape& A, const TouchingShape& B) {
  return std::min(A.thickness, B.thickness);
}

}  // namespace

template <class F>
void ShapeSweep::forNearPairs(F&& f) {
  const int n = static_cast<int>(balls_.size());
  for (const int h : shapes_->halfSpaces())
    for (int i = 0; i < n; ++i)
      if (i != h && balls_[static_cast<std::size_t>(i)].radius >= 0.0)
        if (const TouchingPair pair = rules_->pair(h, i)) f(pair);
  for (const auto& [i, j] : nearPairs(broad_, broad_.near(balls_), *shapes_))
    if (const TouchingPair pair = rules_->pair(i, j)) f(pair);
}

int ShapeSweep::pieces(const Kinematics& k, double dt) {
  // Nothing to do if no two shapes together move further than the thickness of the thinnest.
  const std::vector<TouchingShape>& shapes = shapes_->inSpace();
  const auto way = [&](const TouchingShape& s) {
    const Frame& f = k.frame(s.frame);
    const double turn = f.Omega_I.norm();
    // A half space reaches everywhere.
    const double arm = s.kind == SweptTouch::halfSpace ? kInfinity : lever(s);
    return dt * (f.v_S_I.norm() + (turn > 0.0 ? turn * arm : 0.0));
  };
  double most = 0.0, second = 0.0;
  for (const TouchingShape& s : shapes) {
    if (k.frame(s.frame).rests()) continue;
    const double w = way(s);
    second = std::max(second, std::min(most, w)), most = std::max(most, w);
  }
  if (most + second <= shapes_->thinnest()) return 0;
  // Only pairs that are no further apart than twice their motion are tested below.
  balls_.clear();
  for (const TouchingShape& s : shapes) {
    const Frame& f = k.frame(s.frame);
    const bool out = s.kind == SweptTouch::halfSpace || f.absent;
    balls_.push_back({f.r_OS_I + f.A_IK * s.p_K, out ? -1.0 : s.bound + 2.0 * way(s)});
  }
  double turn = -1.0;
  forNearPairs([&](const TouchingPair& pair) {
    const double thick = thickness(*pair.A, *pair.B);
    const Frame &A = k.frame(pair.A->frame), &B = k.frame(pair.B->frame);
    const double both =
        dt * ((B.v_S_I - A.v_S_I).norm() + A.Omega_I.norm() * leverOfA(*pair.A, *pair.B, A, B) +
              B.Omega_I.norm() * lever(*pair.B));
    if (both <= thick || thick == kInfinity || apart(*pair.A, *pair.B, A, B) > 2.0 * both) return;
    for (const auto& [shape, frame] : {std::pair{pair.A, &A}, std::pair{pair.B, &B}})
      turn = std::max(turn, lever(*shape) > 0.0 ? frame->Omega_I.norm() * dt : 0.0);
  });
  // The number of pieces is even, since schemes change velocities at the midpoint.
  const double half = std::ceil(0.5 * turn / kLargestTurn);
  return turn < 0.0 ? 0 : 2 * (half < kMostHalf ? std::max(1, static_cast<int>(half)) : kMostHalf);
}

Passing ShapeSweep::firstPassing(const SweptPath& path, int element) {
  // Balls that enclose the shapes along the whole path.
  balls_.clear();
  for (const TouchingShape& s : shapes_->inSpace()) {
    double way = 0.0;
    const auto first = static_cast<std::size_t>(s.frame.index * path.pieces());
    turns_.resize(std::max(turns_.size(), first + static_cast<std::size_t>(path.pieces())));
    for (int piece = 0; piece < path.pieces(); ++piece) {
      turns_[first + static_cast<std::size_t>(piece)] = rotationVector(
          path.pose(s.frame, piece).A_IK.transpose() * path.pose(s.frame, piece + 1).A_IK);
      const FramePiece f(path, turns_, s.frame, piece);
      way += f.way().norm() + f.theta_K.norm() * (s.kind == SweptTouch::halfSpace ? 0.0 : lever(s));
    }
    const SweptPose& f = path.pose(s.frame, 0);
    const bool flat = s.kind == SweptTouch::halfSpace;
    balls_.push_back({f.r_OS_I + f.A_IK * s.p_K, flat ? -1.0 : s.bound + way});
  }
  Passing first;
  double work = 0.0;
  forNearPairs([&](const TouchingPair& pair) {
    const double thick = thickness(*pair.A, *pair.B);
    if (thick == kInfinity) return;
    double both = 0.0;
    for (int k = 0; k < path.pieces(); ++k) both += PairPiece(*pair.A, *pair.B, path, turns_, k).L;
    const SweptPose &A = path.pose(pair.A->frame, 0), &B = path.pose(pair.B->frame, 0);
    if (both <= thick || apart(*pair.A, *pair.B, A, B) > both) return;
    const std::size_t features = pair.rule->kernel->swept(*pair.B);
    for (std::size_t f = 0; f < features; ++f) {
      if (f < pair.B->features.size() && pair.B->features[f].flatOnly)
        continue;  // its rim is tested instead
      Passing p = passing(pair, f, path, first.t);
      p.contact = contactKey(element, pair.id + f);
      work += p.work;
      if (p.t < first.t) first = p;
    }
  });
  first.work = work;
  return first;
}

namespace {

/// Number of parts, a power of 2, of a piece. The parts are so short that paths of points deviate
/// from straight lines by a quarter of `depth`, and that nothing moves further than the largest gap
/// at which it is found, `seen` [m].
int partsOf(double seen, const PairPiece& piece, double depth) {
  const auto powerAbove = [](double wanted, int most) {
    int n = 1;
    while (n < wanted && n < most) n *= 2;
    return n;
  };
  return std::max(powerAbove(std::sqrt(piece.bend / (2.0 * depth)), kMostSweptParts),
                  powerAbove(2.0 * piece.L / seen, kMostReaches));
}

}  // namespace

Passing ShapeSweep::passing(const TouchingPair& pair, std::size_t f, const SweptPath& path,
                            double latest) const {
  const TouchingShape &a = *pair.A, &b = *pair.B;
  const double depth = std::max(kDepth * thickness(a, b), kLeastDepth * path.resolution());
  const double dt = path.dt() / path.pieces();
  const PairKernel& kernel = *pair.rule->kernel;
  Frame A, B;
  const PosedPair posed{a, b, A, B, shapes_->plane(pair.rule->plane)};
  double start = kInfinity, end = 0.0, highest = -kInfinity;  // gaps, the last one of pieces so far
  double work = 0.0;
  int after = -1;  // the piece at the begin of which the gap is `end`
  for (int k = 0; k < path.pieces() && dt * k < latest; ++k) {
    const PairPiece piece(a, b, path, turns_, k);
    if (clearance(a, b, piece.a, piece.b) > depth) continue;
    const MovingFrame moveA(piece.a), moveB(piece.b);
    auto gapAt = [&](double s) {
      work += pair.rule->work;
      moveA.at(s, A), moveB.at(s, B);
      return kernel.gap(posed, f);
    };
    const double left = k == after ? end : gapAt(0.0), right = gapAt(1.0);
    if (k == 0) start = left;
    after = k + 1, end = right;
    // A contact that is closed at the start must not overlap more.
    const bool closed = start <= depth;
    double limit = (closed ? start : 0.0) - depth;
    highest = std::max(highest, left);
    const double lasting = std::max(kLastingDepth * thickness(a, b), depth);
    const double opened = std::max(kOpened * thickness(a, b), depth);
    const double seen = kernel.seen(b);
    if (closed && std::max(highest, right) <= start + opened &&
        !FirstBelow{start - lasting, piece.L, 1.0 / partsOf(seen, piece, lasting),
                    0.25 * lasting / piece.L}
             .in(gapAt, 0.0, left, 1.0, right))
      continue;
    FirstBelow search{limit, piece.L, 1.0 / partsOf(seen, piece, depth), 0.25 * depth / piece.L};
    FirstBelow::Place below = search.in(gapAt, 0.0, left, 1.0, right);
    if (below && closed && std::max(highest, gapAt(0.5 * below.at)) <= start + opened) {
      search.limit = limit = start - lasting;
      below = search.in(gapAt, 0.0, left, 1.0, right);
    }
    if (below) {
      const double level = closed ? limit : 0.0, width = 0.1 * kTiming * depth / piece.L;
      const double s =
          below.value <= level ? below.from : crossing(gapAt, below.from, below.at, level, width);
      return {dt * (k + s), kTiming * depth / piece.L * dt, {}, work};
    }
  }
  Passing none;
  none.work = work;
  return none;
}

}  // namespace dynamy
