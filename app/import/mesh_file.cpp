#include "import/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <dynamy/io/files/output_file.hpp>
#include <map>
#include <stdexcept>
#include <string_view>
#include <tuple>

namespace dynamy::app {
namespace {

/// Collects triangles; corners at equal places are one point.
class MeshBuilder {
 public:
  int point(const Vec3& p) {
    const auto [at, added] =
        known_.try_emplace(std::tuple(p.x(), p.y(), p.z()), static_cast<int>(mesh.points.size()));
    if (added) mesh.points.push_back(p);
    return at->second;
  }
  void triangle(int a, int b, int c) {
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  }
  TriangleMesh mesh;

 private:
  std::map<std::tuple<double, double, double>, int> known_;
};

/// Words of a text, line by line.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  /// Next word; "" at the end.
  std::string_view next() {
    while (at_ < text_.size() && space(text_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  double number() {
    const std::string_view word = next();
    const char* begin = word.data() + (!word.empty() && word[0] == '+' ? 1 : 0);
    double x = 0.0;
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), x);
    if (error != std::errc() || end != word.data() + word.size())
      throw std::runtime_error(fmt::format("\"{}\" is no number", word));
    return x;
  }
  Vec3 vector() {
    Vec3 out;
    for (double& x : out) x = number();
    return out;
  }
  bool empty() const { return at_ >= text_.size(); }

 private:
  static bool space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  std::string_view text_;
  std::size_t at_ = 0;
};

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
    int corner[3];
    for (int k = 0; k < 3; ++k)
      corner[k] = out.point(Vec3(v[3 * k + 3], v[3 * k + 4], v[3 * k + 5]));
    out.triangle(corner[0], corner[1], corner[2]);
  }
  return std::move(out.mesh);
}

TriangleMesh textStl(const std::string& text) {
  MeshBuilder out;
  Words words(text);
  std::vector<int> corners;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "vertex") corners.push_back(out.point(words.vector()));
    if (word != "endfacet") continue;
    if (corners.size() != 3) throw std::runtime_error("a facet has not three corners");
    out.triangle(corners[0], corners[1], corners[2]);
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
    throw std::runtime_error(fmt::format("a face has the corner \"{}\"", word));
  return index;
}

TriangleMesh obj(const std::string& text) {
  MeshBuilder out;
  std::vector<int> pointOf;  // corners at equal places are one point
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    Words words(std::string_view(text).substr(at, end - at));
    at = end + 1;
    const std::string_view kind = words.next();
    if (kind == "v") pointOf.push_back(out.point(words.vector()));
    if (kind != "f") continue;
    std::vector<int> face;
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      face.push_back(pointOf[static_cast<std::size_t>(objIndex(word, pointOf.size()))]);
    for (std::size_t k = 2; k < face.size(); ++k) out.triangle(face[0], face[k - 1], face[k]);
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
  return ending == ".stl" || ending == ".obj";
}

TriangleMesh readMesh(const std::filesystem::path& file) {
  const std::string ending = endingOf(file);
  if (!isMeshFile(file))
    throw std::runtime_error(fmt::format("files {} are not read, STL and OBJ are", ending));
  if (!std::filesystem::is_regular_file(file)) throw std::runtime_error("there is no such file");
  const std::string bytes = readWholeFile(file);
  TriangleMesh out = ending == ".obj"     ? obj(bytes)
                     : isBinaryStl(bytes) ? binaryStl(bytes)
                                          : textStl(bytes);
  if (out.triangles.empty()) throw std::runtime_error("it has no triangles");
  for (const Vec3& p : out.points)
    if (!p.allFinite()) throw std::runtime_error("a corner is not finite");
  return out;
}

Inertia enclosedInertia(const TriangleMesh& mesh) {
  // About a corner, so that rounding depends on the size of the mesh only.
  const Vec3 from = mesh.points.front();
  double V = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const auto& t : mesh.triangles) {
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = mesh.points[static_cast<std::size_t>(t[k])] - from;
    const double det = p[0].dot(p[1].cross(p[2]));
    const Vec3 s = p[0] + p[1] + p[2];
    V += det / 6.0;
    first += det / 24.0 * s;
    second += det / 120.0 *
              (s * s.transpose() + p[0] * p[0].transpose() + p[1] * p[1].transpose() +
               p[2] * p[2].transpose());
  }
  Inertia out;
  out.mass = V;
  const Vec3 c = first / V;
  const Mat3 central = second - V * c * c.transpose();
  out.centre = from + c;
  out.J = central.trace() * Mat3::Identity() - central;
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
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      runs[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  return std::all_of(runs.begin(), runs.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace dynamy::app
