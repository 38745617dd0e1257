/// Small elements for tests of the reader: one of each kind that a model needs.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/system/external_force.hpp>
#include <stdexcept>

namespace dynamy::dummy {

/// A ball on a vertical line; a formula of its own is checked when it is made.
class Ball final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a) {
    a.about("A ball on a vertical line: m u' = h.");
    a.required("mass", Unit::mass, "mass of the ball").positive();
    a.optional("z", Unit::length, 1.0, "height at the start");
    a.vector("velocity", Unit::velocity, 3, "0 0 0", "velocity at the start");
    a.vector("orientation", Unit::none, 4, "1 0 0 0", "quaternion").notZero();
    a.add(AttributeType::expression, "drive", "0", "force over t");
    a.child(Kind::shape, 0, 3, "what it looks like");
    a.example("<Ball name=\"b\" mass=\"1kg\"><Disc radius=\"0.1\"/></Ball>");
  }
  explicit Ball(const Parameters& x)
      : PartialMechanicalSystem(x),
        mass_(x["mass"]),
        z_(x["z"]),
        drive(x["drive"].text),
        shapes(x.take<Shape>()) {
    if (const std::size_t at = drive.find("??"); at != std::string::npos)
      throw x["drive"].fault("two question marks", "leave them out", at, 2);
    if (drive == "crash") throw std::runtime_error("no table of drives");
    if (drive == "misspelt") drive = x["dirve"].text;
  }
  Blocks blocks() const override { return {1, 1, 1, true}; }
  void initialState(Vec q, Vec u) const override { q[0] = z_, u[0] = 0.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0](0, 0) = mass_; }
  void h(double, ConstVec, ConstVec, Vec h) const override { h[0] = 0.0; }
  void describe(Description& d) const override {
    d.coordinate("z", Unit::length, 0);
    d.velocity("vz", Unit::velocity, 0);
  }

 private:
  double mass_, z_;

 public:
  std::string drive;
  std::vector<std::unique_ptr<Shape>> shapes;
};

class Disc final : public Shape {
 public:
  static void declare(Attributes& a) {
    a.required("radius", Unit::length, "radius of the disc").positive();
  }
  explicit Disc(const Parameters& x) : Shape(x) {}
  ShapeGeometry geometry() const override {
    return {.type = ShapeType::circle, .points = {}, .colour = {}};
  }
};

class Weight final : public ExternalForce {
 public:
  static void declare(Attributes& a) {
    a.vector("acceleration", Unit::acceleration, 3, "0 0 -9.81", "acceleration of gravity");
  }
  explicit Weight(const Parameters& x) : ExternalForce(x) {}
  void connect(Topology&) override {}
  void addTo(const Kinematics&, ForceSink&) const override {}
};

class Law final : public Element {
 public:
  static constexpr Kind kKind = Kind::law;
  static void declare(Attributes& a) {
    a.optional("mu", Unit::none, 0.0, "coefficient of friction").nonNegative();
  }
  explicit Law(const Parameters& x) : Element(x), mu(x["mu"]) {}
  double mu;
};

/// Contact of a system; refuses the friction 13 when it is connected.
class Stop final : public NonSmoothElement {
 public:
  static void declare(Attributes& a) {
    a.reference("on", "system", "the system that is stopped");
    a.add(AttributeType::names, "frames", "", "frames").referenceKind = "frame";
    a.child(Kind::law, 1, 1, "law of the contact");
  }
  explicit Stop(const Parameters& x)
      : NonSmoothElement(x), on(x["on"].text), frames(x["frames"].text) {
    law = std::move(x.take<Law>().front());
  }
  void connect(Topology&) override {
    if (law->mu == 13.0) throw ModelError("no contact likes mu = 13", "take another");
  }
  void contacts(const Kinematics&, ContactSink&) const override {}
  std::string on, frames;
  std::unique_ptr<Law> law;
};

inline Registry registry() {
  Registry r;
  r.library("dummies");
  r.add<Ball>("Ball");
  r.add<Disc>("Disc");
  r.add<Weight>("Weight");
  r.add<Law>("Law");
  r.add<Stop>("Stop");
  return r;
}

}  // namespace dynamy::dummy
