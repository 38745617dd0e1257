#include <Eigen/Geometry>
#include <cmath>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy_elements/forces/springs.hpp>
#include <numbers>

namespace dynamy {
namespace {

void declareStiff(Attributes& a) {
  a.add(AttributeType::flag, "stiff", "false",
        "true: taken linearly implicitly by the schemes, which keeps its energy where steps are "
        "beyond its period; else such a spring is found, and damped");
}
bool isStiff(const Parameters& x) { return x["stiff"].flag(); }

}  // namespace

// ---- SpringDamper ------------------------------------------------------------------------------

void SpringDamper::declare(Attributes& a) {
  a.about(
      "Spring and damper along the line between two points: F = c (l - l0) + d l', V = c (l - "
      "l0)^2/2. Signals: length, force (pull positive).");
  FramePair::declare(a);
  a.vector("pointA", Unit::length, 3, "0 0 0", "point on A, in axes of A");
  a.vector("pointB", Unit::length, 3, "0 0 0", "point on B, in axes of B");
  a.required("stiffness", Unit::stiffness, "stiffness c").nonNegative();
  a.optional("damping", Unit::damping, 0.0, "damping d").nonNegative();
  Attribute& length = a.add(AttributeType::number, "length", std::nullopt,
                            "length l0 without force; default: the distance at the start");
  length.unit = Unit::length;
  length.mayBeAbsent().nonNegative();
  declareStiff(a);
  a.example(
      "<SpringDamper between=\"world ball\" pointA=\"0 0 2\" stiffness=\"100\" length=\"0.5\"/>");
}

SpringDamper::SpringDamper(const Parameters& x)
    : ExternalForce(x),
      frames_(x),
      pointA_(x["pointA"].vec3()),
      pointB_(x["pointB"].vec3()),
      stiffness_(x["stiffness"]),
      damping_(x["damping"]),
      length_(x.has("length") ? double(x["length"]) : 0.0),
      lengthGiven_(x.has("length")),
      stiff_(isStiff(x)) {}

void SpringDamper::connect(Topology& topology) {
  frames_.connect(topology, *this);
  if (lengthGiven_) return;
  const StartKinematics start(topology, {frames_.A, frames_.B});
  const Frame &A = start.frame(frames_.A), &B = start.frame(frames_.B);
  length_ = (B.r_OS_I + B.A_IK * pointB_ - A.r_OS_I - A.A_IK * pointA_).norm();
}

bool SpringDamper::isMirrored(const MirrorPlane& plane) const {
  FramePair frames = frames_;
  frames.find(*plane.topology, *this);
  const StartKinematics start(*plane.topology, {frames.A, frames.B});
  const Frame &A = start.frame(frames.A), &B = start.frame(frames.B);
  return plane.contains(A.r_OS_I + A.A_IK * pointA_) && plane.contains(B.r_OS_I + B.A_IK * pointB_);
}

SpringDamper::Line SpringDamper::line(const Kinematics& k) const {
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B);
  Line out;
  out.rhoA_I = A.A_IK * pointA_, out.rhoB_I = B.A_IK * pointB_;
  const Vec3 r_PQ = B.r_OS_I + out.rhoB_I - A.r_OS_I - out.rhoA_I;
  out.l = r_PQ.norm();
  // Points that coincide have no line between them: no force.
  out.e = out.l > 0.0 ? Vec3(r_PQ / out.l) : Vec3(Vec3::Zero());
  out.ldot = out.e.dot(B.velocity(out.rhoB_I) - A.velocity(out.rhoA_I));
  return out;
}

void SpringDamper::addTo(const Kinematics& k, ForceSink& sink) const {
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B);
  const Line s = line(k);
  // Spring and damper are added separately, since only the spring has a potential.
  const Vec3 spring = stiffness_ * (s.l - length_) * s.e, damper = damping_ * s.ldot * s.e;
  sink.hasPotential(true);
  sink.force(A, s.rhoA_I, spring);
  sink.force(B, s.rhoB_I, -spring);
  if (damping_ == 0.0) return;
  sink.hasPotential(false);
  sink.force(A, s.rhoA_I, damper);
  sink.force(B, s.rhoB_I, -damper);
}

void SpringDamper::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  // ∂F/∂l along the line, and F/l across it under tension; a line under
  // compression would be unstable.
  const Line s = line(k);
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B);
  sink.spring(A, s.rhoA_I, B, s.rhoB_I, s.e, stiffness_, damping_);
  const double across = stiffness_ * (s.l - length_);
  if (!(across > 0.0)) return;
  const Vec3 n = s.e.unitOrthogonal();
  for (const Vec3& e : {n, Vec3(s.e.cross(n))})
    sink.spring(A, s.rhoA_I, B, s.rhoB_I, e, across / s.l, 0.0);
}

double SpringDamper::potentialEnergy(const Kinematics& k) const {
  const double x = line(k).l - length_;
  return 0.5 * stiffness_ * x * x;
}

void SpringDamper::describe(Description& d) const {
  d.timeless = true;
  if (stiffness_ > 0.0 || damping_ > 0.0)  // otherwise it only measures the distance
    d.link({frames_.A.index, frames_.B.index, pointA_, pointB_, true});
  d.signal("length", Unit::length, "distance of the points",
           [this](const SignalView& v) { return line(*v.kinematics).l; });
  d.signal("force", Unit::force, "pull of spring and damper", [this](const SignalView& v) {
    const Line s = line(*v.kinematics);
    return stiffness_ * (s.l - length_) + damping_ * s.ldot;
  });
}

// ---- TorsionSpring -----------------------------------------------------------------------------

void TorsionSpring::declare(Attributes& a) {
  a.about(
      "Spring and damper about an axis: M = c (psi - psi0) + d psi', for bodies that turn against "
      "each other about this axis; where they tilt as well it acts on the part psi of their turn "
      "that is "
      "about the axis. The angle psi is 0 where the axes of A and B are parallel, and "
      "lies between -pi and pi. Signals: angle, moment.");
  FramePair::declare(a);
  a.vector("axis", Unit::none, 3, "0 0 1", "axis in axes of A").notZero();
  a.required("stiffness", Unit::rotationalStiffness, "stiffness c").nonNegative();
  a.optional("damping", Unit::rotationalDamping, 0.0, "damping d").nonNegative();
  a.optional("angle", Unit::angle, 0.0, "angle psi0 without moment");
  declareStiff(a);
  a.example("<TorsionSpring between=\"world rod\" axis=\"0 -1 0\" stiffness=\"2\"/>");
}

TorsionSpring::TorsionSpring(const Parameters& x)
    : ExternalForce(x),
      frames_(x),
      axis_A_(x["axis"].vec3().normalized()),
      stiffness_(x["stiffness"]),
      damping_(x["damping"]),
      angle_(x["angle"]),
      stiff_(isStiff(x)) {}

// With the quaternion (w, v) of B against A and the axis a, ψ = 2 atan2(v·a, w); from ẇ = −½ v·Ω and
// v̇ = ½ (w Ω + Ω × v) follows ψ̇ = Ω · (a + (n (v − n a) + w v × a)/(w² + n²)), n = v·a. A moment along a
// alone would take energy from bodies that tilt.
double TorsionSpring::angle(const Kinematics& k, Vec3* gradient_I) const {
  const Mat3& A_IA = k.frame(frames_.A).A_IK;
  const Mat3 relative = A_IA.transpose() * k.frame(frames_.B).A_IK;
  const Eigen::Quaterniond p(relative);
  const Vec3 v = p.vec();
  const double n = v.dot(axis_A_), w = p.w(), square = w * w + n * n;
  if (gradient_I != nullptr) {
    const Vec3 tilt = n * (v - n * axis_A_) + w * v.cross(axis_A_);
    *gradient_I = A_IA * (axis_A_ + (square > 0.0 ? Vec3(tilt / square) : Vec3(Vec3::Zero())));
  }
  return std::remainder(2.0 * std::atan2(n, w), 2.0 * std::numbers::pi);
}

void TorsionSpring::addTo(const Kinematics& k, ForceSink& sink) const {
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B);
  Vec3 gradient;
  const Vec3 spring = stiffness_ * (angle(k, &gradient) - angle_) * gradient;
  sink.hasPotential(true);
  sink.moment(A, spring);
  sink.moment(B, -spring);
  if (damping_ == 0.0) return;
  const Vec3 damper = damping_ * gradient.dot(B.Omega_I - A.Omega_I) * gradient;
  sink.hasPotential(false);
  sink.moment(A, damper);
  sink.moment(B, -damper);
}

void TorsionSpring::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  Vec3 gradient;
  angle(k, &gradient);
  sink.torsion(k.frame(frames_.A), k.frame(frames_.B), gradient, stiffness_, damping_);
}

double TorsionSpring::potentialEnergy(const Kinematics& k) const {
  const double x = angle(k) - angle_;
  return 0.5 * stiffness_ * x * x;
}

void TorsionSpring::describe(Description& d) const {
  d.timeless = true;
  d.signal("angle", Unit::angle, "angle of B against A",
           [this](const SignalView& v) { return angle(*v.kinematics); });
  d.signal("moment", Unit::torque, "moment on A about the axis", [this](const SignalView& v) {
    Vec3 gradient;
    const double psi = angle(*v.kinematics, &gradient);
    const Vec3 Omega =
        v.kinematics->frame(frames_.B).Omega_I - v.kinematics->frame(frames_.A).Omega_I;
    return stiffness_ * (psi - angle_) + damping_ * gradient.dot(Omega);
  });
}

}  // namespace dynamy
