#include "import/convex_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/system/convex_hull.hpp>
#include <limits>
#include <set>
#include <tuple>

#include "import/extreme_points.hpp"
#include "import/machine.hpp"

namespace dynamy::app {
namespace {

constexpr int kColumns = 256;       ///< along x and y, of the volume within a box
constexpr int kMostCorners = 8;     ///< planes across an axis that go through corners
constexpr double kAtBorder = 0.02;  ///< part of a box at its ends in which it is not cut
constexpr double kEnough = 0.01;    ///< excess of all pieces over the volume
constexpr double kBeside = 1e-7;    ///< of the way from a corner to the middle of its box
constexpr double kLeast = 1e-9;     ///< volume of a piece over that of the solid
constexpr int kMostOfPiece = 64;    ///< corners of a piece, up to which it has all of its hull
/// Share of the difference in volume of two parts that counts like excess: of equal cuts the more
/// equal one is taken.
constexpr double kUneven = 1e-3;

using Polygon = std::vector<Vec3>;

using Box = Eigen::AlignedBox3d;

/// Part of a convex polygon with x_axis ≤ at, or ≥ at for `above`.
Polygon clipped(const Polygon& p, int axis, double at, bool above) {
  const auto inside = [&](const Vec3& v) { return above ? v[axis] >= at : v[axis] <= at; };
  Polygon out;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 &a = p[i], &b = p[(i + 1) % p.size()];
    if (inside(a)) out.push_back(a);
    if (inside(a) == inside(b) || a[axis] == at || b[axis] == at) continue;
    Vec3 c = a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a);
    c[axis] = at;
    out.push_back(c);
  }
  return out;
}

/// The solid as its parts above points of a grid in x and y.
class Columns {
 public:
  Columns(const TriangleMesh& mesh, const Box& box)
      : low_(box.min()), width_(box.sizes() / kColumns) {
    crossings_.resize(kColumns * kColumns);
    for (const auto& t : mesh.triangles) add(mesh, t);
    for (auto& c : crossings_) std::sort(c.begin(), c.end());
  }
  /// Volume within a box [m³].
  double within(const Box& box) const {
    double sum = 0.0;
    for (int i = 0; i < kColumns; ++i) {
      const double x = overlap(0, i, box);
      for (int j = 0; j < kColumns && x > 0.0; ++j)
        if (const double y = overlap(1, j, box); y > 0.0) sum += x * y * length(i, j, box);
    }
    return sum;
  }

 private:
  void add(const TriangleMesh& mesh, const std::array<int, 3>& t) {
    const Vec3 &a = mesh.points[at(t[0])], &b = mesh.points[at(t[1])], &c = mesh.points[at(t[2])];
    const Vec3 n = (b - a).cross(c - a);
    const auto first = [&](int k) {
      const double x = std::min({a[k], b[k], c[k]});
      return std::clamp(static_cast<int>(std::floor((x - low_[k]) / width_[k] - 0.5)), 0, kColumns);
    };
    const auto past = [&](int k) {
      const double x = std::max({a[k], b[k], c[k]});
      return std::clamp(static_cast<int>(std::floor((x - low_[k]) / width_[k] + 0.5)) + 1, 0,
                        kColumns);
    };
    for (int i = first(0); i < past(0); ++i)
      for (int j = first(1); j < past(1); ++j) {
        const Vec3 p(low_.x() + (i + 0.5) * width_.x(), low_.y() + (j + 0.5) * width_.y(), 0.0);
        // Seen from above, p is on the same side of all three edges. Of points on an edge the half
        // open rule gives each to one of its two triangles.
        const int s = side(a, b, p);
        if (s == 0 || s != side(b, c, p) || s != side(c, a, p)) continue;
        const double z = a.z() - (n.x() * (p.x() - a.x()) + n.y() * (p.y() - a.y())) / n.z();
        crossings_[at(i * kColumns + j)].push_back(z);
      }
  }
  static int side(const Vec3& a, const Vec3& b, const Vec3& p) {
    // The same number for an edge from both of its sides.
    const bool turned = std::pair(b.x(), b.y()) < std::pair(a.x(), a.y());
    const Vec3 &from = turned ? b : a, &to = turned ? a : b;
    const double s =
        (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
    const int sign = s >= 0.0 ? 1 : -1;
    return turned ? -sign : sign;
  }
  double overlap(int axis, int i, const Box& box) const {
    const double from = low_[axis] + i * width_[axis];
    return std::min(from + width_[axis], box.max()[axis]) - std::max(from, box.min()[axis]);
  }
  double length(int i, int j, const Box& box) const {
    const std::vector<double>& z = crossings_[at(i * kColumns + j)];
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < z.size(); k += 2)
      sum += std::max(0.0, std::min(z[k + 1], box.max().z()) - std::max(z[k], box.min().z()));
    return sum;
  }
  Vec3 low_, width_;
  std::vector<std::vector<double>> crossings_;
};

/// Is p inside of the mesh? By the solid angle of all triangles [van Oosterom, Strackee 1983].
bool isInside(const TriangleMesh& mesh, const Vec3& p) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.points[at(t[0])] - p, b = mesh.points[at(t[1])] - p,
               c = mesh.points[at(t[2])] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2.0 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return std::abs(sum) > 2.0 * kPi;
}

/// The solid within a box, and its hull.
struct Piece {
  Box box;
  std::vector<Polygon> surface;
  std::vector<Vec3> points;  ///< corners of the surface and of the box, which the hull is of
  double volume = 0.0, hull = 0.0;
  double excess() const { return std::max(0.0, hull - volume); }
};

class Cutter {
 public:
  Cutter(const TriangleMesh& mesh, double volume)
      : mesh_(mesh), volume_(volume), box_(extentOf(mesh)), columns_(mesh, box_) {
    scale_ = volume / columns_.within(box_);
  }
  std::vector<Piece> pieces(int most) {
    std::vector<Polygon> all;
    for (const auto& t : mesh_.triangles)
      all.push_back({mesh_.points[at(t[0])], mesh_.points[at(t[1])], mesh_.points[at(t[2])]});
    std::vector<Piece> out{made(box_, std::move(all))};
    while (static_cast<int>(out.size()) < most) {
      double excess = 0.0;
      for (const Piece& p : out) excess += p.excess();
      if (excess <= kEnough * volume_) break;
      const auto worst =
          std::max_element(out.begin(), out.end(),
                           [](const Piece& a, const Piece& b) { return a.excess() < b.excess(); });
      std::pair<Piece, Piece> parts = best(*worst);
      *worst = std::move(parts.first);
      out.push_back(std::move(parts.second));
    }
    return out;
  }

 private:
  Piece made(const Box& box, std::vector<Polygon> surface) const {
    Piece out{box, std::move(surface), {}, 0.0, 0.0};
    std::vector<Vec3>& points = out.points;
    for (const Polygon& p : out.surface) points.insert(points.end(), p.begin(), p.end());
    const auto key = [](const Vec3& v) { return std::tuple(v.x(), v.y(), v.z()); };
    std::sort(points.begin(), points.end(),
              [&](const Vec3& a, const Vec3& b) { return key(a) < key(b); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    // A plane through a place of the surface may put a corner of the box on it: whether the solid
    // reaches that corner is seen beside it, inside of the box.
    for (int k = 0; k < 8; ++k) {
      const Vec3 corner = box.corner(static_cast<Box::CornerType>(k));
      if (isInside(mesh_, corner + kBeside * (box.center() - corner))) points.push_back(corner);
    }
    out.volume = scale_ * columns_.within(box);
    if (points.size() < 4) return out;
    const std::vector<Vec3> outermost = outermostPoints(points);
    out.hull = enclosed(outermost, convexHull(outermost)).volume;
    return out;
  }
  std::pair<Piece, Piece> cut(const Piece& p, int axis, double at) const {
    std::vector<Polygon> below, above;
    for (const Polygon& polygon : p.surface) {
      // A face in the plane bounds what lies behind it.
      if (std::all_of(polygon.begin(), polygon.end(),
                      [&](const Vec3& v) { return v[axis] == at; })) {
        const Vec3 n = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]);
        (n[axis] > 0.0 ? below : above).push_back(polygon);
        continue;
      }
      for (const bool up : {false, true})
        if (Polygon part = clipped(polygon, axis, at, up); part.size() > 2)
          (up ? above : below).push_back(std::move(part));
    }
    Box low = p.box, high = p.box;
    low.max()[axis] = high.min()[axis] = at;
    return {made(low, std::move(below)), made(high, std::move(above))};
  }
  std::pair<Piece, Piece> best(const Piece& p) const {
    std::pair<Piece, Piece> out;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      for (const double at : places(p, axis)) {
        std::pair<Piece, Piece> parts = cut(p, axis, at);
        const double cost = parts.first.excess() + parts.second.excess() +
                            kUneven * std::abs(parts.first.volume - parts.second.volume);
        if (cost < least) least = cost, out = std::move(parts);
      }
    return out;
  }
  /// Where planes across an axis may cut a piece.
  static std::vector<double> places(const Piece& p, int axis) {
    const double low = p.box.min()[axis], high = p.box.max()[axis],
                 border = kAtBorder * (high - low);
    std::vector<double> corners, out;
    for (const Polygon& polygon : p.surface)
      for (const Vec3& v : polygon)
        if (v[axis] > low + border && v[axis] < high - border) corners.push_back(v[axis]);
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end(),
                              [&](double a, double b) { return b - a < 1e-6 * (high - low); }),
                  corners.end());
    const std::size_t n = corners.size(), taken = std::min<std::size_t>(n, kMostCorners);
    for (std::size_t k = 0; k < taken; ++k) out.push_back(corners[(2 * k + 1) * n / (2 * taken)]);
    for (const double part : {0.25, 0.5, 0.75}) out.push_back(low + part * (high - low));
    return out;
  }

  const TriangleMesh& mesh_;
  double volume_, scale_ = 1.0;
  Box box_;
  Columns columns_;
};

std::vector<Vec3> hullCorners(const std::vector<Vec3>& points) {
  std::set<int> used;
  for (const Triangle& t : convexHull(points)) used.insert(t.begin(), t.end());
  std::vector<Vec3> out;
  for (const int i : used) out.push_back(points[at(i)]);
  return out;
}

}  // namespace

std::string ConvexPieces::text(double size) const {
  const std::size_t n = corners.size();
  const std::string percent = fmt::format("{:.1f}", 100.0 * std::abs(excess));
  return fmt::format(
      "{} convex piece{}, together {}; {}", n, n == 1 ? "" : "s",
      percent == "0.0"
          ? "of its volume"
          : percent + (excess < 0.0 ? " % smaller than its volume" : " % larger than its volume"),
      inside > 1e-9 * size ? fmt::format("their faces are at most {:.2g} m inside of it", inside)
                           : "they contain it");
}

void turnOutwards(TriangleMesh& mesh) {
  if (enclosed(mesh).volume < 0.0)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

ConvexPieces convexPieces(const TriangleMesh& mesh, int most) {
  ConvexPieces out;
  out.volume = std::abs(enclosed(mesh).volume);
  double all = 0.0;
  for (Piece& p : Cutter(mesh, out.volume).pieces(most)) {
    if (!(p.hull > kLeast * out.volume)) continue;
    double inside = 0.0;
    std::vector<Vec3> corners = hullCorners(p.points);
    if (static_cast<int>(corners.size()) > kMostOfPiece) corners = extremePoints(p.points, inside);
    all += enclosed(corners, convexHull(corners)).volume;
    out.inside = std::max(out.inside, inside);
    out.corners.push_back(std::move(corners));
  }
  out.excess = all / out.volume - 1.0;
  return out;
}

}  // namespace dynamy::app
