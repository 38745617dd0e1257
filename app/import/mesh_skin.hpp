/// Meshes of a machine's file as shapes: a body touches by the convex hull of a mesh, or by convex
/// pieces of it, and is drawn as the mesh.
#pragma once
#include <dynamy/io/mesh/mesh_file.hpp>
#include <map>
#include <string>

#include "import/element_reader.hpp"
#include "import/import_options.hpp"

namespace dynamy::app {

/// Triangles of a mesh up to which it is drawn itself: a replay grows by some fifty bytes for each.
inline constexpr std::size_t kMostDrawn = 50000;

/// Is the shape of a picture or a contact, <geometry>, a mesh?
bool isOfMesh(const XmlNode& node);

/// Shapes without a colour get this one. Where meshes are drawn, the shapes that touch are hidden.
void drawMeshes(std::vector<Skin>& skins, const std::string& colour);

class MeshSkins {
 public:
  MeshSkins(ElementReader& read, const ImportOptions& options) : read_(read), options_(options) {}

  /// Makes `skin` the hull or pieces of the mesh file `name`, or the mesh itself if it does not touch. False
  /// with a note at `node` if it cannot be read.
  bool read(const XmlNode& node, const std::string& name, const Vec3& scale, Skin& skin);
  /// The mesh file, scaled; nullptr with a note. `why` it is not there otherwise.
  const TriangleMesh* mesh(const XmlNode& node, const std::string& name, const Vec3& scale);

 private:
  std::filesystem::path found(const std::string& name) const;
  bool cut(const XmlNode& node, const std::string& name, TriangleMesh mesh, Skin& skin);
  ElementReader& read_;
  const ImportOptions& options_;
  std::map<std::string, TriangleMesh> known_;
};

}  // namespace dynamy::app
