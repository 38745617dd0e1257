#include "controls.hpp"

#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/rotation.hpp>

namespace dynamy::motorbike {
namespace {

/// Share of the torque that acts without braking.
constexpr double kDrag = 1e-6;

/// The Motorbike called `name`. Brake and rider act on its coordinates, so that a system of another
/// type is an error.
SystemHandle motorbikeNamed(const std::string& name, const Topology& topology,
                            const Element& asking) {
  const SystemHandle out = topology.system(name, asking);
  if (topology.systems()[static_cast<std::size_t>(out.index)]->type() != "Motorbike")
    throw ModelError(Diagnostic{.place = asking.place(),
                                .element = asking.type() + " name=\"" + asking.name() + '"',
                                .text = '"' + name + "\" is no Motorbike"});
  return out;
}

}  // namespace

void WheelBrake::declare(Attributes& a) {
  a.about(
      "Brake of a Motorbike's wheel: friction torque of at most M_b, which comes up within a rise "
      "time. "
      "It holds a wheel that stands.");
  a.reference("on", "system", "the Motorbike");
  a.choice("wheel", {"rear", "front"}, "front", "which wheel");
  a.required("torque", Unit::torque, "largest torque M_b").nonNegative();
  a.optional("start", Unit::time, 0.0, "when it begins");
  a.optional("rise", Unit::time, 0.1, "until it is full").positive();
  a.optional("end", Unit::time, 1e9, "when it is let go");
  a.example("<WheelBrake on=\"bike\" wheel=\"front\" torque=\"500\" start=\"1\"/>");
}

WheelBrake::WheelBrake(const Parameters& x)
    : NonSmoothElement(x),
      on_(x["on"].text),
      wheel_(x["wheel"].text == "rear" ? kRear : kFront),
      start_(x["start"]),
      rise_(x["rise"]),
      end_(x["end"]),
      law_(x["torque"], x["torque"]) {}

void WheelBrake::connect(Topology& topology) { system_ = motorbikeNamed(on_, topology, *this); }

void WheelBrake::contacts(const Kinematics& k, ContactSink& sink) const {
  // The pads always drag a little, because the status of a contact that comes and goes could not be
  // followed.
  const double ramp = k.t() < end_ ? std::clamp((k.t() - start_) / rise_, 0.0, 1.0) : 0.0;
  const double s = kDrag + (1.0 - kDrag) * ramp;
  ContactRows rows = sink.add(0, 0.0, law_, 1);
  if (!rows) return;
  rows.segment(system_)(0, wheel_) = s;
  const bool changes = ramp > 0.0 && ramp < 1.0;
  if (rows.wantsBias()) rows.bias(0) = changes ? (1.0 - kDrag) / rise_ * k.u(system_)[wheel_] : 0.0;
}

void WheelBrake::describe(Description& d) const { describeContact(d, 0, 1, law_, {}, kAllAngular); }

void RiderSteering::declare(Attributes& a) {
  a.about(
      "Rider of a Motorbike: a torque on the handlebar proportional to lean, its rate, steer, its "
      "rate "
      "and heading. Positive gains steer into the fall, and back.");
  a.reference("on", "system", "the Motorbike");
  a.optional("lean", Unit::torque, 0.0, "torque per radian of lean");
  a.optional("leanRate", Unit::rotationalDamping, 0.0, "torque per rate of lean");
  a.optional("steer", Unit::torque, 0.0, "torque per radian of steer, back to straight");
  a.optional("steerRate", Unit::rotationalDamping, 0.0, "torque per rate of steer, against it");
  a.optional("heading", Unit::torque, 0.0,
             "torque per radian of heading: steered the wrong way first, back to x");
  a.example("<RiderSteering on=\"bike\" lean=\"100\" leanRate=\"50\" steerRate=\"5\"/>");
}

RiderSteering::RiderSteering(const Parameters& x)
    : ExternalForce(x),
      on_(x["on"].text),
      lean_(x["lean"]),
      leanRate_(x["leanRate"]),
      steer_(x["steer"]),
      steerRate_(x["steerRate"]),
      heading_(x["heading"]) {}

void RiderSteering::connect(Topology& topology) { system_ = motorbikeNamed(on_, topology, *this); }

void RiderSteering::addTo(const Kinematics& k, ForceSink& sink) const {
  const ConstVec q = k.q(system_), u = k.u(system_);
  const Mat3 A = rotationMatrix(q.data() + 3);
  const double lean = std::asin(A(2, 1)), heading = std::atan2(A(1, 0), A(0, 0));
  sink.generalised(system_, kSteer,
                   -lean_ * lean - leanRate_ * u[kOmega] - steer_ * q[kSteer + 1] -
                       steerRate_ * u[kSteer] + heading_ * heading);
}

}  // namespace dynamy::motorbike
