#include <algorithm>
#include <cmath>
#include <dynamy/system/convex_hull.hpp>
#include <dynamy_elements/contacts/shapes/polyhedron.hpp>
#include <limits>
#include <map>
#include <set>

namespace dynamy {
namespace {

/// Sine of the angle between triangles up to which they count as coplanar.
constexpr double kOnePlane = 1e-9;

}  // namespace

Polyhedron::Polyhedron(const std::vector<Vec3>& triangles) {
  // Corners at the same place are merged.
  std::map<std::array<double, 3>, int> known;
  std::vector<Triangle> all;
  std::vector<Vec3> points, normals;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = triangles[i + k];
      const auto [at, isNew] =
          known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(points.size()));
      if (isNew) points.push_back(p);
      t[k] = at->second;
    }
    const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
    all.push_back(t);
    normals.push_back((at(1) - at(0)).cross(at(2) - at(0)).normalized());
  }
  corners_ = points;
  // Coplanar triangles form a polygon; sides that two of them share are inside of it.
  std::vector<bool> taken(all.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (taken[i]) continue;
    std::set<std::array<int, 2>> sides;
    Vec3 n = Vec3::Zero();
    for (std::size_t j = i; j < all.size(); ++j) {
      if (taken[j] || normals[i].dot(normals[j]) < 0.0 ||
          normals[i].cross(normals[j]).norm() > kOnePlane)
        continue;
      taken[j] = true, n += normals[j];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array<int, 2> side{all[j][k], all[j][(k + 1) % 3]};
        if (!sides.erase({side[1], side[0]})) sides.insert(side);
      }
    }
    addFace(n.normalized(), {sides.begin(), sides.end()});
  }
  findEdges();
  measure();
}

/// Adds a face. `sides`: its directed sides, in any order.
void Polyhedron::addFace(const Vec3& n, const std::vector<std::array<int, 2>>& sides) {
  std::map<int, int> next;
  for (const auto& s : sides) next[s[0]] = s[1];
  Face f;
  f.n = n, f.first = static_cast<int>(borders_.size());
  f.height = -std::numeric_limits<double>::infinity();
  int at = next.begin()->first;
  for (std::size_t i = 0; i < next.size(); ++i, at = next[at]) {
    Border b;
    b.corner = at;
    b.out = (corner(next[at]) - corner(at)).cross(n).normalized();
    borders_.push_back(b);
    f.height = std::max(f.height, n.dot(corner(at)));
    ++f.count;
  }
  faces_.push_back(f);
}

void Polyhedron::findEdges() {
  std::map<std::array<int, 2>, int> sides;  // directed: border
  std::vector<int> faceOf(borders_.size()), next(borders_.size());
  facesAt_.resize(corners_.size()), neighbours_.resize(corners_.size());
  halfWidth_ = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    for (int i = 0; i < face.count; ++i) {
      const auto b = static_cast<std::size_t>(face.first + i);
      faceOf[b] = static_cast<int>(f);
      next[b] = border(face.first + (i + 1) % face.count).corner;
      sides[{borders_[b].corner, next[b]}] = static_cast<int>(b);
      facesAt_[static_cast<std::size_t>(borders_[b].corner)].push_back(static_cast<int>(f));
      neighbours_[static_cast<std::size_t>(borders_[b].corner)].push_back(next[b]);
    }
    double lowest = face.height;
    for (const Vec3& p : corners_) lowest = std::min(lowest, face.n.dot(p));
    halfWidth_ = std::min(halfWidth_, 0.5 * (face.height - lowest));
  }
  for (std::size_t b = 0; b < borders_.size(); ++b) {
    const int from = borders_[b].corner, to = next[b];
    const auto other = sides.find({to, from});
    if (from > to || other == sides.end()) continue;
    Edge e;
    e.f = faceOf[b], e.g = faceOf[static_cast<std::size_t>(other->second)];
    e.middle = 0.5 * (corner(from) + corner(to));
    e.e = (corner(to) - corner(from)).normalized(),
    e.half = 0.5 * (corner(to) - corner(from)).norm();
    if (face(e.f).n.cross(face(e.g).n).dot(e.e) < 0.0) std::swap(e.f, e.g);
    borders_[b].edge = borders_[static_cast<std::size_t>(other->second)].edge =
        static_cast<int>(edges_.size());
    edges_.push_back(e);
  }
}

void Polyhedron::measure() {
  for (const Vec3& p : corners_) cornerColumns_.add(p), radius_ = std::max(radius_, p.norm());
  for (const Face& f : faces_) normalColumns_.add(f.n);
  for (const Vec3& p : corners_) middle_ += p / static_cast<double>(corners_.size());
  const auto along = [this](const Vec3& m, int f) {
    const double length = m.norm();
    together_ = std::min(together_, length > 0.0 ? std::max(m.dot(face(f).n) / length, 0.0) : 0.0);
  };
  for (const Edge& e : edges_)
    for (const int f : {e.f, e.g}) along(face(e.f).n + face(e.g).n, f);
  for (const std::vector<int>& around : facesAt_) {
    Vec3 sum = Vec3::Zero();
    for (const int f : around) sum += face(f).n;
    for (const int f : around) along(sum, f);
  }
}

bool Polyhedron::over(const Face& f, const Vec3& p, double beside) const {
  for (int i = f.first; i < f.first + f.count; ++i)
    if (border(i).out.dot(p - corner(border(i).corner)) > beside) return false;
  return true;
}

std::vector<Vec3> boxTriangles(const Vec3& half) {
  std::vector<Vec3> corners, out;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                         i & 4 ? half.z() : -half.z());
  for (const Triangle& t : convexHull(corners))
    for (const int i : t) out.push_back(corners[static_cast<std::size_t>(i)]);
  return out;
}

}  // namespace dynamy
