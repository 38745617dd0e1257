/// Shapes and mass properties of a link of SDF.
#pragma once
#include "import/mesh_skin.hpp"

namespace dynamy::app {

class SdfShapes {
 public:
  SdfShapes(ElementReader& read, const ImportOptions& options)
      : read_(read), meshes_(read, options) {}

  /// Inertia of `<inertial>`, in axes of the link.
  Inertia inertia(const XmlNode& node);
  /// Shapes of all `<collision>` of a link, or of its `<visual>` if there is none.
  std::vector<Skin> skins(const XmlNode& link);

 private:
  /// "#rrggbb" of a picture's material, or "".
  std::string colour(const XmlNode& node);
  bool skin(const XmlNode& node, Skin& out);
  bool geometry(const XmlNode& shape, Skin& out);
  double size(const XmlNode& shape, const char* name);
  Vec3 sizes(const XmlNode& shape, const char* name);
  void surface(const XmlNode& node, Skin& out);

  ElementReader& read_;
  MeshSkins meshes_;
};

}  // namespace dynamy::app
