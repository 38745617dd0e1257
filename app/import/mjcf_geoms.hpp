/// Geoms and assets of MJCF: shapes with their contact and their mass.
#pragma once
#include <map>
#include <set>
#include <string>

#include "import/mesh_skin.hpp"
#include "import/mjcf_settings.hpp"

namespace dynamy::app {

/// A geom as shape and as mass.
struct MjcfGeom {
  bool shows = false;  ///< there is a shape
  Skin skin;
  Inertia inertia;  ///< in axes of its body; mass 0: none
};

class MjcfGeoms {
 public:
  MjcfGeoms(ElementReader& read, const MjcfCompiler& compiler, const MjcfDefaults& defaults,
            const ImportOptions& options)
      : read_(read), compiler_(compiler), defaults_(defaults), meshes_(read, options) {}

  /// Materials and meshes of an `<asset>`.
  void assets(const XmlNode& node);
  /// `node`: with the attributes of its class.
  MjcfGeom geom(const XmlNode& node);
  /// "#rrggbb" of rgba or the material.
  std::string colour(const XmlNode& node);

 private:
  struct Mesh {
    XmlNode node;
    std::string path;
    Vec3 scale = Vec3::Ones();
    Pose reference;
  };
  void meshAsset(const XmlNode& node);
  bool mesh(const XmlNode& node, MjcfGeom& out);
  void sizes(const XmlNode& node, const std::string& type, Skin& skin);
  void contact(const XmlNode& node, Skin& skin);
  double mass(const XmlNode& node, double volume);

  ElementReader& read_;
  const MjcfCompiler& compiler_;
  const MjcfDefaults& defaults_;
  MeshSkins meshes_;
  std::map<std::string, std::string> colours_;
  std::map<std::string, Mesh> files_;
};

}  // namespace dynamy::app
