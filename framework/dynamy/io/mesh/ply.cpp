#include <algorithm>
#include <bit>
#include <cstring>
#include <dynamy/io/mesh/mesh_text.hpp>
#include <dynamy/io/mesh/ply.hpp>
#include <optional>
#include <stdexcept>

namespace dynamy {
namespace {

enum class Number : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

Number numberOf(std::string_view word) {
  constexpr std::pair<std::string_view, Number> kWords[] = {
      {"char", Number::int8},      {"int8", Number::int8},       {"uchar", Number::uint8},
      {"uint8", Number::uint8},    {"short", Number::int16},     {"int16", Number::int16},
      {"ushort", Number::uint16},  {"uint16", Number::uint16},   {"int", Number::int32},
      {"int32", Number::int32},    {"uint", Number::uint32},     {"uint32", Number::uint32},
      {"float", Number::float32},  {"float32", Number::float32}, {"double", Number::float64},
      {"float64", Number::float64}};
  for (const auto& [name, number] : kWords)
    if (name == word) return number;
  throw std::runtime_error("its head has a number of type \"" + std::string(word) + '"');
}

struct Property {
  std::string name;
  Number type = Number::float32;
  std::optional<Number> count = {};  ///< type of the number of entries; none: no list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

/// Numbers behind the head, of a text or of bytes.
class Body {
 public:
  Body(std::string_view bytes, std::string_view format)
      : bytes_(bytes), words_(bytes), text_(format == "ascii") {
    if (!text_ && format != "binary_little_endian" && format != "binary_big_endian")
      throw std::runtime_error("its format is \"" + std::string(format) + '"');
    swap_ = (format == "binary_big_endian") == (std::endian::native == std::endian::little);
  }
  double number(Number type) {
    if (text_) return words_.number();
    switch (type) {
      case Number::int8:
        return take<std::int8_t>();
      case Number::uint8:
        return take<std::uint8_t>();
      case Number::int16:
        return take<std::int16_t>();
      case Number::uint16:
        return take<std::uint16_t>();
      case Number::int32:
        return take<std::int32_t>();
      case Number::uint32:
        return take<std::uint32_t>();
      case Number::float32:
        return take<float>();
      default:
        return take<double>();
    }
  }
  std::size_t count(Number type) {
    const double n = number(type);
    if (!(n >= 0.0) || n > static_cast<double>(bytes_.size()))
      throw std::runtime_error("a list has " + std::to_string(n) + " entries");
    return static_cast<std::size_t>(n);
  }

 private:
  template <class T>
  double take() {
    if (at_ + sizeof(T) > bytes_.size()) throw std::runtime_error("it ends within its numbers");
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(T));
    if (swap_) std::reverse(raw, raw + sizeof(T));
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return static_cast<double>(value);
  }
  std::string_view bytes_;
  MeshWords words_;
  bool text_, swap_ = false;
  std::size_t at_ = 0;
};

/// The elements that the head lists, and the format.
struct Head {
  std::vector<PlyElement> elements;
  std::string format;
  std::size_t size = 0;  ///< bytes
};

std::size_t countOf(MeshWords& words) {
  const double n = words.number();
  if (!(n >= 0.0) || n > 1e9) throw std::runtime_error("its head counts " + std::to_string(n));
  return static_cast<std::size_t>(n);
}

Head headOf(const std::string& bytes) {
  Head out;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    MeshWords words(std::string_view(bytes).substr(at, end - at));
    if (at == 0 && words.next() != "ply")
      throw std::runtime_error("it does not begin with \"ply\"");
    at = end + 1;
    const std::string_view word = words.next();
    if (word == "format") out.format = words.next();
    if (word == "element") {
      const std::string name(words.next());
      out.elements.push_back({name, countOf(words), {}});
    }
    if (word == "property") {
      if (out.elements.empty()) throw std::runtime_error("its head has a property of no element");
      Property p;
      std::string_view type = words.next();
      if (type == "list") p.count = numberOf(words.next()), type = words.next();
      p.type = numberOf(type), p.name = words.next();
      out.elements.back().properties.push_back(p);
    }
    if (word == "end_header") {
      out.size = std::min(at, bytes.size());
      return out;
    }
  }
  throw std::runtime_error("its head has no end");
}

}  // namespace

TriangleMesh readPly(const std::string& bytes) {
  const Head head = headOf(bytes);
  Body body(std::string_view(bytes).substr(head.size), head.format);
  MeshBuilder out;
  std::vector<int> pointOf;
  for (const PlyElement& element : head.elements)
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      Vec3 p = Vec3::Zero();
      std::vector<int> corners;
      for (const Property& property : element.properties) {
        const bool isFace = element.name == "face" &&
                            (property.name == "vertex_indices" || property.name == "vertex_index");
        for (std::size_t k = 0, n = property.count ? body.count(*property.count) : 1; k < n; ++k) {
          const double x = body.number(property.type);
          if (!property.count && property.name.size() == 1 && property.name[0] >= 'x' &&
              property.name[0] <= 'z')
            p[property.name[0] - 'x'] = x;
          if (!isFace) continue;
          if (!(x >= 0.0) || x >= static_cast<double>(pointOf.size()))
            throw std::runtime_error("a face has the corner " + std::to_string(x));
          corners.push_back(pointOf[static_cast<std::size_t>(x)]);
        }
      }
      if (element.name == "vertex") pointOf.push_back(out.point(p));
      out.face(corners);
    }
  return std::move(out.mesh);
}

}  // namespace dynamy
