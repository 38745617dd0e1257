#include <charconv>
#include <dynamy/io/mesh/mesh_text.hpp>
#include <stdexcept>

namespace dynamy {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

int MeshBuilder::point(const Vec3& p) {
  // Not only at the end: numbers that are none have no place among the points that are known.
  if (!p.allFinite()) throw std::runtime_error("a corner is not finite");
  const auto [at, added] =
      known_.try_emplace(std::tuple(p.x(), p.y(), p.z()), static_cast<int>(mesh.points.size()));
  if (added) mesh.points.push_back(p);
  return at->second;
}

void MeshBuilder::face(const std::vector<int>& corners) {
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const int a = corners[0], b = corners[k - 1], c = corners[k];
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  }
}

std::string_view MeshWords::next() {
  while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

bool MeshWords::atEnd() {
  while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  return at_ == text_.size();
}

double MeshWords::number() {
  const std::string_view word = next();
  if (word.empty()) throw std::runtime_error("it ends within a list of numbers");
  const char* begin = word.data() + (word[0] == '+' ? 1 : 0);
  double x = 0.0;
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), x);
  if (error != std::errc() || end != word.data() + word.size())
    throw std::runtime_error('"' + std::string(word) + "\" is no number");
  return x;
}

Vec3 MeshWords::vector() {
  Vec3 out;
  for (double& x : out) x = number();
  return out;
}

}  // namespace dynamy
