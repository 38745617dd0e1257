#include <cmath>
#include <dynamy/dynamy.hpp>
using namespace dynamy;

/// g = d − l sin φ ≥ 0: the bob may not pass the wall x = d [m].
class PendulumWall final : public SimpleContact {
 public:
  static void declare(Attributes& a) {
    a.required("length", Unit::length, "pendulum length").positive();
    a.required("distance", Unit::length, "distance of the wall");
  }
  explicit PendulumWall(const Parameters& x)
      : SimpleContact(x), l_(x["length"]), d_(x["distance"]) {}
  double g(double, ConstVec q) const override { return d_ - l_ * std::sin(q[0]); }
  void gamma(double, ConstVec q, ConstVec u, Vec gamma) const override {
    gamma[0] = -l_ * std::cos(q[0]) * u[0];
  }

 private:
  double l_, d_;
};
static void registerElements(Registry& r) { r.add<PendulumWall>("PendulumWall"); }
DYNAMY_PLUGIN("pendulum_wall", "1.0.0", registerElements)
