// The motorbike of models/parts, composed of nine bodies: with everything locked it is the vehicle of
// four bodies whose eigenvalues are known, and in the air it falls.
#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <dynamy/system/read_signals.hpp>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

TEST(MotorbikeOfParts, HasTheEigenvaluesOfFourBodiesWhileItIsLocked) {
  // The closed form of the linear equations at 8 m/s, as models/motorbike.xml: the same masses and
  // inertias, split among more bodies. Sharp wheels.
  LoadedModel m("tests/data/motorbike/coast.xml");
  const Linearisation l = linearise(m.model(), m.model().initialState());
  ASSERT_EQ(l.eigenvalues.size(), 4);
  const std::array<std::complex<double>, 4> known{{{-23.115275125, 0.0},
                                                   {-2.02925695381, 4.49726353297},
                                                   {-2.02925695381, -4.49726353297},
                                                   {-0.461457263449, 0.0}}};
  for (const std::complex<double>& z : known) {
    double nearest = 1.0;
    for (const std::complex<double>& found : l.eigenvalues)
      nearest = std::min(nearest, std::abs(found - z));
    EXPECT_LT(nearest, 1e-9) << z;  // twelve digits of 23
  }
}

TEST(MotorbikeOfParts, MovesOnItsSpringsWhereItIsNotLocked) {
  // Friction of no force holds nothing: bounce and pitch on springs and dampers, the rider's lean, the
  // head's twist.
  LoadedModel m("tests/data/motorbike/coast.xml", {{"bike/locked", "0"}});
  const Linearisation l = linearise(m.model(), m.model().initialState());
  EXPECT_EQ(l.eigenvalues.size(), 12);
  EXPECT_EQ(l.growing(), 0);
}

TEST(MotorbikeOfParts, TwistsItsHeadOnASpring) {
  // What a stiffer head changes of wobble goes as 1/k: from 1e7 to 2e7 Nm/rad twice as much as from
  // 2e7 to 4e7, and what is left at 34 100 Nm/rad is that much larger, to second order in 1/k.
  const auto slowest = [](const char* k) {
    LoadedModel m("tests/data/motorbike/coast.xml", {{"bike/locked", "0"}, {"bike/kTwist", k}});
    const Linearisation l = linearise(m.model(), m.model().initialState());
    std::complex<double> out(1e9, 0.0);
    for (const std::complex<double>& z : l.eigenvalues)
      if (std::abs(z - std::complex<double>(-2.0, 4.5)) <
          std::abs(out - std::complex<double>(-2.0, 4.5)))
        out = z;
    return out;
  };
  const std::complex<double> a = slowest("1e7"), b = slowest("2e7"), c = slowest("4e7"),
                             real = slowest("34100");
  EXPECT_LT(std::abs((a - b) / (b - c) - 2.0), 1e-3);  // differences of 1e-6, known to 1e-10
  const std::complex<double> stiff = 2.0 * c - b, slope = (a - b) * 2e7;
  EXPECT_NEAR(std::abs((real - stiff) * 34100.0 / slope), 1.0, 0.2);
}

TEST(MotorbikeOfParts, FallsAsAPointInTheAir) {
  // Both wheels are in the air from 0.9 to 1.4 s: the centre of mass of all bodies has Sz(t+d) − 2 Sz(t) +
  // Sz(t−d) = −g d², with the error of a scheme of order 2 in steps of 0.5 ms, (0.5 ms)² × 10 1/s² × 13 m.
  LoadedModel loaded("models/motorbike_jump.xml");
  Model& model = loaded.model();
  model.simulation.until = 1.3;
  model.checks.clear();
  const NamedSignal* Sz = model.signal("Sz.out");
  ASSERT_NE(Sz, nullptr);
  const auto height = [&](const State& x) {
    Kinematics k;
    k.evaluate(model.topology(), x.t, view(x.q), view(x.u), view(x.memory));
    ReadSignals table;
    table.bind({{0, Sz->signal.value, Sz->system, {Sz->memory0, Sz->memory}}});
    return table.value({0}, k);
  };
  HandStepper s(model);
  std::array<double, 3> z{};
  for (int i = 0, k = 0; i <= 2600; ++i) {
    if (i == 1800 || i == 2200 || i == 2600) z[static_cast<std::size_t>(k++)] = height(s.x);
    s.step(5e-4);
  }
  EXPECT_NEAR(z[2] - 2.0 * z[1] + z[0], -9.81 * 0.2 * 0.2, 3.3e-5);
}

}  // namespace
}  // namespace dynamy
