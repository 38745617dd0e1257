/// What readers of mesh files share: triangles with common corners, and the words of a text.
#pragma once
#include <dynamy/io/mesh/mesh_file.hpp>
#include <map>
#include <string_view>
#include <tuple>

namespace dynamy {

/// Collects triangles; corners at equal places are one point.
class MeshBuilder {
 public:
  /// Number of the point in the mesh.
  int point(const Vec3& p);
  /// Triangles of a convex polygon; those with a repeated corner are left out.
  void face(const std::vector<int>& corners);
  TriangleMesh mesh;

 private:
  std::map<std::tuple<double, double, double>, int> known_;
};

/// Words of a text, separated by blanks and ends of lines.
class MeshWords {
 public:
  explicit MeshWords(std::string_view text) : text_(text) {}
  /// Next word; "" at the end.
  std::string_view next();
  /// \throws std::runtime_error if the next word is no number
  double number();
  Vec3 vector();
  bool atEnd();

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace dynamy
