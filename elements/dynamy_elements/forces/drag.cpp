#include <dynamy/system/description.hpp>
#include <dynamy_elements/forces/drag.hpp>
#include <dynamy_elements/frame_pair.hpp>

namespace dynamy {

void Drag::declare(Attributes& a) {
  a.about(
      "Drag of a fluid on a point of a body: F = -rho c A |v| v/2 - d v, with v the velocity "
      "against the wind. Signal: force.");
  a.reference("on", "frame", "frame the force acts on: a system, or system.frame");
  a.vector("point", Unit::length, 3, "0 0 0", "point of attack, in axes of the frame");
  a.optional("area", Unit::none, 0.0, "area A across the motion [m^2]").nonNegative();
  a.optional("coefficient", Unit::none, 1.0, "drag coefficient c").nonNegative();
  a.optional("density", Unit::density, 1.2, "density rho of the fluid; default: air").nonNegative();
  a.optional("viscous", Unit::damping, 0.0, "linear drag d, e.g. 6 pi eta r of a small ball")
      .nonNegative();
  a.add(AttributeType::expressions, "wind", std::nullopt,
        "velocity of the fluid x; y; z as formulas of t; default: still")
      .in(Unit::velocity)
      .mayBeAbsent();
  a.example("<Drag on=\"ball\" area=\"0.03\" coefficient=\"0.47\" wind=\"5; 0; 0\"/>");
}

Drag::Drag(const Parameters& x)
    : ExternalForce(x),
      on_(x["on"].text),
      point_(x["point"].vec3()),
      quadratic_(0.5 * double(x["density"]) * double(x["coefficient"]) * double(x["area"])),
      linear_(x["viscous"]),
      wind_(x, "wind", 3) {
  // An area of 0 that is written is a part's parameter: without drag unless it is set.
  if (!x["area"].given && linear_ == 0.0)
    throw ModelError("there is no drag", "add area=\"…\" or viscous=\"…\"");
}

void Drag::connect(Topology& topology) {
  frame_ = topology.frame(on_, *this);
  requireMoving(topology, frame_, on_);
}

Vec3 Drag::force(const Kinematics& k) const {
  const Frame& f = k.frame(frame_);
  Vec3 wind = Vec3::Zero();
  if (!wind_.empty()) wind_.eval(k.t(), wind.data());
  const Vec3 v = f.velocity(f.A_IK * point_) - wind;
  return -(quadratic_ * v.norm() + linear_) * v;
}

void Drag::addTo(const Kinematics& k, ForceSink& sink) const {
  const Frame& f = k.frame(frame_);
  sink.force(f, f.A_IK * point_, force(k));
}

void Drag::describe(Description& d) const {
  d.timeless = wind_.empty();
  d.signal("force", Unit::force, "size of the drag",
           [this](const SignalView& v) { return force(*v.kinematics).norm(); });
  TimeFormulas::announce(d, {&wind_});
}

}  // namespace dynamy
