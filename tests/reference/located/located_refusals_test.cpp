// What runs to a tolerance cannot follow they refuse by the contact that comes or goes.
#include <gtest/gtest.h>

#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

const std::string kFeatures =
    ": which features of two bodies could touch (corners over faces, rims over edges, faces of a "
    "mesh that are nearest to a ball) is another list after every motion, and its gap cannot be "
    "followed; give a step instead of the tolerance";

/// Why a run of the model to 1e-5 is refused.
std::string reason(const std::string& model) {
  LocatedRun run(model, 1e-5, 1.0);
  EXPECT_EQ(run.run().ended, RunReport::Ended::failed) << model;
  EXPECT_TRUE(run.report().refused) << model;
  return run.report().reason;
}

void expectRefused(const std::string& model, const std::string& contact) {
  const std::string text = reason(model);
  EXPECT_NE(text.find(" refuses: contact " + contact), std::string::npos) << text;
  EXPECT_NE(text.find(kFeatures), std::string::npos) << text;
}

TEST(LocatedRefusals, NameARimOverAnEdge) { expectRefused("kerb", "wheel-road#2.edge9-rim"); }

TEST(LocatedRefusals, NameAFaceOfAMeshUnderABall) {
  expectRefused("column_collapse", "balls#110-floor.face");
}

TEST(LocatedRefusals, NameACornerOverAMesh) { expectRefused("mixed_pile", "b2-bowl.B.corner19"); }

/// An element that takes its contact back without a word.
class Curtain final : public SimpleContact {
 public:
  static void declare(Attributes&) {}
  explicit Curtain(const Parameters& x) : SimpleContact(x) {}
  double g(double, ConstVec q) const override { return q[0]; }
  void gamma(double, ConstVec, ConstVec u, Vec gamma) const override { gamma[0] = u[0]; }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    if (k.t() < 0.5) SimpleContact::contacts(k, sink);
  }
};

TEST(LocatedRefusals, NameAnElementThatReportsItsContactNowAndThen) {
  LocatedRun run(
      R"xml(<dynamy version="1"><systems><Coordinates name="body" q="x" q0="1" M="1" h="-1"/>
      </systems><elements><Curtain name="curtain" on="body"/></elements>
      <simulation until="1" step="1"/></dynamy>)xml",
      1e-5, 1.0, {}, [](Registry& r) { r.add<Curtain>("Curtain"); });
  EXPECT_EQ(run.run().ended, RunReport::Ended::failed);
  EXPECT_NE(run.report().reason.find("contact curtain is no longer reported: <Curtain> reports it "
                                     "at some positions only"),
            std::string::npos)
      << run.report().reason;
}

TEST(LocatedRefusals, SpareBarsThatPassTheirFlatPosition) {
  // One of 14 rows is redundant there (truth S02, extended precision), and beside it the bars are a
  // hundred times as fast as at the start. Velocities of the start times 1 + 1e-5 move the crank by
  // 2.3e-5 m in these 10 s: K = 2.3.
  constexpr double kTip = 0.32845811154124, K = 2.3;
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7}) {
    LocatedRun bars("four_bar", tolerance, 10.0);
    ASSERT_EQ(bars.run().ended, RunReport::Ended::finished) << bars.report().reason;
    EXPECT_NEAR(bars.state().q[0], 0.5 * kTip, 10.0 * K * tolerance) << tolerance;
  }
}

}  // namespace
}  // namespace dynamy::reference
