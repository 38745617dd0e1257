#include <cmath>
#include <dynamy/dynamy.hpp>
using namespace dynamy;

/// g = d − l sin φ ≥ 0: the bob may not pass the wall x = d [m].
class PendulumWall final : public SimpleContact {  // q, u: those of the one system it is `on`
 public:
  static void declare(Attributes& a) {  // reader, describe, schema, "did you mean" come from here
    a.about("Wall that stops the bob of a pendulum: g = d - l sin(phi).");
    a.required("length", Unit::length, "pendulum length").positive();
    a.required("distance", Unit::length, "distance of the wall from the pivot");
  }
  explicit PendulumWall(const Parameters& x)
      : SimpleContact(x), l_(x["length"]), d_(x["distance"]) {}
  double g(double, ConstVec q) const override { return d_ - l_ * std::sin(q[0]); }
  void gamma(double, ConstVec q, ConstVec u, Vec gamma) const override {
    gamma[0] = -l_ * std::cos(q[0]) * u[0];  // ġ
  }

 private:
  double l_, d_;
};

static void registerElements(Registry& r) { r.add<PendulumWall>("PendulumWall"); }
DYNAMY_PLUGIN("pendulum_wall", "1.0.0", registerElements)
