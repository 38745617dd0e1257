#include <algorithm>
#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy/system/kinematics.hpp>
#include <dynamy_elements/bodies/grains.hpp>
#include <dynamy_elements/bodies/gyroscopic.hpp>
#include <limits>

namespace dynamy {
namespace {

/// A copy of a shape that is s times as large.
class ScaledShape final : public Shape {
 public:
  static void declare(Attributes&) {}
  ScaledShape(const Parameters& x, const Shape& like, double s) : Shape(x), like_(like), s_(s) {}
  ShapeGeometry geometry() const override {
    ShapeGeometry g = like_.geometry();
    for (double& size : g.size) size *= s_;
    for (Vec3& point : g.points) point *= s_;
    return g;
  }
  MassProperties massProperties() const override {
    MassProperties m = like_.massProperties();
    const double s2 = s_ * s_, s3 = s2 * s_;
    return {s3 * m.volume, s_ * m.centre_B, s3 * s2 * m.inertia_B};
  }

 private:
  const Shape& like_;
  double s_;
};

/// Parameters from which a ScaledShape is made.
Parameters scaled(const Shape& like, double s) {
  const Eigen::Quaterniond p(like.A_KB());
  std::vector<GivenValue> given{{"position", Vec3(s * like.r_SB_K())},
                                {"orientation", {p.w(), p.x(), p.y(), p.z()}}};
  if (!like.material().empty()) given.emplace_back("material", like.material());
  if (!like.colour().empty()) given.emplace_back("colour", like.colour());
  return Parameters::of<ScaledShape>(like.type(), like.name(), given);
}

/// Distance of the farthest point of a shape from the middle of its grain [m].
double bound(const Shape& shape) {
  const ShapeGeometry g = shape.geometry();
  double out = 0.0;
  for (const Vec3& p : g.points) out = std::max(out, p.norm());
  switch (g.type) {
    case ShapeType::sphere:
      out = g.size[0];
      break;
    case ShapeType::cylinder:
      out = std::hypot(g.size[0], 0.5 * g.size[1]);
      break;
    case ShapeType::capsule:
      out = g.size[0] + 0.5 * g.size[1];
      break;
    case ShapeType::torus:
      out = g.size[0] + g.size[1];
      break;
    case ShapeType::cone:
      out = std::max(g.size[0], g.size[1]);
      break;
    case ShapeType::ellipsoid:
      out = std::max({g.size[0], g.size[1], g.size[2]});
      break;
    default:
      break;
  }
  // Points are measured from the centre of mass.
  return out + (shape.massProperties().centre_B).norm();
}

bool absent(ConstVec q, std::size_t i) { return GrainExchange::absent(q.data() + 7 * i); }

template <class Vector>
auto part(Vector&& v, std::size_t i, int n) {
  return v.segment(static_cast<Eigen::Index>(i) * n, n);
}

}  // namespace

void Grains::declare(Attributes& a) {
  a.about(
      "Many free bodies of one shape in many sizes, packed without overlap into an upright box: "
      "m v' = f, J Ω' + Ω × J Ω = M for each. The numbers drawn depend on the seed alone. Signals: "
      "kineticEnergy, present, meanX, meanY, meanZ, lowX, highX … highZ (1 % are beyond), maxZ, "
      "maxSpeed.");
  a.add(AttributeType::integer, "count", std::nullopt, "how many").atLeast(1).max = 1e6;
  a.requiredVector("within", Unit::length, 6,
                   "box to pack them into: lowest x y z, highest x y z; a lattice grows upwards as "
                   "far as it has to");
  a.choice("packing", {"lattice", "random"}, "lattice",
           "cells of equal size in layers from below, or places at random");
  a.optional("pitch", Unit::length, 0.0,
             "edge of the cells of a lattice; 0: the largest diameter and twice the jitter")
      .nonNegative();
  a.optional("jitter", Unit::length, 0.0, "how far at most a place is off in x, y, z in a lattice")
      .nonNegative();
  a.vector("sizes", Unit::none, 2, "1 1", "least and largest factor of the shape's size")
      .positive();
  a.choice("distribution", {"byNumber", "byVolume", "lognormal"}, "byNumber",
           "of the factors: even over the range, by number or by share of the volume, or with a "
           "lognormal density that falls to 1 % of its maximum at both ends");
  a.add(AttributeType::flag, "turned", "false", "true: attitudes at random");
  a.add(AttributeType::integer, "seed", "1", "another seed, another heap").nonNegative();
  a.vector("velocity", Unit::velocity, 3, "0 0 0", "of all of them at the start");
  GrainExchange::declare(a);
  a.child(Kind::shape, 1, 1, "the shape, with a density or mass (of a grain of size 1)");
  a.example(
      "<Grains name=\"sand\" count=\"50\" within=\"0 0 0  1 1 1\" sizes=\"0.8 1.2\">"
      "<Sphere radius=\"0.05\" density=\"2500\"/></Grains>");
}

Grains::Grains(const Parameters& x)
    : PartialMechanicalSystem(x),
      shape_(x.takeOne<Shape>()),
      grains_(static_cast<std::size_t>(x["count"].integer())),
      v_S_I_(x["velocity"].vec3()) {
  if (shape_->ownContact().family)
    throw ModelError("a " + shape_->type() + " has one size, and grains have many",
                     "its plug-in computes its contacts; take a shape that dynamY knows, or single "
                     "bodies");
  SeededNumbers numbers(static_cast<std::uint64_t>(x["seed"].integer()));
  takeSizes(x, numbers);
  const MassProperties mass = shape_->massProperties();
  const double m = shape_->mass() > 0.0 ? shape_->mass() : shape_->density() * mass.volume;
  if (!(m > 0.0) || !(mass.volume > 0.0))
    throw ModelError("the grains have no mass", "give their shape a volume and a density or mass");
  const Mat3 J = m / mass.volume * shape_->A_KB() * mass.inertia_B * shape_->A_KB().transpose();
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    const double s = size_[i], s3 = s * s * s;
    grains_[i].m = s3 * m, grains_[i].J_S_K = s3 * s * s * J;
    if (x["turned"].flag()) numbers.attitude(grains_[i].p);
  }
  if (!(shape_->r_SB_K() + shape_->A_KB() * mass.centre_B).isZero(0.0))
    throw ModelError("the centre of mass of a grain has to be its origin",
                     "move the shape by its position");
  place(x, numbers);
}

void Grains::takeSizes(const Parameters& x, SeededNumbers& numbers) {
  const Eigen::VectorXd range = x["sizes"].vector();
  const double a = range[0], b = range[1];
  if (a > b)
    throw x["sizes"].fault("the least factor is larger than the largest", "", 0,
                           x["sizes"].text.size());
  size_.resize(grains_.size());
  const std::string& distribution = x["distribution"].text;
  const double middle = 0.5 * std::log(a * b);
  const double sigma = 0.5 * std::log(b / a) / std::sqrt(2.0 * std::log(100.0));
  for (double& s : size_) {
    if (distribution == "byNumber") s = numbers.uniform(a, b);
    // The volume is distributed uniformly over s: the number of grains has a density like s⁻³.
    if (distribution == "byVolume")
      s = 1.0 / std::sqrt(numbers.uniform(1.0 / (b * b), 1.0 / (a * a)));
    if (distribution == "lognormal") do
        s = std::exp(middle + sigma * numbers.normal());
      while (a < b && (s < a || s > b));
  }
  if (a == b) std::fill(size_.begin(), size_.end(), a);  // without the rounding of a logarithm
  if (a == 1.0 && b == 1.0) return;
  const bool central = shape_->r_SB_K().isZero(0.0);  // then all grains have the same parameters
  Parameters of = scaled(*shape_, 1.0);
  for (const double s : size_) {
    if (!central) of = scaled(*shape_, s);
    ownShapes_.push_back(std::make_unique<ScaledShape>(of, *shape_, s));
  }
}

void Grains::place(const Parameters& x, SeededNumbers& numbers) {
  const Eigen::VectorXd v = x["within"].vector();
  const Region region{v.head<3>(), v.tail<3>()};
  std::vector<double> radii;
  for (const double s : size_) radii.push_back(s * bound(*shape_));
  const double jitter = x["jitter"], largest = *std::max_element(radii.begin(), radii.end());
  double pitch = x["pitch"];
  const bool lattice = x["packing"].text == "lattice";
  if (lattice && pitch > 0.0 && pitch < 2.0 * (largest + jitter) * (1.0 - 1e-12))
    throw x["pitch"].fault("grains overlap",
                           "at least the largest diameter and twice the jitter: " +
                               numberText(2.0 * (largest + jitter)),
                           0, x["pitch"].text.size());
  exchange_ = std::make_unique<const GrainExchange>(x, radii);
  if (pitch == 0.0) pitch = 2.0 * (largest + jitter);
  const auto places = lattice ? latticePlaces(grains_.size(), region, pitch, jitter, numbers)
                              : randomPlaces(radii, region, numbers);
  if (!places)
    throw x["within"].fault("the grains find no place in this box",
                            lattice
                                ? "not one cell of " + numberText(pitch) + " m fits into a layer"
                                : "take fewer, or packing=\"lattice\", which grows upwards",
                            0, x["within"].text.size());
  for (std::size_t i = 0; i < grains_.size(); ++i) grains_[i].r_OS_I = (*places)[i];
}

void Grains::describe(Description& d) const {
  d.timeless = true;
  if (std::isfinite(exchange_->nextFeed(0.0)))
    d.signal(kNextInstant, Unit::time, "when the feeder brings the next grain, if one is absent",
             [this](const SignalView& v) {
               return exchange_->mayFeed(v.q) ? exchange_->nextFeed(v.t)
                                              : std::numeric_limits<double>::infinity();
             });
  for (int i = 0; i < count(); ++i)
    d.shape(ownShapes_.empty() ? *shape_ : *ownShapes_[static_cast<std::size_t>(i)], i);
  d.signal("kineticEnergy", Unit::energy, "Σ ½ m v² + ½ Ω·J Ω", [this](const SignalView& s) {
    double T = 0.0;
    for (std::size_t i = 0; i < grains_.size(); ++i) {
      const Vec3 v = part(s.u, i, 6).head<3>(), Omega = part(s.u, i, 6).tail<3>();
      T += 0.5 * grains_[i].m * v.squaredNorm() + 0.5 * Omega.dot(grains_[i].J_S_K * Omega);
    }
    return T;
  });
  // Signals include present grains only.
  const auto over = [this](const SignalView& s, const auto& visit) {
    int count = 0;
    for (std::size_t i = 0; i < grains_.size(); ++i)
      if (!absent(s.q, i)) visit(i), ++count;
    return count;
  };
  d.signal("present", Unit::none, "how many there are",
           [over](const SignalView& s) { return double(over(s, [](std::size_t) {})); });
  const char* const axis[3] = {"X", "Y", "Z"};
  for (int k = 0; k < 3; ++k)
    d.signal(std::string("mean") + axis[k], Unit::length, "mean of all grains",
             [over, k](const SignalView& s) {
               double sum = 0.0;
               const int n = over(s, [&](std::size_t i) { sum += part(s.q, i, 7)[k]; });
               return sum / std::max(n, 1);
             });
  d.signal("maxZ", Unit::length, "highest centre", [over](const SignalView& s) {
    double most = -std::numeric_limits<double>::infinity();
    const int n = over(s, [&](std::size_t i) { most = std::max(most, part(s.q, i, 7)[2]); });
    return n > 0 ? most : 0.0;
  });
  // Extent of a heap, without the few grains that roll away.
  for (int k = 0; k < 3; ++k)
    for (const double share : {0.01, 0.99})
      d.signal(std::string(share < 0.5 ? "low" : "high") + axis[k], Unit::length,
               share < 0.5 ? "1 % of the centres are below" : "99 % of the centres are below",
               [this, over, k, share](const SignalView& s) {
                 sorted_.clear();
                 const int n =
                     over(s, [&](std::size_t i) { sorted_.push_back(part(s.q, i, 7)[k]); });
                 if (n == 0) return 0.0;
                 const auto at = sorted_.begin() + static_cast<std::ptrdiff_t>(share * (n - 1));
                 std::nth_element(sorted_.begin(), at, sorted_.end());
                 return *at;
               });
  d.signal("maxSpeed", Unit::velocity, "largest speed", [this](const SignalView& s) {
    double most = 0.0;
    for (std::size_t i = 0; i < grains_.size(); ++i)
      most = std::max(most, part(s.u, i, 6).head<3>().norm());
    return most;
  });
}

void Grains::initialState(Vec q, Vec u) const {
  u.setZero();
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    part(q, i, 7).head<3>() = grains_[i].r_OS_I;
    for (int k = 0; k < 4; ++k) part(q, i, 7)[3 + k] = grains_[i].p[k];
    part(u, i, 6).head<3>() = v_S_I_;
    if (i >= static_cast<std::size_t>(exchange_->present()))
      exchange_->remove(q.data() + 7 * i, u.data() + 6 * i);
  }
}

void Grains::M(double, ConstVec, MassBlocks M) const {
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    Block block = M[static_cast<int>(i)];
    block.setZero();
    block.diagonal().head<3>().setConstant(grains_[i].m);
    block.bottomRightCorner<3, 3>() = grains_[i].J_S_K;
  }
}

void Grains::h(double, ConstVec, ConstVec u, Vec h) const {
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    const Vec3 Omega = part(u, i, 6).tail<3>();
    part(h, i, 6).head<3>().setZero();
    part(h, i, 6).tail<3>() = -Omega.cross(grains_[i].J_S_K * Omega);
  }
}

void Grains::gyroscopicAtMean(double, ConstVec, ConstVec uA, double dt, Vec h) const {
  for (std::size_t i = 0; i < grains_.size(); ++i)
    dynamy::gyroscopicAtMean(grains_[i].J_S_K, part(uA, i, 6).tail<3>(), dt, h.data() + 6 * i + 3);
}

void Grains::qdot(double, ConstVec q, ConstVec u, Vec qdot) const {
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    if (GrainExchange::absent(q.data() + 7 * i)) {
      part(qdot, i, 7).setZero();
      continue;
    }
    part(qdot, i, 7).head<3>() = part(u, i, 6).head<3>();
    quaternionRate(q.data() + 7 * i + 3, part(u, i, 6).tail<3>(), qdot.data() + 7 * i + 3);
  }
}

void Grains::move(double, Vec q, ConstVec u, double dt) const {
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    if (GrainExchange::absent(q.data() + 7 * i)) continue;
    part(q, i, 7).head<3>() += dt * part(u, i, 6).head<3>();
    rotate(q.data() + 7 * i + 3, dt * part(u, i, 6).tail<3>());
  }
}

void Grains::normalise(Vec q) const {
  for (std::size_t i = 0; i < grains_.size(); ++i)
    if (!GrainExchange::absent(q.data() + 7 * i)) part(q, i, 7).tail<4>().normalize();
}

double Grains::gravity(double, ConstVec q, const Vec3& g_I, Vec h) const {
  double V = 0.0;
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    part(h, i, 6).setZero();
    // Absent grains rest in the feeder.
    if (!absent(q, i)) part(h, i, 6).head<3>() = grains_[i].m * g_I;
    V -= grains_[i].m * g_I.dot(part(q, i, 7).head<3>());
  }
  return V;
}

void Grains::frame(double, ConstVec q, ConstVec u, int id, Frame& out) const {
  const auto i = static_cast<std::size_t>(id);
  out.block = id;
  out.absent = absent(q, i);
  out.r_OS_I = part(q, i, 7).head<3>();
  out.A_IK = rotationMatrix(q.data() + 7 * i + 3);
  out.v_S_I = part(u, i, 6).head<3>();
  out.Omega_I = out.A_IK * part(u, i, 6).tail<3>();
  out.nu_S_I.setZero(), out.nu_R_I.setZero();
  out.bias_S_I.setZero(), out.bias_R_I.setZero();
  out.J_S_I.leftCols<3>().setIdentity();
  out.J_R_I.rightCols<3>() = out.A_IK;
  out.central = true;
}

}  // namespace dynamy
