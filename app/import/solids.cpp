#include "import/solids.hpp"

#include <dynamy/core/constants.hpp>

namespace dynamy::app {
namespace {

Mat3 diagonal(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

double ball(double r) { return 4.0 / 3.0 * kPi * r * r * r; }

/// Half balls of radius r and a cylinder of length l between them.
Mat3 capsule(double mass, double r, double l) {
  const double caps = ball(r), middle = kPi * r * r * l;
  const double mc = mass * caps / (caps + middle), mm = mass - mc;
  const double z = 0.4 * mc * r * r + 0.5 * mm * r * r;
  // The centre of a half ball lies 3/8 r from its base.
  const double x =
      mm * (3.0 * r * r + l * l) / 12.0 + mc * (0.4 * r * r + 0.25 * l * l + 0.375 * l * r);
  return diagonal(x, x, z);
}

}  // namespace

double volume(const Skin& skin) {
  const Vec3& s = skin.size;
  switch (skin.kind) {
    case Skin::Kind::box:
      return s.prod();
    case Skin::Kind::sphere:
      return ball(s.x());
    case Skin::Kind::ellipsoid:
      return 4.0 / 3.0 * kPi * s.prod();
    case Skin::Kind::cylinder:
      return kPi * s.x() * s.x() * s.y();
    case Skin::Kind::capsule:
      return ball(s.x()) + kPi * s.x() * s.x() * s.y();
    default:
      return 0.0;
  }
}

Inertia solidInertia(const Skin& skin, double mass) {
  const Vec3 s = skin.size, q = s.cwiseProduct(s);
  Inertia own, out;
  own.mass = mass;
  switch (skin.kind) {
    case Skin::Kind::box:
      own.J = mass / 12.0 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
      break;
    case Skin::Kind::sphere:
      own.J = 0.4 * mass * q.x() * Mat3::Identity();
      break;
    case Skin::Kind::ellipsoid:
      own.J = mass / 5.0 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
      break;
    case Skin::Kind::cylinder: {
      const double x = mass * (3.0 * q.x() + q.y()) / 12.0;
      own.J = diagonal(x, x, 0.5 * mass * q.x());
      break;
    }
    case Skin::Kind::capsule:
      own.J = capsule(mass, s.x(), s.y());
      break;
    default:
      own.mass = 0.0;
  }
  out.add(own, skin.pose);
  return out;
}

Inertia enclosedInertia(const TriangleMesh& mesh) {
  const MassProperties m = enclosed(mesh);
  return {m.volume, m.centre_B, m.inertia_B};
}

}  // namespace dynamy::app
