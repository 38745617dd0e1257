#include "export/scene_mesh.hpp"

#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/css_colour.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace dynamy::app {
namespace {

using Vector = Eigen::Vector3d;

constexpr std::array<std::array<std::uint8_t, 3>, 6> kColours{
    {{51, 92, 103}, {224, 159, 62}, {158, 42, 43}, {84, 110, 84}, {107, 91, 149}, {120, 120, 120}}};

Vector vectorOf(const JsonValue& v) {
  Vector out = Vector::Zero();
  for (std::size_t i = 0; i < 3 && i < v.items.size(); ++i)
    out[static_cast<int>(i)] = v.items[i].value;
  return out;
}

/// A point of the half plane that turns about the local z.
struct Profile {
  double r = 0.0, z = 0.0;
};

/// Adds shapes to a mesh.
class Mesher {
 public:
  Mesher(SceneMesh& mesh, long frames, int sides, double reach)
      : mesh_(mesh), frames_(frames), sides_(sides), reach_(reach) {}

  void add(const JsonValue& shape, std::int32_t index) {
    const int frame = frameOf(shape["frame"]);
    part_ = {index, frame, colourOf(shape["colour"].text, frame)};
    position_ = vectorOf(shape["position"]);
    const auto& w = shape["orientation"].items;
    turn_ = w.size() == 4 ? Eigen::Quaterniond(w[0].value, w[1].value, w[2].value, w[3].value)
                          : Eigen::Quaterniond::Identity();
    const std::string& kind = shape["kind"].text;
    if (kind == "segment" || kind == "polygon" || kind == "mesh" || kind == "link")
      ofPoints(shape, kind);
    else
      ofNumbers(shape, kind);
  }

 private:
  static constexpr long kMost = std::numeric_limits<std::int32_t>::max();
  /// A frame of the scene, or -1 where a shape stands still.
  int frameOf(const JsonValue& number) const {
    const std::optional<long> frame = number.whole(-1, frames_ - 1);
    if (!frame) throw std::runtime_error("frames.bin: a shape moves with a frame that it has not");
    return static_cast<int>(*frame);
  }
  static std::array<std::uint8_t, 3> colourOf(const std::string& text, int frame) {
    if (const std::optional<Rgb> given = cssColour(text)) return *given;
    return kColours[static_cast<std::size_t>(frame + 1) % kColours.size()];
  }

  std::int32_t point(const Vector& inShape) {
    mesh_.points.emplace_back(position_ + turn_ * inShape);
    mesh_.frame.push_back(part_.frame);
    return static_cast<std::int32_t>(mesh_.points.size()) - 1;
  }
  void polygon(SceneMesh::Cell cell) {
    mesh_.polygons.push_back(std::move(cell));
    mesh_.polygonParts.push_back(part_);
  }
  void line(SceneMesh::Cell cell) {
    mesh_.lines.push_back(std::move(cell));
    mesh_.lineParts.push_back(part_);
  }

  /// Lines, areas and triangles through given points.
  void ofPoints(const JsonValue& shape, const std::string& kind) {
    SceneMesh::Cell all;
    for (const JsonValue& p : shape["points"].items) all.push_back(point(vectorOf(p)));
    if (all.empty()) return;
    if (kind == "polygon") polygon(all);
    if (kind == "segment") line(all);
    if (kind == "link" && all.size() == 2) {
      // Both ends are given in the axes of their frames.
      mesh_.points.back() = vectorOf(shape["points"].items[1]);
      mesh_.frame.back() = frameOf(shape["frameEnd"]);
      line(all);
    }
    for (const JsonValue& t : shape["triangles"].items) {
      SceneMesh::Cell cell;
      for (const JsonValue& i : t.items)
        cell.push_back(all.at(static_cast<std::size_t>(i.whole(0, kMost).value_or(kMost))));
      polygon(std::move(cell));
    }
  }

  void ofNumbers(const JsonValue& shape, const std::string& kind) {
    const double radius = shape["radius"].value, half = shape["halfLength"].value;
    const Vector extents = vectorOf(shape["halfExtents"]);
    if (kind == "box") box(extents);
    if (kind == "halfspace") square();
    if (kind == "sphere" && radius > 0.0) surface(round(radius, 0.0), Vector::Ones());
    if (kind == "ellipsoid") surface(round(1.0, 0.0), extents);
    if (kind == "capsule") surface(round(radius, half), Vector::Ones());
    if (kind == "cylinder")
      surface({{0.0, -half}, {radius, -half}, {radius, half}, {0.0, half}}, Vector::Ones());
    if (kind == "cone") surface({{0.0, 0.0}, {radius, 0.0}, {0.0, 2.0 * half}}, Vector::Ones());
    if (kind == "circle") polygon(ring({radius, 0.0}, Vector::Ones()));
    if (kind == "torus") {
      std::vector<Profile> profile;
      for (int i = 0; i <= sides_; ++i)
        profile.push_back({radius + shape["tube"].value * std::cos(angle(i)),
                           shape["tube"].value * std::sin(angle(i))});
      surface(profile, Vector::Ones());
    }
  }

  double angle(int i) const { return 2.0 * kPi * (i % sides_) / sides_; }

  /// A half circle from below to above, its halves `half` apart from the middle.
  std::vector<Profile> round(double radius, double half) const {
    std::vector<Profile> out;
    const int n = std::max(sides_ / 4, 1);
    for (int i = -n; i <= n; ++i) {
      const double a = 0.5 * kPi * i / n, r = radius * std::cos(a), z = radius * std::sin(a);
      if (i <= 0) out.push_back({i == -n ? 0.0 : r, z - half});
      if (i >= 0 && (i > 0 || half > 0.0)) out.push_back({i == n ? 0.0 : r, z + half});
    }
    return out;
  }

  SceneMesh::Cell ring(const Profile& p, const Vector& scale) {
    SceneMesh::Cell out;
    for (int i = 0; i < (p.r > 0.0 ? sides_ : 1); ++i)
      out.push_back(point(
          Vector(p.r * std::cos(angle(i)), p.r * std::sin(angle(i)), p.z).cwiseProduct(scale)));
    return out;
  }

  /// A profile turned about the local z; the normals point outwards where z rises along it.
  void surface(const std::vector<Profile>& profile, const Vector& scale) {
    SceneMesh::Cell below = ring(profile.front(), scale);
    for (std::size_t k = 1; k < profile.size(); ++k) {
      SceneMesh::Cell above = ring(profile[k], scale);
      const auto at = [&](const SceneMesh::Cell& r, int i) {
        return r[static_cast<std::size_t>(i) % r.size()];
      };
      for (int i = 0; i < sides_; ++i) {
        SceneMesh::Cell cell{at(below, i)};
        if (below.size() > 1) cell.push_back(at(below, i + 1));
        if (above.size() > 1) cell.push_back(at(above, i + 1));
        cell.push_back(at(above, i));
        if (cell.size() > 2) polygon(std::move(cell));
      }
      below = std::move(above);
    }
  }

  void box(const Vector& e) {
    std::array<std::int32_t, 8> p{};
    for (unsigned i = 0; i < 8; ++i)
      p[i] = point({(i & 1u) != 0 ? e.x() : -e.x(), (i & 2u) != 0 ? e.y() : -e.y(),
                    (i & 4u) != 0 ? e.z() : -e.z()});
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
          std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
      polygon({p[static_cast<std::size_t>(a)], p[static_cast<std::size_t>(b)],
               p[static_cast<std::size_t>(c)], p[static_cast<std::size_t>(d)]});
  }

  void square() {
    polygon({point({-reach_, -reach_, 0.0}), point({reach_, -reach_, 0.0}),
             point({reach_, reach_, 0.0}), point({-reach_, reach_, 0.0})});
  }

  SceneMesh& mesh_;
  long frames_;
  int sides_;
  double reach_;
  SceneMesh::Part part_;
  Vector position_ = Vector::Zero();
  Eigen::Quaterniond turn_ = Eigen::Quaterniond::Identity();
};

}  // namespace

SceneMesh sceneMesh(const JsonValue& scene, std::size_t frames, int sides, double reach) {
  SceneMesh out;
  Mesher mesher(out, static_cast<long>(frames), sides, reach);
  std::int32_t index = 0;
  for (const JsonValue& shape : scene["shapes"].items) mesher.add(shape, index++);
  return out;
}

std::vector<Eigen::Vector3d> placed(const SceneMesh& mesh, const Frames& frames, std::size_t f) {
  std::vector<Eigen::Vector3d> out(mesh.points.size());
  const float* poses = frames.pose.data() + f * frames.poses * Frames::kPoseNumbers;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = mesh.points[i];
    if (mesh.frame[i] < 0) continue;
    const float* p = poses + static_cast<std::size_t>(mesh.frame[i]) * Frames::kPoseNumbers;
    const Eigen::Quaterniond turn(p[3], p[4], p[5], p[6]);
    out[i] = Eigen::Vector3d(p[0], p[1], p[2]) + turn.normalized() * mesh.points[i];
  }
  return out;
}

}  // namespace dynamy::app
