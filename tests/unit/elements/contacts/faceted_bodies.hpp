/// Bodies of triangles that move, and what their contacts are compared with: distances over all
/// pairs of vertices, faces and edges, rates by differences.
#pragma once
#include <dynamy/system/convex_hull.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/rotation.hpp>
#include <functional>
#include <random>
#include <vector>

namespace dynamy::testing {

inline Mat3 turned(const Vec3& theta) {
  double p[4] = {1, 0, 0, 0};
  rotate(p, theta);
  return rotationMatrix(p);
}

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double number() { return uniform_(random_); }
  Vec3 vec() { return {number(), number(), number()}; }
  /// Triangles of the hull of `n` points on a ball of radius 1.
  std::vector<Vec3> hull(int n) {
    std::vector<Vec3> points, out;
    for (int i = 0; i < n; ++i) points.push_back(vec().normalized());
    for (const Triangle& t : convexHull(points))
      for (const int i : t) out.push_back(points[static_cast<std::size_t>(i)]);
    return out;
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

/// A frame with a motion.
struct Mover {
  Frame frame;
  Mover(const Vec3& r, const Mat3& A, const Vec3& v = Vec3::Zero(),
        const Vec3& Omega = Vec3::Zero()) {
    frame.r_OS_I = r, frame.A_IK = A, frame.v_S_I = v, frame.Omega_I = Omega;
  }
  Mover after(double s) const {
    return {frame.r_OS_I + s * frame.v_S_I, turned(s * frame.Omega_I) * frame.A_IK, frame.v_S_I,
            frame.Omega_I};
  }
};

inline PlacedPolyhedron placed(const Frame& f, const Polyhedron& body) {
  return {&f, &body, f.r_OS_I, f.A_IK};
}
inline std::vector<Vec3> moved(const Frame& f, const std::vector<Vec3>& points) {
  std::vector<Vec3> out;
  for (const Vec3& p : points) out.push_back(f.r_OS_I + f.A_IK * p);
  return out;
}

/// Smallest distance, and whether it is between features that are contacts: a vertex and the inside
/// of a face, or the insides of two edges.
struct Distance {
  double value = kInfinity;
  bool isContact = false;
  void take(double d, bool contact) {
    // Of features that share the points the more special ones count.
    if (d < value - 1e-12) value = d, isContact = contact;
    if (d < value + 1e-9) isContact = isContact && contact;
  }
};

inline void vertexOnTriangle(const Vec3& p, const Vec3* t, Distance& out) {
  Mat3 axes;
  axes << t[1] - t[0], t[2] - t[0], (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  const Vec3 x = axes.inverse() * (p - t[0]);
  if (std::min({x[0], x[1], 1.0 - x[0] - x[1]}) > 1e-6) out.take(std::abs(x[2]), true);
}
inline void edgeOnEdgeOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                         Distance& out) {
  // Inside of both, else an end on the other.
  const Vec3 u = b - a, v = d - c, w = c - a;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), det = uu * vv - uv * uv;
  if (det > 1e-9 * uu * vv) {
    const double s = (u.dot(w) * vv - v.dot(w) * uv) / det,
                 t = (u.dot(w) * uv - v.dot(w) * uu) / det;
    // kCross: edges that are nearly parallel have no contact.
    if (std::min({s, t, 1.0 - s, 1.0 - t}) > 1e-6)
      out.take((a + s * u - c - t * v).norm(), det > 2.0 * kCross * kCross * uu * vv);
  }
  const auto end = [&](const Vec3& p, const Vec3& o, const Vec3& e) {
    const double s = std::clamp(e.dot(p - o) / e.dot(e), 0.0, 1.0);
    out.take((p - o - s * e).norm(), false);
  };
  end(a, c, v), end(b, c, v), end(c, a, u), end(d, a, u);
}
inline bool pierces(const Vec3& a, const Vec3& b, const Vec3* t) {
  Mat3 axes;
  axes << t[1] - t[0], t[2] - t[0], a - b;
  if (std::abs(axes.determinant()) < 1e-12) return false;
  const Vec3 x = axes.inverse() * (a - t[0]);
  return std::min({x[0], x[1], 1.0 - x[0] - x[1], x[2], 1.0 - x[2]}) > 0.0;
}
inline bool overlap(const std::vector<Vec3>& A, const std::vector<Vec3>& B) {
  for (std::size_t i = 0; i < A.size(); i += 3)
    for (std::size_t j = 0; j < B.size(); j += 3)
      for (std::size_t k = 0; k < 3; ++k)
        if (pierces(A[i + k], A[i + (k + 1) % 3], &B[j]) ||
            pierces(B[j + k], B[j + (k + 1) % 3], &A[i]))
          return true;
  return false;
}
/// Over all triangles of two surfaces that do not overlap.
inline Distance distance(const std::vector<Vec3>& A, const std::vector<Vec3>& B) {
  Distance out;
  for (std::size_t i = 0; i < A.size(); i += 3)
    for (std::size_t j = 0; j < B.size(); j += 3)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          edgeOnEdgeOf(A[i + k], A[i + (k + 1) % 3], B[j + l], B[j + (l + 1) % 3], out);
  for (std::size_t i = 0; i < A.size(); i += 3)
    for (const Vec3& p : B) vertexOnTriangle(p, &A[i], out);
  for (std::size_t j = 0; j < B.size(); j += 3)
    for (const Vec3& p : A) vertexOnTriangle(p, &B[j], out);
  return out;
}

using Pair = std::function<std::vector<NumberedContact>(const Frame& A, const Frame& B)>;

/// γ_N = ġ, Ṗ and the rates of the directions against central differences; returns how many.
inline int expectRatesFit(const Mover& A, const Mover& B, const Pair& pair) {
  constexpr double s = 1e-5;
  // s⁴ times fifth derivatives of up to (speed/0.05)⁵, and roundings over s.
  constexpr double kTolerance = 1e-6;
  const auto here = pair(A.frame, B.frame);
  std::vector<NumberedContact> at[4];
  constexpr double kPlace[4] = {-2.0, -1.0, 1.0, 2.0}, kWeight[4] = {1.0, -8.0, 8.0, -1.0};
  for (int i = 0; i < 4; ++i)
    at[i] = pair(A.after(kPlace[i] * s).frame, B.after(kPlace[i] * s).frame);
  int compared = 0;
  for (const NumberedContact& c : here) {
    const NumberedContact* same[4];
    bool all = true;
    for (int i = 0; i < 4; ++i) {
      const auto found = std::find_if(at[i].begin(), at[i].end(),
                                      [&](const NumberedContact& o) { return o.id == c.id; });
      all = all && found != at[i].end();
      same[i] = all ? &*found : nullptr;
    }
    // Crossings of nearly parallel edges run along them faster than differences can tell.
    if (!all || c.at.Pdot.norm() > 10.0) continue;
    ++compared;
    const auto rate = [&](auto&& of) {
      auto sum = of(same[0]->at);
      for (int i = 1; i < 4; ++i) sum += kWeight[i] * of(same[i]->at);
      sum /= 12.0 * s;
      return sum;
    };
    const Vec3 v =
        B.frame.velocity(c.at.P - B.frame.r_OS_I) - A.frame.velocity(c.at.P - A.frame.r_OS_I);
    const double gdot = rate([](const ContactPoint& p) { return p.g; });
    const Vec3 Pdot = rate([](const ContactPoint& p) { return Vec3(p.P); });
    EXPECT_NEAR(c.at.d[0].dot(v), gdot, kTolerance) << c.id;
    EXPECT_LT((c.at.Pdot - Pdot).norm(), 100.0 * kTolerance) << c.id;
    for (int k = 0; k < 3; ++k) {
      const Vec3 ddot = rate([k](const ContactPoint& p) { return Vec3(p.d[k]); });
      EXPECT_LT((c.at.ddot[k] - ddot).norm(), 100.0 * kTolerance) << c.id << ", direction " << k;
    }
  }
  return compared;
}

}  // namespace dynamy::testing
