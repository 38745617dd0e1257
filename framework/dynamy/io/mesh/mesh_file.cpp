#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/mesh/collada.hpp>
#include <dynamy/io/mesh/mesh_file.hpp>
#include <dynamy/io/mesh/mesh_text.hpp>
#include <dynamy/io/mesh/ply.hpp>
#include <map>
#include <stdexcept>
#include <string_view>
#include <tuple>

namespace dynamy {
namespace {

constexpr std::size_t kStlHead = 84, kStlTriangle = 50;

std::uint32_t countOf(const std::string& bytes) {
  std::uint32_t n = 0;
  std::memcpy(&n, bytes.data() + kStlHead - 4, 4);
  return n;
}

bool isBinaryStl(const std::string& bytes) {
  static_assert(std::endian::native == std::endian::little, "STL has its lowest byte first");
  return bytes.size() >= kStlHead && bytes.size() >= kStlHead + kStlTriangle * countOf(bytes);
}

TriangleMesh binaryStl(const std::string& bytes) {
  MeshBuilder out;
  const std::uint32_t n = countOf(bytes);
  for (std::uint32_t i = 0; i < n; ++i) {
    float v[12];  // normal and three corners
    std::memcpy(v, bytes.data() + kStlHead + kStlTriangle * i, sizeof(v));
    std::vector<int> corners;
    for (int k = 1; k < 4; ++k)
      corners.push_back(out.point(Vec3(v[3 * k], v[3 * k + 1], v[3 * k + 2])));
    out.face(corners);
  }
  return std::move(out.mesh);
}

TriangleMesh textStl(const std::string& text) {
  MeshBuilder out;
  MeshWords words(text);
  std::vector<int> corners;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "vertex") corners.push_back(out.point(words.vector()));
    if (word != "endfacet") continue;
    if (corners.size() != 3) throw std::runtime_error("a facet has not three corners");
    out.face(corners);
    corners.clear();
  }
  return std::move(out.mesh);
}

/// Index of a corner "7/1/3" from 0; negative ones count from the end.
int objIndex(std::string_view word, std::size_t points) {
  int i = 0;
  const std::string_view first = word.substr(0, word.find('/'));
  const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), i);
  const int n = static_cast<int>(points);
  const int index = i < 0 ? n + i : i - 1;
  if (error != std::errc() || end != first.data() + first.size() || index < 0 || index >= n)
    throw std::runtime_error("a face has the corner \"" + std::string(word) + '"');
  return index;
}

TriangleMesh obj(const std::string& text) {
  MeshBuilder out;
  std::vector<int> pointOf;  // corners at equal places are one point
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    MeshWords words(std::string_view(text).substr(at, end - at));
    at = end + 1;
    const std::string_view kind = words.next();
    if (kind == "v") pointOf.push_back(out.point(words.vector()));
    if (kind != "f") continue;
    std::vector<int> face;
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      face.push_back(pointOf[static_cast<std::size_t>(objIndex(word, pointOf.size()))]);
    out.face(face);
  }
  return std::move(out.mesh);
}

std::string endingOf(const std::filesystem::path& file) {
  std::string out = file.extension().string();
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

bool isMeshFile(const std::filesystem::path& file) {
  const std::string ending = endingOf(file);
  return ending == ".stl" || ending == ".obj" || ending == ".ply" || ending == ".dae";
}

TriangleMesh readMesh(const std::filesystem::path& file) {
  const std::string ending = endingOf(file);
  if (!isMeshFile(file))
    throw std::runtime_error("files " + ending + " are not read, STL, OBJ, PLY and DAE are");
  if (!std::filesystem::is_regular_file(file)) throw std::runtime_error("there is no such file");
  const std::string bytes = ending == ".dae" ? std::string() : readWholeFile(file);
  TriangleMesh out = ending == ".dae"     ? readCollada(file)
                     : ending == ".obj"   ? obj(bytes)
                     : ending == ".ply"   ? readPly(bytes)
                     : isBinaryStl(bytes) ? binaryStl(bytes)
                                          : textStl(bytes);
  if (out.triangles.empty()) throw std::runtime_error("it has no triangles");
  return out;
}

MassProperties enclosed(const TriangleMesh& mesh) {
  // About a corner, so that rounding depends on the size of the mesh only.
  std::vector<Vec3> points = mesh.points;
  for (Vec3& p : points) p -= mesh.points.front();
  MassProperties out = enclosed(points, mesh.triangles);
  out.centre_B += mesh.points.front();
  return out;
}

Eigen::AlignedBox3d extentOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d out;
  for (const auto& t : mesh.triangles)
    for (const int i : t) out.extend(mesh.points[static_cast<std::size_t>(i)]);
  return out;
}

bool closed(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> runs;  // along an edge, minus those back
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      runs[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  return std::all_of(runs.begin(), runs.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace dynamy
