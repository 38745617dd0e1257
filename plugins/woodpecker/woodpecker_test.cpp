// The woodpecker as a plug-in and as formulas has the same equations and the same motion.
#include <gtest/gtest.h>

#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/schemes/moreau_midpoint.hpp>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

/// M, h and all contacts of a model at q, u.
struct Equations {
  RowMatrix M = RowMatrix::Zero(3, 3);
  Eigen::Vector3d h;
  double V = 0.0;
  ContactSet contacts;

  Equations(Model& model, const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
    const PartialMechanicalSystem& s = *model.systems().at(0);
    s.M(0.0, view(q), MassBlocks(M.data(), 3, 1));
    s.h(0.0, view(q), view(u), Vec(h.data(), 3));
    V = s.potentialEnergy(0.0, view(q));
    Kinematics k;
    k.resize(model.topology());
    k.evaluate(model.topology(), 0.0, view(q), view(u));
    contacts.clear();
    const ContactRequest request{1e9, true, {}, false};  // all contacts closed
    ContactSink sink(contacts, request);
    for (std::size_t i = 0; i < model.contacts().size(); ++i) {
      sink.element(static_cast<int>(i));
      model.contacts()[i]->contacts(k, sink);
    }
  }
};

void expectNear(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(Woodpecker, PluginAndFormulasHaveTheSameEquations) {
  LoadedModel plugin("models/woodpecker.xml"), formulas("models/woodpecker_expressions.xml");
  const Eigen::VectorXd q = Eigen::Vector3d(-0.01, 0.07, -0.31), u = Eigen::Vector3d(-0.2, 9, -5);
  const Equations a(plugin.model(), q, u), b(formulas.model(), q, u);
  // Rounding of a few operations: M up to 5e-3, h up to 5e-2, V 1e-3, g and W up to 1.
  EXPECT_LE((a.M - b.M).lpNorm<Eigen::Infinity>(), 1e-18);
  EXPECT_LE((a.h - b.h).lpNorm<Eigen::Infinity>(), 1e-17);
  EXPECT_NEAR(a.V, b.V, 1e-18);
  ASSERT_EQ(a.contacts.size(), 3);
  expectNear(a.contacts.g, b.contacts.g, 1e-17);
  expectNear(a.contacts.W, b.contacts.W, 1e-15);
  expectNear(a.contacts.chi, b.contacts.chi, 0.0);
  expectNear(a.contacts.bias, b.contacts.bias, 0.0);
}

TEST(Woodpecker, PluginAndFormulasMoveAlikeForATenthOfASecond) {
  LoadedModel plugin("models/woodpecker.xml"), formulas("models/woodpecker_expressions.xml");
  plugin.model().scheme(std::make_unique<MoreauMidpoint>());  // as the model with formulas
  HandStepper a(plugin.model()), b(formulas.model());
  // 10 000 steps with two impacts; equal except for the rounding of h (1e-16 relative per step).
  double difference = 0.0;
  for (int i = 0; i < 10000; ++i) {
    a.step(1e-5), b.step(1e-5);
    difference = std::max(difference, (a.x.q - b.x.q).lpNorm<Eigen::Infinity>());
  }
  EXPECT_LE(difference, 1e-12);
}

TEST(Woodpecker, FramesOfPluginAndFormulasAgree) {
  LoadedModel plugin("models/woodpecker.xml"), formulas("models/woodpecker_expressions.xml");
  const Eigen::VectorXd q = Eigen::Vector3d(-0.01, 0.07, -0.31), u = Eigen::Vector3d(-0.2, 9, -5);
  const auto evaluated = [&](Model& model) {
    Kinematics k;
    Topology all(model.topology().systems());
    for (int f = 0; f < 3; ++f) all.frame(all.system(0), f);
    k.resize(all);
    k.evaluate(all, 0.0, view(q), view(u));
    return k;
  };
  const Kinematics a = evaluated(plugin.model()), b = evaluated(formulas.model());
  for (int f = 0; f < 3; ++f) {
    const Frame &x = a.frame({f}), &y = b.frame({f});
    EXPECT_LE((x.r_OS_I - y.r_OS_I).norm(), 1e-16) << f;
    EXPECT_LE((x.A_IK - y.A_IK).norm(), 1e-15) << f;
    EXPECT_LE((x.v_S_I - y.v_S_I).norm(), 1e-15) << f;
    EXPECT_LE((x.Omega_I - y.Omega_I).norm(), 1e-14) << f;
    EXPECT_LE((x.J_S_I - y.J_S_I).norm(), 1e-15) << f;
    EXPECT_LE((x.J_R_I - y.J_R_I).norm(), 1e-15) << f;
    EXPECT_LE((x.bias_S_I - y.bias_S_I).norm(), 1e-15) << f;
  }
}

TEST(Woodpecker, ChecksOfBothModelsHold) {
  for (const char* file : {"models/woodpecker.xml", "models/woodpecker_expressions.xml"}) {
    SCOPED_TRACE(file);
    LoadedModel toy(file);
    Simulation simulation(toy.model());
    EXPECT_EQ(simulation.run().ended, RunReport::Ended::finished);
    expectChecksHold(simulation);
  }
}

TEST(Woodpecker, ParametersCanBeSetFromOutside) {
  // Without friction nothing holds the sleeve: it continues to fall after the first cycle.
  LoadedModel free("models/woodpecker.xml", {{"mu", "0"}});
  HandStepper s(free.model());
  for (int i = 0; i < 2000; ++i) s.step(1e-4);
  EXPECT_LT(s.x.q[0], -0.2);  // ½ g t² + 0.34 t = 0.264 m minus the loss in impacts
}

}  // namespace
}  // namespace dynamy
