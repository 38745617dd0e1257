#include <algorithm>
#include <dynamy_elements/contacts/pairs/seen_apart.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr int kLooks = 6;
constexpr std::size_t kMostFeatures = 64;  ///< shapes with more, as large meshes, are skipped

/// Furthest point along d of the convex hull of the features, in space [m].
Vec3 furthest(const TouchingShape& shape, const Frame& f, const Vec3& d) {
  const Vec3 d_K = f.A_IK.transpose() * d;
  const SupportFeature* best = nullptr;
  double h = -std::numeric_limits<double>::infinity();
  for (const SupportFeature& feature : shape.features)
    if (const double here = feature.support(d_K); here > h) best = &feature, h = here;
  return best == nullptr ? f.r_OS_I : Vec3(f.r_OS_I + f.A_IK * best->point(d_K));
}

}  // namespace

bool seenApart(const TouchingShape& a, const TouchingShape& b, const Frame& A, const Frame& B,
               double reach) {
  if (std::max(a.features.size(), b.features.size()) > kMostFeatures) return false;
  if (a.features.empty() || b.features.empty()) return false;
  Vec3 way = B.r_OS_I + B.A_IK * b.p_K - A.r_OS_I - A.A_IK * a.p_K;
  for (int look = 0; look < kLooks; ++look) {
    const double length = way.norm();
    if (!(length > reach)) return false;
    const Vec3 d = way / length;
    const Vec3 between = furthest(b, B, -d) - furthest(a, A, d);
    if (d.dot(between) > reach) return true;
    const Vec3 s = between - way;
    if (!(s.squaredNorm() > 0.0)) return false;
    way += std::clamp(-way.dot(s) / s.squaredNorm(), 0.0, 1.0) * s;
  }
  return false;
}

}  // namespace dynamy
