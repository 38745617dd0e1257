/// Small scenes for the tests of simulation: a ball in the x–z plane over a floor, a spring,
/// systems that go wrong, a sink in memory. Truth is closed form everywhere.
#pragma once
#include <cmath>
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/schemes/half_explicit_euler.hpp>
#include <dynamy/schemes/moreau_midpoint.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/solver/prox_solvers.hpp>
#include <limits>
#include <support/table.hpp>

namespace dynamy::scenes {

inline constexpr double kGravity = 10.0;  // [m/s²]

/// Point mass of 1 kg: q = (x, z), u = (vx, vz), V = g z.
class Ball final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a) {
    a.optional("z", Unit::length, 1.0, "start height");
    a.optional("vx", Unit::velocity, 0.0, "start velocity");
    a.optional("drag", Unit::damping, 0.0, "h_x = -drag vx");
  }
  explicit Ball(const Parameters& x)
      : PartialMechanicalSystem(x), z_(x["z"]), vx_(x["vx"]), drag_(x["drag"]) {}
  Blocks blocks() const override { return {2, 2, 1, true}; }
  void initialState(Vec q, Vec u) const override { q[0] = 0.0, q[1] = z_, u[0] = vx_, u[1] = 0.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0].setIdentity(); }
  void h(double, ConstVec, ConstVec u, Vec h) const override {
    h[0] = -drag_ * u[0], h[1] = -kGravity;
  }
  void nonPotentialForce(double, ConstVec, ConstVec u, Vec h) const override {
    h[0] = -drag_ * u[0], h[1] = 0.0;
  }
  double potentialEnergy(double, ConstVec q) const override { return kGravity * q[1]; }
  void describe(Description& d) const override {
    d.coordinate("x", Unit::length, 0);
    d.coordinate("z", Unit::length, 1);
    d.velocity("vx", Unit::velocity, 0);
    d.velocity("vz", Unit::velocity, 1);
  }

 private:
  double z_, vx_, drag_;
};

/// Floor z ≥ 0 with the law given as a child.
class Floor final : public SimpleContact {
 public:
  static void declare(Attributes& a) {
    a.optional("belt", Unit::velocity, 0.0, "velocity of the floor along x");
  }
  explicit Floor(const Parameters& x) : SimpleContact(x), belt_(x["belt"]) {}
  double g(double, ConstVec q) const override { return q[1]; }
  int rows() const override { return 2; }
  void gamma(double, ConstVec, ConstVec u, Vec gamma) const override {
    gamma[0] = u[1], gamma[1] = u[0] - belt_;
  }

 private:
  double belt_;
};

/// q̈ = −sin q with M = 1: V = 1 − cos q.
class Pendulum final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes&) {}
  explicit Pendulum(const Parameters& x) : PartialMechanicalSystem(x) {}
  Blocks blocks() const override { return {1, 1, 1, true}; }
  void initialState(Vec q, Vec u) const override { q[0] = 1.0, u[0] = 0.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0].setIdentity(); }
  void h(double, ConstVec q, ConstVec, Vec h) const override { h[0] = -std::sin(q[0]); }
  double potentialEnergy(double, ConstVec q) const override { return 1.0 - std::cos(q[0]); }
  void describe(Description& d) const override {
    d.coordinate("phi", Unit::angle, 0);
    d.velocity("omega", Unit::angularVelocity, 0);
  }
};

/// Goes wrong at t = 0.5: the force is not a number, the mass is negative, or it throws.
class Broken final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a) {
    a.choice("what", {"force", "mass", "throws"}, "force", "fault");
  }
  explicit Broken(const Parameters& x)
      : PartialMechanicalSystem(x),
        mass_(x["what"].text == "mass"),
        throws_(x["what"].text == "throws") {}
  Blocks blocks() const override { return {1, 1, 1, false}; }
  void initialState(Vec q, Vec u) const override { q[0] = u[0] = 0.0; }
  void M(double t, ConstVec, MassBlocks M) const override {
    M[0](0, 0) = mass_ && t > 0.5 ? -1.0 : 1.0;
  }
  void h(double t, ConstVec, ConstVec, Vec h) const override {
    if (throws_ && t > 0.5) throw std::out_of_range("beyond the table");
    h[0] = !mass_ && t > 0.5 ? std::numeric_limits<double>::quiet_NaN() : 1.0;
  }

 private:
  bool mass_, throws_;
};

/// A contact law that throws as soon as anything closes.
class ThrowingLaw final : public SetValuedForceLaw {
 public:
  static void declare(Attributes&) {}
  explicit ThrowingLaw(const Parameters& x) : SetValuedForceLaw(x) {}
  int dim(int) const override { return 1; }
  bool unilateral() const override { return true; }
  RowKind rowKind(int) const override { return RowKind::normal; }
  void prox(const LawInput&, const double*, const double*, double*) const override {
    throw 42;  // not even a std::exception
  }
  Status status(const LawInput&, const double*) const override { return Status::open; }
};

inline void addBall(Model& m, const std::string& name, double z, double vx = 0.0) {
  m.add<Ball>(name, {{"z", z}, {"vx", vx}});
}

inline void addFloor(Model& m, const std::string& name, const std::string& on, double epsilonN,
                     double mu, double belt = 0.0) {
  Parameters p = Parameters::of<Floor>({}, name, {{"on", on}, {"belt", belt}});
  p.children.push_back({Kind::law, std::make_unique<UnilateralCoulomb>(epsilonN, 0.0, mu)});
  m.add(std::make_unique<Floor>(p));
}

/// Not built: a ball `name` over its own floor.
inline Model ballOnFloor(double z, double vx, double epsilonN, double mu, double until,
                         double step) {
  Model m;
  addBall(m, "ball", z, vx);
  addFloor(m, "floor", "ball", epsilonN, mu);
  m.simulation.until = until, m.simulation.step = step;
  return m;
}

}  // namespace dynamy::scenes
