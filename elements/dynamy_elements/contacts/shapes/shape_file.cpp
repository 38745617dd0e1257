#include <dynamy/core/error.hpp>
#include <dynamy_elements/contacts/shapes/shape_file.hpp>
#include <stdexcept>

namespace dynamy {

void declareShapeFile(Attributes& a, const char* points) {
  Attribute& p = a.add(AttributeType::vector, "points", std::nullopt, points);
  p.unit = Unit::length, p.size = 0;
  p.mayBeAbsent();
  a.add(AttributeType::text, "file", std::nullopt,
        "instead of points: a mesh file (STL, OBJ, PLY, DAE), its path counted from this file")
      .mayBeAbsent();
  a.vector("scale", Unit::none, 0, "1",
           "metres of a unit of the mesh file (0.001 for mm), or three numbers along its axes")
      .notZero();
}

std::vector<Vec3> triples(const ParameterValue& value, const char* what, std::size_t least) {
  const std::size_t n = value.numbers.size();
  if (n % 3 != 0 || n < 3 * least)
    throw value.fault("a list of at least " + std::to_string(least) + " " + what +
                          " with three numbers each is needed",
                      "here are " + std::to_string(n) + " numbers", 0, value.text.size());
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < n; i += 3)
    out.emplace_back(value.numbers[i], value.numbers[i + 1], value.numbers[i + 2]);
  return out;
}

bool readShapeFile(const Parameters& x, TriangleMesh& mesh) {
  if (x.has("points") == x.has("file"))
    throw ModelError("either points or a file has to be given", "file=\"part.stl\"");
  const ParameterValue& scale = x["scale"];
  if (x.has("points")) {
    if (scale.given)
      throw scale.fault("is for a mesh file; points are in metres", "points=\"0 0 20mm …\"", 0,
                        scale.text.size());
    return false;
  }
  const ParameterValue& file = x["file"];
  if (scale.numbers.size() != 1 && scale.numbers.size() != 3)
    throw scale.fault("one number or three are needed", "scale=\"0.001\"", 0, scale.text.size());
  const std::filesystem::path path = file.existingFile();
  try {
    mesh = readMesh(path);
  } catch (const std::runtime_error& e) {
    throw file.fault(e.what(), "", 0, file.text.size());
  }
  const Vec3 s = scale.numbers.size() == 1 ? Vec3::Constant(scale.numbers[0]).eval() : scale.vec3();
  for (Vec3& p : mesh.points) p = p.cwiseProduct(s);
  if (s.prod() < 0.0)  // a mirror turns the corners of triangles the other way round
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return true;
}

}  // namespace dynamy
