#include <algorithm>
#include <cmath>
#include <dynamy/system/description.hpp>
#include <dynamy_elements/blocks/block_states.hpp>
#include <dynamy_elements/forces/nearest_road_point.hpp>
#include <dynamy_elements/forces/tyre.hpp>

namespace dynamy {
namespace {

/// Cosine of the camber below which the wheel lies on its side and has no contact.
constexpr double kLies = 1e-6;

}  // namespace

void Tyre::declare(Attributes& a) {
  a.about(
      "Tyre of a wheel A on a road B: a carcass that yields, slips that build up over a "
      "relaxation length, and the magic formula for both directions at once; camber counts as "
      "slip. "
      "Signals: load, longitudinalForce, lateralForce, aligningMoment, deflection, camber, slip, "
      "sideslip (at present) and the states longitudinalSlip, lateralSlip. The shapes of wheel and "
      "road need no material: the tyre is their contact.");
  FramePair::declare(a);
  a.vector("axis", Unit::none, 3, "0 0 1", "axle, in axes of A; a Torus turns about z").notZero();
  a.required("radius", Unit::length, "radius R of the wheel with its tyre, without load")
      .positive();
  a.optional("tube", Unit::length, 0.0, "radius of the tyre's section; 0: an edge").nonNegative();
  a.vector("normal", Unit::none, 3, "0 0 1",
           "normal of the road, a plane through the origin of B, in axes of B")
      .notZero();
  a.add(AttributeType::expression, "height", std::nullopt,
        "height of a road that is not flat, a formula of x and y in axes of B: edges may be sharp, "
        "hollows are wider than the wheel, bumps than an eighth of its radius, e.g. "
        "0.05*exp(-((x - 10)/0.5)^2); default: 0")
      .in(Unit::length)
      .mayBeAbsent();
  a.required("stiffness", Unit::stiffness, "of the carcass, C_z, along the normal").positive();
  a.optional("damping", Unit::damping, 0.0, "of the carcass, along the normal").nonNegative();
  a.optional("mu", Unit::none, 1.0, "largest force in the road's plane over the load").positive();
  a.optional("slipStiffness", Unit::none, 15.0, "c_kappa: longitudinal force over load and slip")
      .positive();
  a.optional("corneringStiffness", Unit::none, 12.0,
             "c_alpha: lateral force over load and sideslip [1/rad]")
      .positive();
  a.optional("camberStiffness", Unit::none, 0.9,
             "c_gamma: lateral force over load and camber [1/rad]");
  a.vector("relaxation", Unit::length, 2, "0.12 0.25",
           "relaxation lengths, longitudinal and lateral")
      .positive();
  a.vector("curve", Unit::none, 2, "1.5 0",
           "C and E of the magic formula: C in (0, 2), larger C falls off more beyond the peak");
  a.optional("trail", Unit::length, 0.0, "pneumatic trail t_0 without slip").nonNegative();
  a.vector("trailCurve", Unit::none, 2, "1 1.2",
           "B_t and C_t: the trail is t_0 cos(C_t atan(B_t p)), p = c s/mu");
  a.optional("slipDamping", Unit::time, 0.0,
             "tau: damps the swing of a standing carcass, e.g. 5 ms")
      .nonNegative();
  a.example(
      "<Tyre name=\"front\" between=\"ball world\" radius=\"0.1\" tube=\"0.05\" "
      "stiffness=\"1.5e5\" damping=\"300\" trail=\"0.02\"/>");
}

Tyre::Tyre(const Parameters& x)
    : ExternalForce(x),
      frames_(x),
      height_(x, "height", 1, {"x", "y"}),
      axis_(x["axis"].vec3().normalized()),
      normal_(x["normal"].vec3().normalized()),
      radius_(x["radius"]),
      tube_(x["tube"]),
      stiffness_(x["stiffness"]),
      damping_(x["damping"]),
      mu_(x["mu"]),
      longitudinal_(x["slipStiffness"]),
      cornering_(x["corneringStiffness"]),
      camber_(x["camberStiffness"]),
      slipDamping_(x["slipDamping"]),
      trail_(x["trail"]),
      relaxation_(x["relaxation"].vector()),
      shape_(x["curve"].vector()),
      trailShape_(x["trailCurve"].vector()) {
  if (x.name.empty())
    throw ModelError("the tyre has no name", "its slips are signals: add name=\"…\"");
  if (!height_.empty() && normal_ != Vec3::UnitZ())
    throw x["normal"].fault("a height counts along z of the road", "leave out normal", 0,
                            x["normal"].text.size());
  if (tube_ > radius_)
    throw x["tube"].fault("a tyre thicker than its wheel", "at most the radius: a ball", 0,
                          x["tube"].text.size());
  if (!(shape_[0] > 0.0 && shape_[0] < 2.0 && shape_[1] <= 1.0))
    throw x["curve"].fault("no magic formula of a tyre", "0 < C < 2 and E <= 1", 0,
                           x["curve"].text.size());
}

std::unique_ptr<PartialMechanicalSystem> Tyre::ownSystem() const {
  Parameters x;
  x.type = type(), x.name = name(), x.place = place();
  return std::make_unique<BlockStates>(x, std::vector<double>(2, 0.0),
                                       std::vector<std::string>{"longitudinalSlip", "lateralSlip"});
}

void Tyre::connect(Topology& topology) {
  frames_.connect(topology, *this);
  state_ = topology.system(name(), *this);
  height_.connect(topology, *this);
}

Vec3 Tyre::crown(const Vec3& axle, const Vec3& n) const {
  return NearestRoadPoint::crown(axle, radius_ - tube_, n);
}

Tyre::Road Tyre::road(const Kinematics& k) const {
  const Frame &W = k.frame(frames_.A), &B = k.frame(frames_.B);
  if (height_.empty()) return {B.A_IK * normal_, B.r_OS_I};
  const Vec3 c = B.A_IK.transpose() * (W.r_OS_I - B.r_OS_I);
  const Vec3 axle = B.A_IK.transpose() * (W.A_IK * axis_);
  const auto height = [&](double x, double y) {
    const double at[2] = {x, y};
    const double z = height_.value(k, at);
    return NearestRoadPoint::Height{z, height_.partial(0), height_.partial(1)};
  };
  const NearestRoadPoint::Point p =
      NearestRoadPoint(c, axle, radius_ - tube_, tube_, height).find();
  return {B.A_IK * p.n, B.r_OS_I + B.A_IK * p.r};
}

Tyre::Meeting Tyre::meeting(const Kinematics& k) const {
  const Frame &W = k.frame(frames_.A), &B = k.frame(frames_.B);
  const Road road = this->road(k);
  Meeting m;
  m.n = road.n;
  const Vec3 axle = W.A_IK * axis_;
  const double sine = axle.dot(m.n);
  const Vec3 across = axle - sine * m.n;
  const double cosine = across.norm();
  const bool lies = cosine < kLies;
  m.ey = lies ? Vec3(m.n.unitOrthogonal()) : Vec3(across / cosine);
  m.ex = m.ey.cross(m.n);
  m.gamma = std::atan2(sine, cosine);
  const Vec3 crown = this->crown(axle, m.n);
  const double height = m.n.dot(W.r_OS_I + crown - road.r_o);
  m.delta = lies ? -radius_ : tube_ - height;
  m.rho = crown - height * m.n;
  const Vec3 v = W.velocity(m.rho) - B.velocity(W.r_OS_I + m.rho - B.r_OS_I);
  // The contact does not turn with the wheel about its axle.
  const Vec3 contact = v - (W.Omega_I - B.Omega_I).dot(axle) * axle.cross(m.rho);
  m.deltaDot = -m.n.dot(v);
  m.vsx = m.ex.dot(v), m.vsy = m.ey.dot(v);
  m.Vx = m.ex.dot(contact), m.V = std::hypot(m.Vx, m.ey.dot(contact));
  return m;
}

double Tyre::curve(double p) const {
  const double C = shape_[0], E = shape_[1], x = p / C;
  return std::sin(C * std::atan(x - E * (x - std::atan(x))));
}

Tyre::Forces Tyre::forces(const Kinematics& k, const Meeting& m) const {
  const ConstVec s = k.u(state_);
  Forces f;
  if (m.delta > 0.0) f.N = std::max(0.0, stiffness_ * m.delta + damping_ * m.deltaDot);
  // In the air the carcass comes back to its shape.
  const bool touches = m.delta > 0.0;
  f.rate[0] = (-(touches ? m.vsx : 0.0) - m.V * s[0]) / relaxation_[0];
  f.rate[1] = (touches ? -m.vsy - m.V * (s[1] + camber_ / cornering_ * m.gamma) : -m.V * s[1]) /
              relaxation_[1];
  const double px = longitudinal_ / mu_ * (s[0] + slipDamping_ * f.rate[0]),
               py = cornering_ / mu_ * (s[1] + slipDamping_ * f.rate[1]), p = std::hypot(px, py);
  const double size = p > 0.0 ? mu_ * f.N * curve(p) / p : mu_ * f.N;
  f.Fx = size * px, f.Fy = size * py;
  // Behind the contact, where it travels; at rest there is no behind.
  const double behind = m.V > 0.0 ? m.Vx / m.V : 0.0;
  f.trail = behind * trail_ * std::cos(trailShape_[1] * std::atan(trailShape_[0] * p));
  return f;
}

void Tyre::addTo(const Kinematics& k, ForceSink& sink) const {
  const Frame &W = k.frame(frames_.A), &B = k.frame(frames_.B);
  const Meeting m = meeting(k);
  const Forces f = forces(k, m);
  for (int i = 0; i < 2; ++i) sink.generalised(state_, i, BlockStates::kMass * f.rate[i]);
  const Vec3 F = f.N * m.n + f.Fx * m.ex + f.Fy * m.ey, M = -f.trail * f.Fy * m.n;
  sink.force(W, m.rho, F), sink.moment(W, M);
  sink.force(B, W.r_OS_I + m.rho - B.r_OS_I, -F), sink.moment(B, -M);
}

void Tyre::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  const Frame &W = k.frame(frames_.A), &B = k.frame(frames_.B);
  const Meeting m = meeting(k);
  if (!(m.delta > 0.0)) return;
  sink.spring(W, m.rho, B, W.r_OS_I + m.rho - B.r_OS_I, m.n, stiffness_, damping_);
  for (int i = 0; i < 2; ++i)
    sink.entry(state_, i, i, 0.0, BlockStates::kMass * m.V / relaxation_[i]);
}

void Tyre::describe(Description& d) const {
  d.timeless = true;
  const auto number = [&](const char* name, Unit unit, const char* text, auto value) {
    d.signal(name, unit, text, [this, value](const SignalView& v) {
      const Meeting m = meeting(*v.kinematics);
      return value(m, forces(*v.kinematics, m));
    });
  };
  number("load", Unit::force, "N, of the road on the wheel",
         [](const Meeting&, const Forces& f) { return f.N; });
  number("longitudinalForce", Unit::force, "F_x on the wheel",
         [](const Meeting&, const Forces& f) { return f.Fx; });
  number("lateralForce", Unit::force, "F_y on the wheel, along its axle",
         [](const Meeting&, const Forces& f) { return f.Fy; });
  number("aligningMoment", Unit::torque, "on the wheel about the normal",
         [](const Meeting&, const Forces& f) { return -f.trail * f.Fy; });
  number("deflection", Unit::length, "of the carcass; negative: above the road",
         [](const Meeting& m, const Forces&) { return m.delta; });
  number("camber", Unit::angle, "positive: the axle points up from the road",
         [](const Meeting& m, const Forces&) { return m.gamma; });
  number("slip", Unit::none, "-v_sx/V; 0 at rest",
         [](const Meeting& m, const Forces&) { return m.V > 0.0 ? -m.vsx / m.V : 0.0; });
  number("sideslip", Unit::angle, "of the wheel's course from its plane; 0 at rest",
         [](const Meeting& m, const Forces&) { return std::atan2(m.vsy, std::abs(m.Vx)); });
}

}  // namespace dynamy
