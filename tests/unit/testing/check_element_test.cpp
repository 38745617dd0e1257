// The checker of user elements: right elements pass, each kind of mistake is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/testing/check_element.hpp>

namespace dynamy {
namespace {

/// What a toy gets wrong.
enum class Mistake {
  none,
  asymmetric,
  indefinite,
  unwritten,
  gyroscopic,
  damper,
  bias,
  jacobian,
  constant
};

/// Double pendulum of point masses, absolute angles; the frame sits at the lower mass.
///   M = m l² [2, cos(a−b); cos(a−b), 1],  h = m l² sin(a−b) (−ω_b², ω_a²) − m g l (2 sin a, sin b)
class DoublePendulum final : public PartialMechanicalSystem {
 public:
  explicit DoublePendulum(Mistake mistake = Mistake::none) : mistake_(mistake) {}
  Blocks blocks() const override {
    return {.nq = 2, .nu = 2, .constantMass = mistake_ == Mistake::constant};
  }
  void initialState(Vec q, Vec u) const override { q << 0.7, -0.4, u << 0.3, 1.1; }
  void M(double, ConstVec q, MassBlocks M) const override {
    const double c = std::cos(q[0] - q[1]);
    M[0] << 2.0, c, mistake_ == Mistake::asymmetric ? c + 0.1 : c, 1.0;
    if (mistake_ == Mistake::indefinite) M[0](0, 0) = 0.1;
  }
  void h(double, ConstVec q, ConstVec u, Vec h) const override {
    const double s = std::sin(q[0] - q[1]);
    h[0] = -s * u[1] * u[1] - 2.0 * kG * std::sin(q[0]);
    if (mistake_ != Mistake::unwritten)
      h[1] = (mistake_ == Mistake::gyroscopic ? -s : s) * u[0] * u[0] - kG * std::sin(q[1]);
    if (mistake_ == Mistake::damper) h[0] -= 0.2 * u[0];
  }
  double potentialEnergy(double, ConstVec q) const override {
    return -kG * (2.0 * std::cos(q[0]) + std::cos(q[1]));
  }
  int frames() const override { return 1; }
  void frame(double, ConstVec q, ConstVec u, int, Frame& f) const override {
    const double sa = std::sin(q[0]), ca = std::cos(q[0]), sb = std::sin(q[1]), cb = std::cos(q[1]);
    f.r_OS_I = {sa + sb, -ca - cb, 0.0};
    f.A_IK = Eigen::AngleAxisd(q[1], Vec3::UnitZ()).toRotationMatrix();
    f.J_S_I.col(0) = Vec3(ca, mistake_ == Mistake::jacobian ? -sa : sa, 0.0);
    f.J_S_I.col(1) = Vec3(cb, sb, 0.0);
    f.J_R_I.col(1) = Vec3::UnitZ();
    f.v_S_I = f.J_S_I * u, f.Omega_I = f.J_R_I * u;
    f.bias_S_I = Vec3(-sa, ca, 0.0) * u[0] * u[0] + Vec3(-sb, cb, 0.0) * u[1] * u[1];
    if (mistake_ == Mistake::bias) f.bias_S_I *= -1.0;
  }

 private:
  static constexpr double kG = 9.81;
  Mistake mistake_;
};

/// Rigid body with quaternion; `exact`: moves by the exponential map.
class Top final : public PartialMechanicalSystem {
 public:
  explicit Top(bool exact) : exact_(exact) {}
  Blocks blocks() const override { return {.nq = 4, .nu = 3, .constantMass = true}; }
  void initialState(Vec q, Vec u) const override { q << 1, 0, 0, 0, u << 0.5, 2.0, -1.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0] = I_.asDiagonal(); }
  void h(double, ConstVec, ConstVec u, Vec h) const override {
    const Vec3 Omega = u;
    h = -Omega.cross(I_.cwiseProduct(Omega));
  }
  void qdot(double, ConstVec q, ConstVec u, Vec qdot) const override {
    quaternionRate(q.data(), Vec3(u), qdot.data());
  }
  void move(double t, Vec q, ConstVec u, double dt) const override {
    if (exact_)
      rotate(q.data(), dt * Vec3(u));
    else
      PartialMechanicalSystem::move(t, q, u, dt);
  }
  void normalise(Vec q) const override { q /= q.norm(); }

 private:
  bool exact_;
  Vec3 I_{1.0, 2.0, 3.0};
};

/// Bead on a line.
class Bead final : public PartialMechanicalSystem {
 public:
  explicit Bead(const Parameters& x) : PartialMechanicalSystem(x) {}
  static void declare(Attributes&) {}
  Blocks blocks() const override { return {.nq = 1, .nu = 1, .constantMass = true}; }
  void initialState(Vec q, Vec u) const override { q[0] = 0.3, u[0] = 1.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0](0, 0) = 2.0; }
  void h(double, ConstVec, ConstVec, Vec h) const override { h[0] = 0.0; }
  void describe(Description& d) const override { d.velocity("speed", Unit::velocity, 0); }
};

/// Wall at d(t) = 0.3 + 0.1 sin 5t: g = d − x², curved on purpose.
class MovingWall final : public SimpleContact {
 public:
  static void declare(Attributes& a) {
    a.optional("chi", Unit::none, 1.0, "1: right; else a mistake in χ");
    a.optional("w", Unit::none, 1.0, "1: right; else a mistake in W");
  }
  explicit MovingWall(const Parameters& x) : SimpleContact(x), chi_(x["chi"]), w_(x["w"]) {}
  double g(double t, ConstVec q) const override {
    return 0.3 + 0.1 * std::sin(5.0 * t) - q[0] * q[0];
  }
  void gamma(double t, ConstVec q, ConstVec u, Vec gamma) const override {
    gamma[0] = chi_ * 0.5 * std::cos(5.0 * t) - w_ * 2.0 * q[0] * u[0];
  }

 private:
  double chi_, w_;
};

/// g = √(0.05 − x): no number where the bead begins.
class RootWall final : public SimpleContact {
 public:
  static void declare(Attributes&) {}
  explicit RootWall(const Parameters& x) : SimpleContact(x) {}
  double g(double, ConstVec q) const override { return std::sqrt(0.05 - q[0]); }
  void gamma(double, ConstVec, ConstVec u, Vec gamma) const override { gamma[0] = -u[0]; }
};

/// Contacts of which one exists all the time and one comes and goes with the sign of t; `wrong`: a
/// factor on γ of the first.
class FlickeringWall final : public NonSmoothElement {
 public:
  static void declare(Attributes& a) { a.optional("wrong", Unit::none, 1.0, "factor on gamma"); }
  explicit FlickeringWall(const Parameters& x) : NonSmoothElement(x), wrong_(x["wrong"]) {}
  void connect(Topology&) override {}
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    for (int i = 0; i < (k.t() > 0.01 ? 2 : 1); ++i) {
      ContactRows rows = sink.add(static_cast<std::uint64_t>(i), k.t(), law_, 1);
      if (!rows) continue;
      rows.chi(0) = wrong_;
      if (rows.wantsBias()) rows.bias(0) = 0.0;
    }
  }

 private:
  Unilateral law_;
  double wrong_;
};

Verdict checkWall(double chi, double w) {
  Model model;
  model.add<Bead>("bead", {});
  model.add<MovingWall>("wall", {{"on", "bead"}, {"chi", chi}, {"w", w}});
  model.build();
  return checkModel(model);
}

/// C = [0, ∞) with a factor in the projection or in its derivative.
class OddLaw final : public SetValuedForceLaw {
 public:
  OddLaw(double projection, double derivative) : projection_(projection), derivative_(derivative) {}
  int dim(int) const override { return 1; }
  bool unilateral() const override { return true; }
  RowKind rowKind(int) const override { return RowKind::normal; }
  void prox(const LawInput&, const double* r, const double* xi, double* Lambda) const override {
    Lambda[0] = projection_ * std::max(0.0, Lambda[0] - r[0] * xi[0]);
  }
  bool proxDerivative(const LawInput&, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override {
    const double P = Lambda[0] - rho * xi[0] > 0.0 ? derivative_ : 0.0;
    A[0] = 1.0 - P, B[0] = rho * P;
    return true;
  }
  Status status(const LawInput&, const double* z) const override {
    return z[0] > 0.0 ? Status::slip : Status::separating;
  }

 private:
  double projection_, derivative_;
};

/// Friction of 2 N/(1 + |γ^A|), with a factor in its simple set, with a part of the slip in prox, and with
/// or without the scale.
class SlipLaw final : public SetValuedForceLaw {
 public:
  SlipLaw(double set, double slip, bool scales) : set_(set), slip_(slip), scales_(scales) {}
  int dim(int) const override { return 1; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  bool scales() const override { return true; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override {
    const double most = radius(in, slip_);
    Lambda[0] = std::clamp(Lambda[0] - r[0] * xi[0], -most, most);
  }
  SimpleSet simpleSet(const LawInput& in) const override {
    const double most = set_ * radius(in, 1.0);
    return {SimpleSet::Shape::interval, -most, most};
  }
  Status status(const LawInput& in, const double* z) const override {
    return std::abs(z[0]) > radius(in, slip_) ? Status::slip : Status::stick;
  }

 private:
  double radius(const LawInput& in, double slip) const {
    return (scales_ ? in.scale : 1.0) * in.dt * 2.0 / (1.0 + slip * std::abs(in.gammaA[0]));
  }
  double set_, slip_;
  bool scales_;
};

bool says(const Verdict& check, const std::string& text) {
  return check.message().find(text) != std::string::npos;
}

TEST(CheckSystem, AcceptsADoublePendulum) {
  const Verdict check = checkSystem(DoublePendulum());
  EXPECT_TRUE(check) << check.message();
}

TEST(CheckSystem, AcceptsABodyThatTurnsByTheExponentialMap) {
  const Verdict check = checkSystem(Top(true));
  EXPECT_TRUE(check) << check.message();
}

TEST(CheckSystem, NamesTheEntryOfAnAsymmetricMassMatrix) {
  const Verdict check = checkSystem(DoublePendulum(Mistake::asymmetric));
  // cos(1.1) = 0.45359612142…
  EXPECT_EQ(check.message(),
            "system: M[1,0] = 0.553596121 but M[0,1] = 0.453596121: not symmetric");
}

TEST(CheckSystem, ReportsAnIndefiniteMassMatrix) {
  EXPECT_TRUE(says(checkSystem(DoublePendulum(Mistake::indefinite)), "not positive definite"));
}

TEST(CheckSystem, ReportsAMassThatIsNotConstantAsDeclared) {
  EXPECT_TRUE(says(checkSystem(DoublePendulum(Mistake::constant)), "says constantMass"));
}

TEST(CheckSystem, ReportsEntriesThatAreNotWritten) {
  EXPECT_TRUE(says(checkSystem(DoublePendulum(Mistake::unwritten)), "h[1] = nan: not written"));
}

TEST(CheckSystem, ReportsGyroscopicForcesThatFeedPower) {
  EXPECT_TRUE(says(checkSystem(DoublePendulum(Mistake::gyroscopic)), "do not fit"));
}

TEST(CheckSystem, ReportsADamperThatIsNotStatedAsNonPotential) {
  EXPECT_TRUE(says(checkSystem(DoublePendulum(Mistake::damper)), "do not fit"));
}

TEST(CheckSystem, ReportsAWrongJacobian) {
  EXPECT_TRUE(says(checkSystem(DoublePendulum(Mistake::jacobian)), "dr_OS/dt"));
}

TEST(CheckSystem, ReportsAWrongBias) {
  EXPECT_TRUE(says(checkSystem(DoublePendulum(Mistake::bias)), "frame 0: bias_S_I[0]"));
}

TEST(CheckSystem, ReportsAMoveThatLeavesTheUnitQuaternions) {
  EXPECT_TRUE(says(checkSystem(Top(false)), "right after move"));
}

TEST(CheckContacts, AcceptsAMovingCurvedWall) {
  const Verdict check = checkWall(1.0, 1.0);
  EXPECT_TRUE(check) << check.message();
}

// At the start t = 0, x = 0.3: dg/dt = 0.5 − 0.6 u.
TEST(CheckContacts, ReportsAWrongChi) {
  const Verdict check = checkWall(0.5, 1.0);
  EXPECT_TRUE(says(check, "wall: gamma_N")) << check;
  EXPECT_TRUE(says(check, "wall: chi_N = 0.25 m/s, but dg/dt at u = 0 is 0.5 m/s")) << check;
  EXPECT_FALSE(says(check, "W_N")) << check;
}

TEST(CheckContacts, ReportsAWrongW) {
  const Verdict check = checkWall(1.0, -1.0);
  EXPECT_TRUE(says(check, "wall: gamma_N")) << check;
  EXPECT_TRUE(says(check, "wall: W_N of bead.speed = 0.6, but it changes dg/dt by -0.6")) << check;
  EXPECT_FALSE(says(check, "chi_N")) << check;
}

TEST(CheckContacts, NamesAnEntryThatIsNotFinite) {
  EXPECT_TRUE(says(checkWall(1.0, 1e308), "wall: W[0,bead.speed] = "));
}

TEST(CheckContacts, ListsAContactThatComesAndGoesAndComparesTheOthers) {
  for (const double wrong : {1.0, 2.0}) {
    Model model;
    model.add<Bead>("bead", {});
    model.add<FlickeringWall>("wall", {{"wrong", wrong}});
    model.build();
    const Verdict check = checkContacts(model);
    EXPECT_EQ(bool(check), wrong == 1.0) << check;
    EXPECT_EQ(says(check, "wall: gamma_N = Wᵀu + chi = 2 m/s"), wrong != 1.0) << check;
  }
}

TEST(CheckContacts, ListsWhatIsNeverMet) {
  struct Never final : NonSmoothElement {
    explicit Never(const Parameters& x) : NonSmoothElement(x) {}
    static void declare(Attributes&) {}
    void connect(Topology&) override {}
    void contacts(const Kinematics&, ContactSink&) const override {}
  };
  Model model;
  model.add<Bead>("bead", {});
  model.add(std::make_unique<Never>(Parameters::of<Never>("Never", "never", {})));
  model.build();
  const Verdict check = checkModel(model);
  EXPECT_TRUE(check) << check;
  ASSERT_EQ(check.uncompared().size(), 1u);
  EXPECT_EQ(check.uncompared()[0], "never: no contact of it is met near the start");
}

TEST(CheckContacts, NamesAGapThatIsNoNumber) {
  Model model;
  model.add<Bead>("bead", {});
  model.add<RootWall>("wall", {{"on", "bead"}});
  model.build();
  EXPECT_TRUE(says(checkModel(model), "wall: g is not a number"));
}

TEST(CheckModel, TakesAFileThatCannotBeReadForAFault) {
  Registry registry;
  PluginLoader plugins;
  EXPECT_TRUE(says(checkModel("no_such_model.xml", registry, plugins), "no_such_model.xml"));
}

TEST(CheckLaw, AcceptsTheStandardLaws) {
  for (const int dim : {1, 2, 3}) {
    const Verdict coulomb = checkLaw(UnilateralCoulomb(0.5, 0.2, 0.4), dim);
    EXPECT_TRUE(coulomb) << dim << " rows: " << coulomb.message();
    const Verdict given = checkLaw(GivenFriction(2.0, 1.5), dim);
    EXPECT_TRUE(given) << dim << " rows: " << given.message();
    const Verdict joint = checkLaw(Bilateral(), dim);
    EXPECT_TRUE(joint) << dim << " rows: " << joint.message();
  }
  const Verdict unilateral = checkLaw(Unilateral(0.3), 1);
  EXPECT_TRUE(unilateral) << unilateral.message();
}

TEST(CheckLaw, ReportsAProxThatIsNotIdempotent) {
  EXPECT_TRUE(says(checkLaw(OddLaw(0.5, 0.5), 1), "not idempotent"));
}

TEST(CheckLaw, ReportsAWrongDerivative) {
  EXPECT_TRUE(says(checkLaw(OddLaw(1.0, 0.5), 1), "proxDerivative: A[0,0]"));
}

TEST(CheckLaw, ComparesTheSimpleSetWithProx) {
  const Verdict right = checkLaw(SlipLaw(1.0, 1.0, true), 1);
  EXPECT_TRUE(right) << right.message();
  EXPECT_TRUE(says(checkLaw(SlipLaw(2.0, 1.0, true), 1), "simpleSet and prox are two laws"));
  EXPECT_TRUE(says(checkLaw(SlipLaw(1.0, 0.0, true), 1), "simpleSet and prox are two laws"));
}

TEST(CheckLaw, ReportsAScaleThatIsNotUsed) {
  EXPECT_TRUE(says(checkLaw(SlipLaw(1.0, 1.0, false), 1), "LawInput::scale = 2"));
}

TEST(CheckLaw, ReportsRowsTheLawDoesNotAccept) {
  EXPECT_TRUE(says(checkLaw(Unilateral(), 2), "does not accept its own rows"));
}

}  // namespace
}  // namespace dynamy
