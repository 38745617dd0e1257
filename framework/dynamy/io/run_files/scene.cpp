#include <dynamy/io/run_files/scene.hpp>

namespace dynamy {
namespace {

const char* nameOf(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::sphere:
      return "sphere";
    case ShapeKind::box:
      return "box";
    case ShapeKind::capsule:
      return "capsule";
    case ShapeKind::cylinder:
      return "cylinder";
    case ShapeKind::circle:
      return "circle";
    case ShapeKind::halfspace:
      return "halfspace";
    case ShapeKind::segment:
      return "segment";
    case ShapeKind::polygon:
      return "polygon";
    case ShapeKind::ellipsoid:
      return "ellipsoid";
    case ShapeKind::torus:
      return "torus";
    case ShapeKind::cone:
      return "cone";
    case ShapeKind::mesh:
      return "mesh";
    case ShapeKind::link:
      return "link";
  }
  return "";
}

void write(JsonWriter& json, const SceneShape& shape) {
  using enum ShapeKind;
  json.beginObject().member("kind", nameOf(shape.kind));
  if (!shape.name.empty()) json.member("name", shape.name);
  json.member("frame", shape.frame);
  json.key("position").values(shape.position);
  json.key("orientation").values(shape.orientation);
  const bool isLong = shape.kind == capsule || shape.kind == cylinder || shape.kind == cone;
  // A sphere without radius is a point, drawn as a dot.
  if (shape.radius > 0 || shape.kind == sphere) json.member("radius", shape.radius);
  if (isLong) json.member("halfLength", shape.halfLength);
  if (shape.kind == torus) json.member("tube", shape.tube);
  if (shape.kind == box || shape.kind == ellipsoid)
    json.key("halfExtents").values(shape.halfExtents);
  if (!shape.points.empty()) {
    json.key("points").beginArray();
    for (const auto& point : shape.points) json.values(point);
    json.endArray();
  }
  if (!shape.triangles.empty()) {
    json.key("triangles").beginArray();
    for (const auto& triangle : shape.triangles) json.values(triangle);
    json.endArray();
  }
  if (shape.kind == link) json.member("frameEnd", shape.frameEnd);
  if (!shape.colour.empty()) json.member("colour", shape.colour);
  if (!shape.style.empty()) json.member("style", shape.style);
  json.endObject();
}

}  // namespace

void write(JsonWriter& json, const Scene& scene) {
  json.beginObject().member("view", scene.view);
  if (scene.follow >= 0) json.member("follow", scene.follow);
  json.key("frames").beginArray();
  for (const SceneFrame& frame : scene.frames) {
    json.beginObject().member("name", frame.name).member("place", frame.place).endObject();
  }
  json.endArray().key("shapes").beginArray();
  for (const SceneShape& shape : scene.shapes) write(json, shape);
  json.endArray().endObject();
}

}  // namespace dynamy
