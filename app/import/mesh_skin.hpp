/// Meshes of a machine's file as shapes: a moving body touches by the convex hull of a mesh.
#pragma once
#include <map>
#include <string>

#include "import/element_reader.hpp"
#include "import/import_options.hpp"
#include "import/mesh_file.hpp"

namespace dynamy::app {

/// The outermost of `points` in 168 directions.
std::vector<Vec3> outermostPoints(const std::vector<Vec3>& points);

/// The same, and how far others lie outside of a face of their hull at most [m].
std::vector<Vec3> extremePoints(const std::vector<Vec3>& points, double& inside);

class MeshSkins {
 public:
  MeshSkins(ElementReader& read, const ImportOptions& options) : read_(read), options_(options) {}

  /// Makes `skin` the hull of the mesh file `name`. False with a note at `node` if it cannot be read.
  bool read(const XmlNode& node, const std::string& name, const Vec3& scale, Skin& skin);
  /// The mesh file, scaled; nullptr with a note. `why` it is not there otherwise.
  const TriangleMesh* mesh(const XmlNode& node, const std::string& name, const Vec3& scale);

 private:
  std::filesystem::path found(const std::string& name) const;
  ElementReader& read_;
  const ImportOptions& options_;
  std::map<std::string, TriangleMesh> known_;
};

}  // namespace dynamy::app
