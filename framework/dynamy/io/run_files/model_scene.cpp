#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/io/run_files/model_scene.hpp>
#include <dynamy/simulation/report/recorder.hpp>
#include <dynamy/system/smooth_shape.hpp>
#include <map>

namespace dynamy {
namespace {

constexpr double kThinRing = 0.015;  ///< least thickness of a drawn torus, of its radius
/// Sides of the outline of a smooth shape, and of each one of a heap: a mesh has 100 kB.
constexpr int kSmoothSides = 64, kCoarseSides = 24;
constexpr std::ptrdiff_t kHeap = 50;

std::array<double, 3> array(const Vec3& v) { return {v[0], v[1], v[2]}; }

SceneFrame frameOf(const Model& model, const DrawnFrame& f) {
  const PartialMechanicalSystem& system = *model.systems()[static_cast<std::size_t>(f.system)];
  const NamedBody* body = model.topology().names().body(f.system, f.id);
  std::string name = system.name().empty() ? system.type() : system.name();
  if (body) name = body->name;
  if (body ? body->frames > 1 : system.frames() > 1) {
    std::string part = std::to_string(f.id - (body ? body->frame : 0));
    for (const auto& [label, id] : model.description(f.system).frames)
      if (id == f.id) part = label;
    name += "." + part;
  }
  const Place& place = body ? body->place : system.place();
  return {name, place.line > 0 ? place.file + ":" + std::to_string(place.line) : ""};
}

ShapeKind drawnAs(ShapeType type) {
  switch (type) {
    case ShapeType::point:
    case ShapeType::sphere:
      return ShapeKind::sphere;
    case ShapeType::circle:
      return ShapeKind::circle;
    case ShapeType::line:
      return ShapeKind::segment;
    case ShapeType::polygon:
    case ShapeType::contour:
      return ShapeKind::polygon;
    case ShapeType::box:
      return ShapeKind::box;
    case ShapeType::cylinder:
      return ShapeKind::cylinder;
    case ShapeType::capsule:
      return ShapeKind::capsule;
    case ShapeType::cone:
      return ShapeKind::cone;
    case ShapeType::torus:
      return ShapeKind::torus;
    case ShapeType::ellipsoid:
      return ShapeKind::ellipsoid;
    case ShapeType::polyhedron:
    case ShapeType::mesh:
      return ShapeKind::mesh;
    case ShapeType::halfSpace:
      return ShapeKind::halfspace;
    case ShapeType::bore:
      return ShapeKind::mesh;
  }
  return ShapeKind::segment;
}

/// Kind and sizes of a shape; for a half-space `turn` rotates its z axis onto the normal.
SceneShape geometryOf(const ShapeGeometry& g, Eigen::Quaterniond& turn) {
  SceneShape s;
  s.kind = drawnAs(g.type);
  s.colour = g.colour;
  switch (s.kind) {
    case ShapeKind::sphere:
    case ShapeKind::circle:
      s.radius = g.size[0];
      break;
    case ShapeKind::cylinder:
    case ShapeKind::capsule:
    case ShapeKind::cone:
      s.radius = g.size[0], s.halfLength = 0.5 * g.size[1];
      break;
    case ShapeKind::box:
      s.halfExtents = {0.5 * g.size[0], 0.5 * g.size[1], 0.5 * g.size[2]};
      break;
    case ShapeKind::ellipsoid:
      s.halfExtents = {g.size[0], g.size[1], g.size[2]};
      break;
    case ShapeKind::torus:
      // A circle without thickness is drawn as a thin ring.
      s.radius = g.size[0], s.tube = std::max(g.size[1], kThinRing * g.size[0]);
      break;
    case ShapeKind::halfspace:
      if (!g.points.empty()) turn.setFromTwoVectors(Vec3::UnitZ(), g.points.front());
      break;
    default:
      for (const Vec3& p : g.points) s.points.push_back(array(p));
      for (int i = 0; s.kind == ShapeKind::mesh && i + 2 < static_cast<int>(s.points.size());
           i += 3)
        s.triangles.push_back({i, i + 1, i + 2});
  }
  return s;
}

/// The points x(d) of a smooth shape for directions d on circles about its z axis, with triangles.
SceneShape smoothMesh(const SmoothShape& shape, int sides) {
  SceneShape s;
  s.kind = ShapeKind::mesh, s.colour = shape.colour();
  const int rings = sides / 2;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < (i % rings == 0 ? 1 : sides); ++j) {
      const double polar = kPi * i / rings, around = kTwoPi * j / sides;
      s.points.push_back(array(shape.point({std::sin(polar) * std::cos(around),
                                            std::sin(polar) * std::sin(around), std::cos(polar)})));
    }
  const auto at = [&](int i, int j) {  // of ring i; the first and the last one are a point
    if (i == 0) return 0;
    return i == rings ? 1 + (rings - 1) * sides : 1 + (i - 1) * sides + j % sides;
  };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sides; ++j) {
      if (i + 1 < rings) s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      if (i > 0) s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return s;
}

void addLinks(const Model& model, const std::vector<DrawnFrame>& drawn, Scene& scene) {
  std::map<std::pair<int, int>, int> index;
  for (std::size_t k = 0; k < drawn.size(); ++k)
    index.try_emplace({drawn[k].system, drawn[k].id}, static_cast<int>(k));
  // Index of the frame with handle `f` among the drawn frames; −1: it is not drawn.
  const auto drawnIndex = [&](int f) {
    const auto at = index.find(model.topology().requestedFrames()[static_cast<std::size_t>(f)]);
    return at == index.end() ? -1 : at->second;
  };
  for (const Description& d : model.descriptions())
    for (const PlacedLink& l : d.links) {
      SceneShape s;
      s.kind = ShapeKind::link;
      s.frame = drawnIndex(l.frameA), s.frameEnd = drawnIndex(l.frameB);
      s.points = {array(l.pointA), array(l.pointB)};
      if (l.spring) s.style = "spring";
      scene.shapes.push_back(std::move(s));
    }
}

}  // namespace

Scene modelScene(const Model& model) {
  Scene scene;
  scene.view = model.view;
  const std::vector<DrawnFrame> frames = drawnFrames(model);
  std::multimap<std::pair<int, int>, const PlacedShape*> placed;  // in order of the shapes
  for (std::size_t i = 0; i < model.systems().size(); ++i)
    for (const PlacedShape& p : model.description(static_cast<int>(i)).shapes)
      placed.emplace(std::pair(static_cast<int>(i), p.frame), &p);
  // Others have a geometry of their own: an ellipsoid.
  const auto isMesh = [](const PlacedShape& p) {
    return p.shape->smooth() != nullptr && p.shape->geometry().type == ShapeType::polyhedron;
  };
  const auto meshes = std::count_if(placed.begin(), placed.end(),
                                    [&](const auto& entry) { return isMesh(*entry.second); });
  const int sides = meshes < kHeap ? kSmoothSides : kCoarseSides;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    scene.frames.push_back(frameOf(model, frames[k]));
    const std::string& name = scene.frames.back().name;
    if (scene.follow < 0 && !model.record.follow.empty() &&
        (name == model.record.follow || name.starts_with(model.record.follow + ".")))
      scene.follow = static_cast<int>(k);
    const auto range = placed.equal_range({frames[k].system, frames[k].id});
    for (auto at = range.first; at != range.second; ++at) {
      const PlacedShape& p = *at->second;
      Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
      SceneShape s =
          isMesh(p) ? smoothMesh(*p.shape->smooth(), sides) : geometryOf(p.shape->geometry(), turn);
      const Eigen::Quaterniond A = Eigen::Quaterniond(p.shape->A_KB()) * turn;
      s.name = p.shape->name();
      s.frame = static_cast<int>(k);
      s.position = array(p.shape->r_SB_K());
      s.orientation = {A.w(), A.x(), A.y(), A.z()};
      scene.shapes.push_back(std::move(s));
    }
  }
  addLinks(model, frames, scene);
  return scene;
}

}  // namespace dynamy
