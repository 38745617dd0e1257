#include <algorithm>
#include <dynamy/core/constants.hpp>
#include <dynamy/simulation/report/start_overlap.hpp>

namespace dynamy {
namespace {

/// Smallest edge above zero of the box around points, in the axes of the shape; 0 if there is none.
double smallestEdge(const std::vector<Vec3>& points) {
  if (points.size() < 3) return 0.0;
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  double least = kInfinity;
  for (const double edge : Vec3(high - low))
    if (edge > 0.0) least = std::min(least, edge);
  return least < kInfinity ? least : 0.0;
}

/// Size of the body with the shapes of system i, 0 if none has a size; frame ≥ 0: with those of
/// this frame alone.
double sizeOf(const Model& model, std::size_t i, int frame) {
  double size = 0.0;
  for (const PlacedShape& p : model.descriptions()[i].shapes)
    if (!p.shape->material().empty() && (frame < 0 || p.frame == frame))
      size = std::max(size, thickness(p.shape->geometry()));
  return size;
}

/// Size of the body that mass block `block` belongs to, 0 if it has no shape with a size.
double bodySize(const Model& model, int block) {
  const Topology& t = model.topology();
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const SystemHandle& s = t.system(static_cast<int>(i));
    if (block < s.block0 || block >= s.block0 + s.blocks) continue;
    // In a population each block is a body with a frame of its own.
    return sizeOf(model, i, s.blocks > 1 ? block - s.block0 : -1);
  }
  return 0.0;
}

/// Blocks of contact i.
std::vector<int> blocksOf(const ContactSet& contacts, std::size_t i) {
  std::vector<int> out;
  for (int k = contacts.segment0[i]; k < contacts.segment0[i + 1]; ++k)
    out.push_back(contacts.segment[static_cast<std::size_t>(k)].block);
  std::sort(out.begin(), out.end());
  return out;
}

/// A contact between the bodies of contact i that is no touch, such as a hinge.
ContactKey jointBeside(const ContactSet& start, std::size_t i) {
  const std::vector<int> bodies = blocksOf(start, i);
  for (std::size_t j = 0; j < start.law.size(); ++j)
    if (holds(start.law[j]->rowKind(0)) && blocksOf(start, j) == bodies)
      return start.candidateKey[static_cast<std::size_t>(start.candidate[j])];
  return kNoContact;
}

}  // namespace

double thickness(const ShapeGeometry& shape) {
  const auto& size = shape.size;
  switch (shape.type) {
    case ShapeType::point:
    case ShapeType::line:
    case ShapeType::halfSpace:
    case ShapeType::bore:
      return 0.0;
    case ShapeType::sphere:
    case ShapeType::circle:
    case ShapeType::capsule:
      return 2.0 * size[0];
    case ShapeType::cylinder:
    case ShapeType::cone:
      return std::min(2.0 * size[0], size[1]);
    case ShapeType::torus:
      return 2.0 * size[1];
    case ShapeType::box:
      return std::min({size[0], size[1], size[2]});
    case ShapeType::ellipsoid:
      return 2.0 * std::min({size[0], size[1], size[2]});
    default:
      return smallestEdge(shape.points);
  }
}

double smallestBody(const Model& model) {
  double smallest = kInfinity;
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const SystemHandle& s = model.topology().system(static_cast<int>(i));
    if (s.nu == 0) continue;
    if (s.blocks <= 1) {
      if (const double size = sizeOf(model, i, -1); size > 0.0) smallest = std::min(smallest, size);
      continue;
    }
    for (const PlacedShape& p : model.descriptions()[i].shapes)  // a population: one shape a body
      if (const double size = thickness(p.shape->geometry());
          size > 0.0 && !p.shape->material().empty())
        smallest = std::min(smallest, size);
  }
  return smallest;
}

StartOverlap startOverlap(const Model& model, const ContactSet& start) {
  StartOverlap worst;
  std::size_t which = 0;
  for (int i = 0; i < start.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto candidate = static_cast<std::size_t>(start.candidate[at]);
    StartOverlap here{-start.g[candidate], kInfinity, start.candidateKey[candidate]};
    if (!start.law[at]->unilateral() || !(here.depth > 0.0)) continue;
    for (int k = start.segment0[at]; k < start.segment0[at + 1]; ++k) {
      const double size = bodySize(model, start.segment[static_cast<std::size_t>(k)].block);
      if (size > 0.0) here.size = std::min(here.size, size);
    }
    if (here.size < kInfinity && here.share() > worst.share()) worst = here, which = at;
  }
  if (worst.depth > 0.0) worst.joint = jointBeside(start, which);
  return worst;
}

}  // namespace dynamy
