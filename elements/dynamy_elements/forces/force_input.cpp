#include <dynamy_elements/forces/force_input.hpp>
#include <dynamy_elements/frame_pair.hpp>

namespace dynamy {

void ForceInput::declare(Attributes& a) {
  a.about(
      "Force and moment on a point of a frame, as formulas of the time t and of signals of the "
      "model.");
  a.reference("on", "frame", "frame the force acts on: a system, or system.frame");
  a.vector("point", Unit::length, 3, "0 0 0", "point of attack, in axes of the frame");
  a.choice("axes", {"world", "frame"}, "world", "axes of the components");
  a.add(AttributeType::expressions, "force", std::nullopt,
        "Fx; Fy; Fz as formulas of t and signals")
      .in(Unit::force)
      .mayBeAbsent();
  a.add(AttributeType::expressions, "moment", std::nullopt,
        "Mx; My; Mz as formulas of t and signals")
      .in(Unit::torque)
      .mayBeAbsent();
  a.example("<ForceInput on=\"cart\" force=\"10*sin(3*t); 0; 0\"/>");
}

ForceInput::ForceInput(const Parameters& x)
    : ExternalForce(x),
      on_(x["on"].text),
      point_(x["point"].vec3()),
      bodyAxes_(x["axes"].text == "frame"),
      force_(x, "force", 3),
      moment_(x, "moment", 3) {
  if (force_.empty() && moment_.empty())
    throw ModelError("neither a force nor a moment is given", "add force=\"Fx; Fy; Fz\"");
}

void ForceInput::connect(Topology& topology) {
  frame_ = topology.frame(on_, *this);
  requireMoving(topology, frame_, on_);
  force_.connect(topology, *this), moment_.connect(topology, *this);
}

void ForceInput::addTo(const Kinematics& k, ForceSink& sink) const {
  const Frame& frame = k.frame(frame_);
  Vec3 F = Vec3::Zero(), M = Vec3::Zero();
  force_.eval(k, F.data());
  moment_.eval(k, M.data());
  if (bodyAxes_) F = frame.A_IK * F, M = frame.A_IK * M;
  sink.force(frame, frame.A_IK * point_, F);
  sink.moment(frame, M);
}

}  // namespace dynamy
