#include <algorithm>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy_elements/forces/gravity.hpp>

namespace dynamy {

void Gravity::declare(Attributes& a) {
  a.about(
      "Uniform field of gravity: every mass m feels the force m g. Systems written as formulas "
      "(Coordinates) have their weight in their own potential and do not answer.");
  a.vector("acceleration", Unit::acceleration, 3, "0 0 -9.81", "acceleration of free fall");
  a.add(AttributeType::expressions, "change", std::nullopt,
        "x; y; z as formulas of t, added to the acceleration: a shaken or tilted scene")
      .in(Unit::acceleration)
      .mayBeAbsent();
  a.example("<Gravity acceleration=\"0 0 -9.81\"/>");
}

Gravity::Gravity(const Parameters& x)
    : ExternalForce(x), g_I_(x["acceleration"].vec3()), change_(x, "change", 3) {}

Vec3 Gravity::field(double t) const {
  if (change_.empty()) return g_I_;
  Vec3 change;
  change_.eval(t, change.data());
  return g_I_ + change;
}

bool Gravity::isMirrored(const MirrorPlane& plane) const {
  return change_.empty() && plane.isAlong(g_I_);
}

void Gravity::connect(Topology& topology) {
  parts_.clear();
  int largest = 0;
  bool felt = false;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& handle = topology.system(static_cast<int>(i));
    if (handle.nu == 0) continue;
    parts_.push_back({topology.systems()[i], handle});
    largest = std::max(largest, handle.nu);
    Eigen::VectorXd q(handle.nq), u(handle.nu);
    topology.systems()[i]->initialState({q.data(), q.size()}, {u.data(), u.size()});
    felt = felt || topology.systems()[i]->feelsGravity({q.data(), q.size()});
  }
  if (!felt && !(g_I_.isZero(0.0) && change_.empty()))
    throw ModelError("no system of the model feels gravity",
                     "write its potential into the system itself, e.g. <Coordinates … "
                     "potential=\"m*9.81*z\">, and leave <Gravity> out");
  h_.setZero(largest);
}

void Gravity::addTo(const Kinematics& k, ForceSink& sink) const {
  const Vec3 g_I = field(k.t());
  for (const Part& part : parts_) {
    if (k.leavesOut(part.handle.index)) continue;
    part.system->gravity(k.t(), k.q(part.handle), g_I, {h_.data(), part.handle.nu});
    sink.generalised(part.handle, {h_.data(), part.handle.nu});
  }
}

double Gravity::potentialEnergy(const Kinematics& k) const {
  double V = 0.0;
  if (!hasPotential()) return V;
  for (const Part& part : parts_)
    if (!k.leavesOut(part.handle.index))
      V += part.system->gravity(k.t(), k.q(part.handle), g_I_, {h_.data(), part.handle.nu});
  return V;
}

}  // namespace dynamy
