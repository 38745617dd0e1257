#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/search/shape_set.hpp>

namespace dynamy {
namespace {

using SetTouch = TouchingShape::Kind;

/// Throws ModelError unless all faces of a body of these triangles, three points each, have a
/// normal: none vanishes by underflow, none is lost by overflow.
void requireFaces(const Shape& shape, const std::vector<Vec3>& triangles) {
  bool good = !triangles.empty();
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const double area =
        (triangles[i + 1] - triangles[i]).cross(triangles[i + 2] - triangles[i]).norm();
    good = good && area > 0.0 && std::isfinite(area);
  }
  if (good) return;
  throw ModelError(Diagnostic{
      .place = shape.place(),
      .element = shape.type() + (shape.name().empty() ? "" : " name=\"" + shape.name() + "\""),
      .text = "its faces are too small, too thin or too large for contact",
      .hint = "take sizes of the same order, or give it no material"});
}

/// Shapes further apart than half their sizes are not reported.
double earlyReach(const TouchingShape& s) {
  // Boxes are searched where their circumscribed balls overlap.
  if (s.kind == SetTouch::box) return 0.0;
  return std::isfinite(s.thickness) ? 0.5 * s.thickness : 0.0;
}

}  // namespace

ShapeSet::ShapeSet(std::vector<ShapeInstance> instances, const Topology& topology,
                   const StartKinematics& start)
    : instances_(std::move(instances)), planes_{Vec3::Zero()}, shapes_(1) {
  for (const ShapeInstance& s : instances_) shapes_[0].push_back(touchingShape(s, Vec3::Zero()));
  makeSurfaces();
  std::vector<Blocks> blocks;
  for (const PartialMechanicalSystem* s : topology.systems()) blocks.push_back(s->blocks());
  const auto blocksOf = [&](std::size_t i) -> const Blocks& {
    return blocks[static_cast<std::size_t>(instances_[i].system)];
  };
  for (std::size_t i = 0; i < size(); ++i) planeNumber(blocksOf(i).planeNormal, start);
  const int systems = static_cast<int>(blocks.size());
  std::map<const NamedBody*, int> parts;  // bodies that are parts of a tree
  std::map<std::string, int> times;
  for (std::size_t i = 0; i < size(); ++i) {
    const ShapeInstance& s = instances_[i];
    const Blocks& of = blocksOf(i);
    const TouchingShape &space = shapes_[0][i],
                        &own = shapes_[planeNumber(of.planeNormal, start)][i];
    // A body is a system, one body of a population, or a part of a tree.
    const NamedBody* part = topology.names().body(
        s.system, topology.requestedFrames()[static_cast<std::size_t>(s.frame.index)].second);
    if (part)
      body_.push_back(parts.try_emplace(part, -2 - static_cast<int>(parts.size())).first->second);
    else
      body_.push_back(of.capacity == 1 ? s.system : systems + start.frame(s.frame).block);
    early_.push_back(std::max(earlyReach(space), earlyReach(own)));
    thinnest_ = std::min({thinnest_, space.thickness, own.thickness});
    if (space.kind == SetTouch::halfSpace) halfSpaces_.push_back(static_cast<int>(i));
    const std::string& carrier =
        part ? part->name : topology.systems()[static_cast<std::size_t>(s.system)]->name();
    nameShape(i, carrier, times);
    ground_.push_back(-1);
    if (of.nu > 0 || carrier.empty()) continue;
    const auto named = std::find(grounds_.begin(), grounds_.end(), carrier);
    ground_[i] = static_cast<int>(named - grounds_.begin());
    if (named == grounds_.end()) grounds_.push_back(carrier);
  }
}

/// `times`: how often each name occurs.
void ShapeSet::nameShape(std::size_t i, const std::string& carrier,
                         std::map<std::string, int>& times) {
  std::string name = instances_[i].shape->name();
  if (name.empty())
    name = carrier.empty() ? "body" + std::to_string(instances_[i].system) : carrier;
  if (const int count = ++times[name]; count > 1) name += "#" + std::to_string(count);
  names_.push_back(std::move(name));
}

/// Makes the surfaces of polyhedra and meshes, in axes of the frames that carry them. Also makes
/// the polyhedra and those of boxes; shapes that are equal share one.
void ShapeSet::makeSurfaces() {
  const auto faceted = [](const TouchingShape& s) {
    return s.kind == SetTouch::polyhedron || s.kind == SetTouch::surface;
  };
  std::map<std::vector<double>, const Polyhedron*> known;
  for (TouchingShape& s : shapes_[0]) {
    if (s.kind != SetTouch::polyhedron && !s.isBox(8)) continue;
    const std::vector<Vec3> triangles =
        s.kind == SetTouch::box ? boxTriangles(s.half) : s.shape->geometry().points;
    requireFaces(*s.shape, triangles);
    std::vector<double> key;
    for (const Vec3& p : triangles) key.insert(key.end(), p.begin(), p.end());
    const auto [at, isNew] = known.try_emplace(std::move(key), nullptr);
    if (isNew) {
      polyhedra_.push_back(std::make_unique<Polyhedron>(triangles));
      at->second = polyhedra_.back().get();
    }
    s.polyhedron = at->second;
  }
  for (TouchingShape& s : shapes_[0]) {
    if (!faceted(s)) continue;
    const ShapeGeometry g = s.shape->geometry();
    std::vector<Vec3> points;
    for (const Vec3& p : g.points) points.push_back(s.p_K + s.A_KB * p);
    surfaces_.push_back(std::make_unique<Surface>(points, g.type == ShapeType::polyhedron));
    s.surface = surfaces_.back().get();
  }
}

std::size_t ShapeSet::planeNumber(const Vec3& normal, const StartKinematics& start) {
  for (std::size_t p = 0; p < planes_.size(); ++p)
    if (planes_[p] == normal) return p;
  planes_.push_back(normal);
  shapes_.emplace_back();
  for (const ShapeInstance& s : instances_)
    shapes_.back().push_back(touchingShape(s, start.frame(s.frame).A_IK.transpose() * normal));
  for (TouchingShape& s : shapes_.back()) {
    if (s.kind != SetTouch::contour) continue;
    std::vector<double> radii;
    for (const Vec3& p : s.shape->geometry().points) radii.push_back(p.norm());
    contours_.push_back(std::make_unique<Contour>(std::move(radii)));
    s.features[0].contour = contours_.back().get();
  }
  return planes_.size() - 1;
}

}  // namespace dynamy
