#include "import/machine.hpp"

namespace dynamy::app {
namespace {

/// m (|d|² I − d dᵀ): what moving the reference point by d adds.
Mat3 steiner(double m, const Vec3& d) {
  return m * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
}

}  // namespace

void Inertia::add(const Inertia& other, const Pose& pose) {
  if (other.none()) return;
  const Vec3 c = pose.point(other.centre);
  const double all = mass + other.mass;
  const Vec3 common = (mass * centre + other.mass * c) / all;
  J += steiner(mass, centre - common) + pose.A * other.J * pose.A.transpose() +
       steiner(other.mass, c - common);
  mass = all, centre = common;
}

}  // namespace dynamy::app
