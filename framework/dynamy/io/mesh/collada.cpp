#include <algorithm>
#include <cmath>
#include <dynamy/io/mesh/collada.hpp>
#include <dynamy/io/mesh/mesh_text.hpp>
#include <dynamy/io/xml/xml.hpp>
#include <stdexcept>

namespace dynamy {
namespace {

using Turn = Eigen::Affine3d;
constexpr double kMostInputs = 1000.0;

const XmlNode* childOf(const XmlNode& node, std::string_view tag) {
  for (const XmlNode& c : node.children)
    if (c.tag == tag) return &c;
  return nullptr;
}

std::string valueOf(const XmlNode& node, std::string_view attribute) {
  const XmlAttribute* a = node.attribute(attribute);
  return a == nullptr ? std::string() : a->value;
}

std::size_t countIn(const XmlNode& node, std::string_view attribute, std::size_t otherwise) {
  const std::string text = valueOf(node, attribute);
  if (text.empty()) return otherwise;
  const double x = MeshWords(text).number();
  if (!(x >= 0.0 && x < kMostInputs))
    throw std::runtime_error(std::string(attribute) + "=\"" + text + "\" is no number of an input");
  return static_cast<std::size_t>(x);
}

std::vector<double> numbersIn(const XmlNode& node) {
  std::vector<double> out;
  MeshWords words(node.text);
  while (!words.atEnd()) out.push_back(words.number());
  return out;
}

class ColladaReader {
 public:
  explicit ColladaReader(const XmlNode& root) {
    collect(root);
    Turn scale = Turn::Identity();
    if (const XmlNode* asset = childOf(root, "asset"))
      if (const XmlNode* unit = childOf(*asset, "unit"); unit && unit->attribute("meter"))
        scale.scale(MeshWords(valueOf(*unit, "meter")).number());
    const XmlNode* scenes = childOf(root, "library_visual_scenes");
    if (scenes == nullptr) {
      for (const auto& [id, node] : byId_)
        if (node->tag == "geometry") geometry(*node, scale);
      return;
    }
    const XmlNode* shown = childOf(root, "scene");
    if (shown != nullptr) shown = childOf(*shown, "instance_visual_scene");
    const XmlNode* scene =
        shown ? &named(valueOf(*shown, "url")) : childOf(*scenes, "visual_scene");
    if (scene != nullptr) nodesIn(*scene, scale, 0);
  }
  MeshBuilder out;

 private:
  void collect(const XmlNode& node) {
    if (const std::string id = valueOf(node, "id"); !id.empty()) byId_.try_emplace(id, &node);
    for (const XmlNode& c : node.children) collect(c);
  }
  /// The element that "#id" names.
  const XmlNode& named(const std::string& url) const {
    const auto at = byId_.find(url.empty() ? url : url.substr(1));
    if (at == byId_.end()) throw std::runtime_error("there is no element \"" + url + '"');
    return *at->second;
  }
  void nodesIn(const XmlNode& parent, const Turn& turn, int depth) {
    if (depth > kDeepest) throw std::runtime_error("its nodes contain each other");
    if (++nodes_ > kMostNodes) throw std::runtime_error("it has too many nodes");
    for (const XmlNode& c : parent.children) {
      if (c.tag == "node") nodesIn(c, turn * turnOf(c), depth + 1);
      if (c.tag == "instance_geometry") geometry(named(valueOf(c, "url")), turn);
      if (c.tag != "instance_node") continue;
      const XmlNode& node = named(valueOf(c, "url"));
      nodesIn(node, turn * turnOf(node), depth + 1);
    }
  }
  /// All transformations of a node, the first one outermost.
  static Turn turnOf(const XmlNode& node) {
    Turn all = Turn::Identity();
    for (const XmlNode& c : node.children) {
      const bool known =
          c.tag == "matrix" || c.tag == "translate" || c.tag == "rotate" || c.tag == "scale";
      if (!known) continue;
      const std::vector<double> x = numbersIn(c);
      if (x.size() != (c.tag == "matrix" ? 16U : c.tag == "rotate" ? 4U : 3U))
        throw std::runtime_error('<' + c.tag + "> has " + std::to_string(x.size()) + " numbers");
      const Vec3 v(x[0], x[1], x[2]);
      if (c.tag == "matrix")
        all = all * Turn(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(x.data()));
      if (c.tag == "translate") all.translate(v);
      if (c.tag == "scale") all.scale(v);
      if (c.tag == "rotate" && v.norm() > 0.0)
        all.rotate(Eigen::AngleAxisd(x[3] * std::acos(-1.0) / 180.0, v.normalized()));
    }
    return all;
  }
  void geometry(const XmlNode& node, const Turn& turn) {
    const XmlNode* mesh = childOf(node, "mesh");
    if (mesh == nullptr) return;
    for (const XmlNode& c : mesh->children)
      if (c.tag == "triangles" || c.tag == "polylist" || c.tag == "polygons") faces(c, turn);
  }
  /// Numbers in the mesh of the points that <vertices> lists.
  std::vector<int> pointsOf(const XmlNode& vertices, const Turn& turn) {
    for (const XmlNode& input : vertices.children) {
      if (input.tag != "input" || valueOf(input, "semantic") != "POSITION") continue;
      const XmlNode& source = named(valueOf(input, "source"));
      const XmlNode* numbers = childOf(source, "float_array");
      if (numbers == nullptr) throw std::runtime_error("corners have no numbers");
      const XmlNode* technique = childOf(source, "technique_common");
      const XmlNode* accessor = technique ? childOf(*technique, "accessor") : nullptr;
      const std::size_t stride = accessor ? countIn(*accessor, "stride", 1) : 3,
                        from = accessor ? countIn(*accessor, "offset", 0) : 0;
      const std::vector<double> x = numbersIn(*numbers);
      std::vector<int> all;
      for (std::size_t i = from; stride >= 3 && i + 2 < x.size(); i += stride)
        all.push_back(out.point(turn * Vec3(x[i], x[i + 1], x[i + 2])));
      return all;
    }
    throw std::runtime_error("<vertices> has no positions");
  }
  void faces(const XmlNode& node, const Turn& turn) {
    std::vector<int> points;
    std::size_t offset = 0, stride = 1;
    for (const XmlNode& input : node.children) {
      if (input.tag != "input") continue;
      const std::size_t own = countIn(input, "offset", 0);
      stride = std::max(stride, own + 1);
      if (valueOf(input, "semantic") != "VERTEX") continue;
      offset = own, points = pointsOf(named(valueOf(input, "source")), turn);
    }
    const bool mirrored = turn.linear().determinant() < 0.0;
    const XmlNode* vcount = node.tag == "polylist" ? childOf(node, "vcount") : nullptr;
    const std::vector<double> counts = vcount ? numbersIn(*vcount) : std::vector<double>();
    for (const XmlNode& p : node.children) {
      if (p.tag != "p") continue;
      const std::vector<double> entries = numbersIn(p);
      const std::size_t all = entries.size() / stride;
      std::size_t at = 0, face = 0;
      while (at < all) {
        const double corners = vcount ? (face < counts.size() ? counts[face] : 0.0)
                               : node.tag == "polygons" ? static_cast<double>(all)
                                                        : 3.0;
        ++face;
        if (!(corners >= 1.0) || static_cast<double>(at) + corners > static_cast<double>(all))
          throw std::runtime_error("its lists of corners do not fit together");
        std::vector<int> polygon;
        for (const std::size_t end = at + static_cast<std::size_t>(corners); at < end; ++at) {
          const double i = entries[at * stride + offset];
          if (!(i >= 0.0) || i >= static_cast<double>(points.size()))
            throw std::runtime_error("a face has the corner " + std::to_string(i));
          polygon.push_back(points[static_cast<std::size_t>(i)]);
        }
        if (mirrored) std::reverse(polygon.begin(), polygon.end());
        out.face(polygon);
      }
    }
  }
  static constexpr int kDeepest = 100, kMostNodes = 1'000'000;
  int nodes_ = 0;  // that were visited: one that is named twice is visited twice
  std::map<std::string, const XmlNode*, std::less<>> byId_;
};

}  // namespace

TriangleMesh readCollada(const std::filesystem::path& file) {
  const XmlDocument document = XmlDocument::read(file);
  if (document.root().tag != "COLLADA")
    throw std::runtime_error("its root is <" + document.root().tag + ">, not <COLLADA>");
  return std::move(ColladaReader(document.root()).out.mesh);
}

}  // namespace dynamy
