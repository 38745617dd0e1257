// Bodies at rest that steps leave out: when they fall asleep, what they cost, what wakes them, and
// what a run says of them (theory 58).
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

constexpr double kRadius = 0.05;  ///< of all balls [m]
constexpr double kWeight = 0.2 * 9.81;

/// A scene on a floor, from text with the standard elements.
class SleepScene {
 public:
  struct Given {
    std::string systems, forces = {}, elements = {};
    std::string sleep = "1e-6";  ///< [m/s]; empty: nothing sleeps
    double until = 0.3;
    std::string scheme = {}, law = "<UnilateralCoulomb mu=\"0.5\"/>",
                floor = "<HalfSpace material=\"m\"/>", motion = {};
    std::string gravity = "<Gravity/>", record = {}, more = {};
  };
  explicit SleepScene(const Given& g) : plugins_({DYNAMY_BINARY_DIR "/lib/dynamy"}) {
    registerFramework(registry_);
    plugins_.load(kStandardElements, registry_);
    const std::string sleep = g.sleep.empty() ? "" : " sleep=\"" + g.sleep + "\"";
    const std::string text =
        "<dynamy version=\"1\"><systems>" + g.systems + "<Ground name=\"floor\"" + g.motion + ">" +
        g.floor + "</Ground></systems><forces>" + g.gravity + g.forces +
        "</forces><elements><Contact between=\"m m\">" + g.law + "</Contact>" + g.elements +
        "</elements>" + g.record + "<simulation until=\"" + numberText(g.until) +
        "\" step=\"1ms\"" + sleep + ">" + g.scheme + "</simulation>" + g.more + "</dynamy>";
    model_ = std::make_unique<Model>(loadModelText(text, "sleep.xml", registry_, plugins_));
    run_ = std::make_unique<Simulation>(*model_);
  }
  Simulation& run() { return *run_; }
  const SleepReport& asleep() const { return run_->report().cost.sleep; }
  ConstVec q(const std::string& name) {
    const SystemHandle s = handle(name);
    return {run_->state().q.data() + s.q0, s.nq};
  }
  ConstVec u(const std::string& name) {
    const SystemHandle s = handle(name);
    return {run_->state().u.data() + s.u0, s.nu};
  }

 private:
  SystemHandle handle(const std::string& name) {
    return model_->topology().system(name, *model_->systems().front());
  }
  Registry registry_;
  PluginLoader plugins_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Simulation> run_;
};

std::string ball(const std::string& name, double x, double y, double z,
                 const std::string& more = {}) {
  return "<RigidBody name=\"" + name + "\" position=\"" + numberText(x) + " " + numberText(y) +
         " " + numberText(z) + "\" " + more +
         "><Sphere radius=\"0.05\" mass=\"0.2\" material=\"m\"/></RigidBody>";
}

/// A pyramid of ten balls that touch, their lowest centres about (x, y).
std::string pile(const std::string& name, double x, double y) {
  const double d = 2.0 * kRadius, up = d * std::sqrt(2.0 / 3.0), deep = d * std::sqrt(3.0) / 2.0;
  std::string out;
  int count = 0;
  for (int layer = 0; layer < 3; ++layer)
    for (int i = 0; i < 3 - layer; ++i)
      for (int j = 0; j < 3 - layer - i; ++j)
        out += ball(name + std::to_string(count++), x + d * (j + 0.5 * i + 0.5 * layer),
                    y + deep * (i + layer / 3.0), kRadius + layer * up);
  return out;
}

const char* const kRolling = "<UnilateralRolling mu=\"0.5\" rolling=\"0.5mm\"/>";
const std::string kBall = ball("b", 0.0, 0.0, kRadius);

/// Keeps the pictures and the events of systems.
class Pictures final : public RecordSink {
 public:
  void row(double, std::span<const double>) override {}
  void frame(FilmInstant at, std::span<const FramePose>,
             std::span<const ContactRecord> contacts) override {
    last.assign(contacts.begin(), contacts.end()), lastTime = at.t;
  }
  void event(const ContactEvent& e) override {
    if (e.of == ContactEvent::Of::sleep) asleep.push_back(e.t);
    if (e.of == ContactEvent::Of::wake) woken.push_back(e.t);
    if (e.of == ContactEvent::Of::contact && !e.impact) ++switches;
  }
  std::vector<ContactRecord> last;
  double lastTime = 0.0;
  std::vector<double> asleep, woken;
  int switches = 0;
};

TEST(Sleep, BallsAtRestTakeNoMoreInclusions) {
  std::string balls;
  for (int i = 0; i < 5; ++i) balls += ball("b" + std::to_string(i), 0.3 * i, 0.0, kRadius);
  SleepScene scene({.systems = balls});
  const RunReport& r = scene.run().run();
  EXPECT_EQ(scene.asleep().asleep, 5);
  EXPECT_EQ(r.solver.solves, Sleep::kSteps);
  // They fall asleep after kSteps steps, each of which takes up to two evaluations, and the first
  // one looks for joints; two more are the trials, and one finds that nothing is awake.
  EXPECT_LE(r.cost.evaluations, Sleep::kSteps + 8);
  EXPECT_EQ(scene.asleep().saved, 5 * (r.steps - Sleep::kSteps));
}

TEST(Sleep, NothingSleepsUnlessTheModelSaysSo) {
  for (const char* sleep : {"", "0"}) {
    SleepScene scene({.systems = kBall, .sleep = sleep});
    const RunReport& r = scene.run().run();
    EXPECT_EQ(r.cost.sleep.slept, 0);
    EXPECT_EQ(r.solver.solves, r.steps);
  }
}

TEST(Sleep, OfEverySchemeThatOffersItKeepsThePosition) {
  for (const char* scheme : {"<MoreauMidpoint/>", "<StaggeredMoreau/>", "<EnergyMomentum/>"}) {
    SleepScene scene({.systems = kBall, .scheme = scheme});
    scene.run().run();
    EXPECT_EQ(scene.asleep().asleep, 1) << scheme;
    EXPECT_NEAR(scene.q("b")[2], kRadius, 1e-15) << scheme;  // rounding
  }
}

TEST(Sleep, PileFallsAsleepAsOneAndKeepsItsBitsForAnHour) {
  SleepScene scene({.systems = pile("a", 0.0, 0.0), .until = 3600.0, .law = kRolling});
  while (scene.asleep().asleep == 0 && scene.run().step()) {
  }
  EXPECT_EQ(scene.asleep().asleep, 10);
  EXPECT_LT(scene.run().state().t, 0.1);
  const Eigen::VectorXd q = scene.run().state().q;
  EXPECT_TRUE(scene.run().state().u.isZero(0.0));
  const RunReport& r = scene.run().run();
  EXPECT_EQ(r.t, 3600.0);
  EXPECT_EQ(scene.run().state().q, q);
  EXPECT_TRUE(scene.run().state().u.isZero(0.0));
}

TEST(Sleep, EnergyTakenStandsInTheLedger) {
  SleepScene scene({.systems = pile("a", 0.0, 0.0), .law = kRolling});
  const RunReport& r = scene.run().run();
  ASSERT_EQ(r.cost.sleep.asleep, 10);
  EXPECT_GE(r.cost.sleep.energy, 0.0);
  EXPECT_EQ(r.energy.boundaries, -r.cost.sleep.energy);
  EXPECT_EQ(r.energy.kineticEnd, 0.0);
  // What an island may have left: 1e-8 of 0.01 m/s in each of ten balls.
  EXPECT_LT(r.cost.sleep.energy, 10.0 * 0.5 * 0.2 * 1e-20);
}

/// Momentum of all balls, each of 0.2 kg.
Vec3 momentum(const Eigen::VectorXd& u) {
  Vec3 p = Vec3::Zero();
  for (Eigen::Index i = 0; i < u.size(); i += 6) p += 0.2 * u.segment<3>(i);
  return p;
}

/// Two piles; a ball flies 0.7 m at 3 m/s while they fall asleep, and hits one of them.
SleepScene::Given hitPiles(const std::string& sleep) {
  return {.systems = pile("a", 0.0, 0.0) + pile("b", 2.0, 0.0) +
                     ball("hits", -0.7, 0.03, 0.35, "velocity=\"3 0 0\""),
          .sleep = sleep,
          .until = 0.28,
          .law = kRolling};
}

TEST(Sleep, PileThatIsHitMovesLikeOneKeptAwake) {
  SleepScene asleep(hitPiles("1e-6")), awake(hitPiles(""));
  asleep.run().run(), awake.run().run();
  EXPECT_EQ(asleep.asleep().slept, 20);
  EXPECT_EQ(asleep.asleep().woken, 10);
  EXPECT_EQ(asleep.asleep().asleep, 10);
  // Inclusions are solved to 1e-8 of 3 m/s, and the impact spreads over a pile within 30 steps.
  EXPECT_LT((asleep.run().state().u - awake.run().state().u).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((asleep.run().state().q - awake.run().state().q).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_GT(awake.run().state().u.cwiseAbs().maxCoeff(), 0.1);
}

TEST(Sleep, HitOnSleepingBallKeepsTheMomentum) {
  // On a floor without friction the sum of horizontal momenta stays 0.2 kg · 1.5 m/s to rounding.
  const std::string bodies = ball("rests", 0.0, 0.0, kRadius) + ball("rests2", 0.11, 0.0, kRadius) +
                             ball("hits", -0.3, 0.01, kRadius, "velocity=\"1.5 0 0\"");
  SleepScene scene(
      {.systems = bodies, .until = 0.5, .law = "<UnilateralCoulomb mu=\"0\" epsilonN=\"0.4\"/>"});
  scene.run().run();
  EXPECT_EQ(scene.asleep().woken, 2);
  EXPECT_NEAR(momentum(scene.run().state().u).x(), 0.3, 1e-12);
  EXPECT_NEAR(momentum(scene.run().state().u).y(), 0.0, 1e-12);
}

TEST(Sleep, FastBallDoesNotPassSleepingOnesUnseen) {
  // In a step it flies 1 m, twenty radii.
  SleepScene scene({.systems = ball("rests", 0.0, 0.0, kRadius) +
                               ball("hits", -30.5, 0.01, kRadius, "velocity=\"1000 0 0\""),
                    .until = 0.05,
                    .law = "<UnilateralCoulomb mu=\"0\" epsilonN=\"1\"/>"});
  scene.run().run();
  EXPECT_EQ(scene.asleep().woken, 1);
  EXPECT_GT(scene.u("rests")[0], 100.0);
}

TEST(Sleep, RunResumedWhileBodiesSleepIsTheStraightRun) {
  SleepScene straight(hitPiles("1e-6"));
  const RunReport& whole = straight.run().run();
  // Before anything sleeps, in the middle of the flight, in the impact and after it.
  for (const double at : {0.01, 0.1, 0.2105, 0.25}) {
    SleepScene first(hitPiles("1e-6")), rest(hitPiles("1e-6"));
    while (first.run().state().t < at && first.run().step()) {
    }
    rest.run().resume(first.run().archived());
    const RunReport& r = rest.run().run();
    EXPECT_EQ(r.hash, whole.hash) << at;
    EXPECT_EQ(rest.run().state().q, straight.run().state().q) << at;
    EXPECT_EQ(rest.run().state().u, straight.run().state().u) << at;
    EXPECT_EQ(r.cost.sleep.saved, whole.cost.sleep.saved) << at;
    EXPECT_EQ(r.cost.sleep.woken, whole.cost.sleep.woken) << at;
    EXPECT_EQ(r.contacts.switches, whole.contacts.switches) << at;
    EXPECT_EQ(r.energy.boundaries, whole.energy.boundaries) << at;
  }
}

TEST(Sleep, PicturesShowTheForcesOfSleepingBodies) {
  SleepScene scene({.systems = kBall + ball("flies", 1.0, 0.0, 2.0)});
  Pictures pictures;
  scene.run().record(pictures);
  scene.run().run();
  ASSERT_EQ(scene.asleep().asleep, 1);
  EXPECT_EQ(pictures.lastTime, 0.3);
  ASSERT_EQ(pictures.last.size(), 1U);
  EXPECT_NEAR(pictures.last[0].force.norm(), kWeight, 1e-8 * kWeight);  // accuracy of inclusions
  EXPECT_NEAR(pictures.last[0].point.norm(), 0.0, 1e-15);
  EXPECT_EQ(pictures.last[0].status, Status::stick);
  EXPECT_FALSE(pictures.last[0].impact);
}

TEST(Sleep, FallingAsleepAndWakingAreEventsAndNoSwitches) {
  SleepScene scene(hitPiles("1e-6"));
  Pictures pictures;
  scene.run().record(pictures);
  while (pictures.asleep.size() < 20 && scene.run().step()) {
  }
  const int settling = pictures.switches;
  int atRest = settling;
  while (pictures.woken.empty()) {
    atRest = pictures.switches;
    ASSERT_TRUE(scene.run().step());
  }
  EXPECT_EQ(atRest, settling);
  EXPECT_EQ(pictures.woken.size(), 10U);
  EXPECT_GT(pictures.woken[0], 0.15);
  EXPECT_GT(pictures.switches, settling);  // contacts of the pile that is hit
}

/// Counts the contacts that steps show.
class ContactCount final : public Observer {
 public:
  explicit ContactCount(bool reads) : reads_(reads) {}
  bool readsContacts() const override { return reads_; }
  void step(const StepView& v) override { last = v.system.slot(0).contacts.size(); }
  int last = -1;

 private:
  bool reads_;
};

TEST(Sleep, ObserversOfContactsKeepBodiesAwake) {
  for (const bool reads : {true, false}) {
    SleepScene scene({.systems = kBall});
    ContactCount count(reads);
    scene.run().observe(count);
    scene.run().run();
    EXPECT_EQ(count.last, reads ? 1 : 0);
    EXPECT_EQ(scene.asleep().asleep, reads ? 0 : 1);
    EXPECT_EQ(scene.asleep().reason, reads ? "an observer reads contacts" : "");
  }
}

struct Moving {
  const char* name;
  SleepScene::Given given;
};

class StaysAwake : public testing::TestWithParam<Moving> {};

/// Bodies that are slower than `sleep` all the time, or for long enough.
TEST_P(StaysAwake, HoweverSlowItIs) {
  SleepScene::Given asleep = GetParam().given, awake = asleep;
  awake.sleep = {};
  SleepScene scene(asleep), same(awake);
  scene.run().run(), same.run().run();
  EXPECT_EQ(scene.asleep().slept, 0);
  EXPECT_EQ(scene.run().state().q, same.run().state().q);
  EXPECT_EQ(scene.run().state().u, same.run().state().u);
}

const char* const kBox = "><Box size=\"0.1 0.1 0.1\" mass=\"1\" material=\"m\"/></RigidBody>";

const Moving kMoving[] = {
    // 5e-9 m/s: after an hour it is 18 µm further.
    {"BallRollsSlowly",
     {.systems = ball("b", 0, 0, kRadius, "velocity=\"5e-9 0 0\" angularVelocity=\"0 1e-7 0\"")}},
    {"BallSpinsSlowly", {.systems = ball("b", 0, 0, kRadius, "angularVelocity=\"0 0 1e-7\"")}},
    {"BlockSlidesWithoutFriction",
     {.systems =
          std::string("<RigidBody name=\"b\" position=\"0 0 0.05\" velocity=\"1e-8 0 0\"") + kBox,
      .law = "<UnilateralCoulomb mu=\"0\"/>"}},
    {"BallIsAtTheTopOfItsFlight",
     {.systems = ball("b", 0, 0, 0.3, "velocity=\"0 0 1\""), .sleep = "1", .until = 0.2}},
    {"BallFloatsWithoutGravity",
     {.systems = ball("b", 0, 0, 0.3, "velocity=\"0 0 1e-8\""), .gravity = ""}},
    // tan 0.1 = 0.1003 against 0.1: a block that stands would slip.
    {"BlockSlipsOnSlope",
     {.systems = std::string("<RigidBody name=\"b\" position=\"0 0 0.05\"") + kBox,
      .sleep = "1",
      .law = "<UnilateralCoulomb mu=\"0.1\"/>",
      .gravity = "<Gravity acceleration=\"0.9793666 0 -9.7609909\"/>"}},
    {"BallLeansAgainstNothing",
     {.systems = ball("b", 0, 0, kRadius) + ball("c", 1e-7, 0, 3 * kRadius),
      .sleep = "1",
      .until = 0.1}},
    {"FloorMovesLater",
     {.systems = kBall, .until = 0.3, .motion = " motion=\"0; 0; 0.1*max(0, t-0.2)^2\""}},
    {"FieldTurnsLater",
     {.systems = kBall, .gravity = "<Gravity change=\"2*max(0, t-0.2); 0; 0\"/>"}},
    {"ForceActsLater",
     {.systems = kBall, .forces = "<ForceInput on=\"b\" force=\"2*max(0, t-0.2); 0; 0\"/>"}},
    {"WindBlowsLater",
     {.systems = kBall,
      .forces = "<Drag on=\"b\" viscous=\"1\" wind=\"10*max(0, t-0.2); 0; 0\"/>"}},
    {"CarriagePullsADamperLater",
     {.systems =
          kBall + "<Ground name=\"carriage\" position=\"0.5 0 0\" motion=\"max(0, t-0.2); 0; 0\"/>",
      .forces =
          "<SpringDamper between=\"carriage b\" stiffness=\"0\" damping=\"1\" length=\"0\"/>"}},
    {"NeighbourIsPulled",
     {.systems = kBall + ball("c", 0, 0, 3 * kRadius),
      .forces = "<ForceInput on=\"c\" force=\"0; 0; -2*max(0, t-0.2)\"/>"}},
};

INSTANTIATE_TEST_SUITE_P(Sleep, StaysAwake, testing::ValuesIn(kMoving),
                         [](const auto& p) { return p.param.name; });

TEST(Sleep, BodiesBesideThoseThatMayMoveSleepAllTheSame) {
  SleepScene scene({.systems = kBall + ball("c", 0.5, 0, kRadius),
                    .forces = "<ForceInput on=\"c\" force=\"max(0, t-0.2); 0; 0\"/>"});
  scene.run().run();
  EXPECT_EQ(scene.asleep().asleep, 1);
  EXPECT_TRUE(scene.u("b").isZero(0.0));
  EXPECT_GT(scene.u("c")[0], 0.01);
}

TEST(Sleep, RollingBallThatFrictionStopsFallsAsleepThen) {
  // Rolling resistance stops 0.05 m/s after 0.05/(5/7 · 9.81 · 0.01) s = 0.71 s.
  SleepScene scene(
      {.systems = ball("b", 0, 0, kRadius, "velocity=\"0.05 0 0\" angularVelocity=\"0 1 0\""),
       .sleep = "1",
       .until = 1.0,
       .law = kRolling});
  Pictures pictures;
  scene.run().record(pictures);
  scene.run().run();
  ASSERT_EQ(pictures.asleep.size(), 1U);
  const double stops = 0.05 / (5.0 / 7.0 * 9.81 * 0.0005 / kRadius);
  // Islands are looked for every kSteps steps.
  EXPECT_NEAR(pictures.asleep[0], stops, (Sleep::kSteps + 1) * 1e-3);
  EXPECT_NEAR(scene.q("b")[0], 0.5 * 0.05 * stops, 0.05 * 1e-3);  // a step's way
}

TEST(Sleep, RecordedContactForcesKeepBodiesAwake) {
  SleepScene scene({.systems = kBall, .record = "<record signals=\"contacts.count\"/>"});
  scene.run().run();
  EXPECT_EQ(scene.asleep().slept, 0);
  EXPECT_NE(scene.asleep().reason.find("of a contact is read"), std::string::npos);
}

}  // namespace
}  // namespace dynamy
