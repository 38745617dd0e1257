/// Observers see every percussion of a run, whatever clocks the bodies have: Newton's second law for two
/// balls and for a cradle, whose percussions are known in closed form.
#include <gtest/gtest.h>

#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>
#include <string>

namespace dynamy::reference {
namespace {

/// Σ Λ_N over all contacts and steps [N s].
class NormalPercussions final : public Observer {
 public:
  void step(const StepView& v) override {
    const InclusionProblem& p = v.system.problem();
    for (int i = 0; i < p.size(); ++i)
      if (p.law(i).rowKind(0) == RowKind::normal) sum += v.Lambda[p.row0(i)];
  }
  double sum = 0.0;
};

double percussions(const std::string& text) {
  Scene scene("percussions", {.text = text});
  NormalPercussions seen;
  Simulation s(scene.model());
  s.observe(seen);
  EXPECT_EQ(s.run().ended, RunReport::Ended::finished);
  return seen.sum;
}

std::string twoBalls(double gap, double epsilon, const std::string& simulation) {
  return R"(<dynamy version="1"><systems>
    <PointMass name="a" velocity="1 0 0" mass="1"><Sphere radius="0.1" material="s"/></PointMass>
    <PointMass name="b" position=")" +
         numberText(0.2 + gap) + R"( 0 0" mass="1"><Sphere radius="0.1" material="s"/></PointMass>
    </systems><elements><Contact between="s s"><Unilateral epsilonN=")" +
         numberText(epsilon) + R"("/></Contact></elements><simulation until="1" )" + simulation +
         "</dynamy>";
}

TEST(PercussionSum, IsTheMomentumThatOneBallGivesAnother) {
  // Λ = m_1 m_2/(m_1 + m_2) (1 + ε) v, also where the balls touch at the start. Fixed steps take the
  // impact as it is; located ones to rounding.
  for (const double gap : {0.3, 0.0})
    for (const double epsilon : {0.0, 1.0})
      for (const char* simulation :
           {R"(tolerance="1e-8"/>)",
            R"(tolerance="1e-8"><LocatedDormandPrince clocks="one"/></simulation>)",
            R"(tolerance="1e-8"><LocatedGragg/></simulation>)", R"(step="1e-3"/>)"})
        EXPECT_NEAR(percussions(twoBalls(gap, epsilon, simulation)), 0.5 * (1.0 + epsilon), 1e-12)
            << gap << ' ' << epsilon << ' ' << simulation;
}

TEST(PercussionSum, HoldsThoseOfBallsThatTheImpactPassesThrough) {
  // Five balls that touch: the impact of one goes through four contacts, m v each; and so it does on
  // its way back from the wall, where two go into the wall.
  std::string text = R"(<dynamy version="1"><systems><Ground name="wall">
    <HalfSpace position="0.6 0 0" euler="0 -90deg 0" material="w"/></Ground>)";
  for (int i = 0; i < 5; ++i)
    text += "<PointMass name=\"b" + std::to_string(i) + "\" position=\"" +
            numberText(0.1 * i - (i == 0 ? 0.1 : 0.0)) + R"( 0 0" velocity=")" +
            (i == 0 ? "1" : "0") +
            R"( 0 0" mass="2"><Sphere radius="0.05" material="s"/></PointMass>)";
  text += R"(</systems><elements><Contact between="s s"><Unilateral epsilonN="1"/></Contact>
    <Contact between="s w"><Unilateral epsilonN="1"/></Contact></elements>
    <simulation until="0.6" tolerance="1e-9"><SequentialImpact/></simulation></dynamy>)";
  EXPECT_NEAR(percussions(text), 2.0 * (4.0 + 2.0 + 4.0), 1e-10);
}

}  // namespace
}  // namespace dynamy::reference
