/// Time of the gap of an ellipsoid to a polyhedron, or to a round body, at random placements.
///
///   bench_gaps [N]     mean over N placements [µs]; default 20000
#include <chrono>
#include <cstdlib>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <dynamy_elements/contacts/shapes/convex_hull.hpp>
#include <iostream>
#include <random>
#include <vector>

namespace {

using namespace dynamy;

/// Placements of two bodies a few sizes apart; 3 % overlap.
class Placements {
 public:
  double number() { return uniform_(random_); }
  Vec3 vec() { return {number(), number(), number()}; }
  Frame frame(const Vec3& at) {
    Frame f;
    double p[4] = {1, 0, 0, 0};
    rotate(p, 3.0 * vec());
    f.r_OS_I = at, f.A_IK = rotationMatrix(p), f.v_S_I = vec(), f.Omega_I = vec();
    return f;
  }
  SupportFeature ellipsoid() {
    SupportFeature f;
    f.kind = SupportFeature::Kind::ellipsoid, f.c_K = 0.2 * vec();
    const Vec3 semi = Vec3::Constant(0.1) + 0.4 * vec().cwiseAbs();
    f.square_K = semi.cwiseAbs2().asDiagonal();
    return f;
  }
  Polyhedron polyhedron(int corners) {
    std::vector<Vec3> points, hull;
    for (int i = 0; i < corners; ++i) points.push_back(0.5 * vec());
    for (const Triangle& t : convexHull(points))
      for (const int i : t) hull.push_back(points[static_cast<std::size_t>(i)]);
    return Polyhedron(hull);
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

/// Cylinder, torus, capsule, cone, by turns.
DiscBody roundBody(const Frame& f, int kind) {
  const double half[] = {0.3, 0.0, 0.3, 0.3}, rho[] = {0.3, 0.3, 0.0, 0.3},
               r[] = {0.0, 0.1, 0.2, 0.0};
  return {&f, f.r_OS_I, f.A_IK.col(2), f.A_IK.col(0), half[kind], rho[kind], r[kind], kind == 3};
}

}  // namespace

int main(int argc, char** argv) {
  using Clock = std::chrono::steady_clock;
  const int n = argc > 1 ? std::atoi(argv[1]) : 20000;
  Placements random;
  Clock::duration ofRound{}, ofPolyhedra{};
  double sum = 0.0;  // so that nothing is left out
  for (int i = 0; i < n; ++i) {
    const Frame A = random.frame(random.vec());
    const Frame B = random.frame(A.r_OS_I + (i % 3 == 0 ? 1.2 : 2.5) * random.vec());
    const SupportFeature feature = random.ellipsoid();
    const Polyhedron body = random.polyhedron(4 + i % 12);
    const DiscBody disc = roundBody(A, i % 4);
    const auto begin = Clock::now();
    sum += smoothOnDisc(disc, B, feature).g;
    const auto middle = Clock::now();
    sum += smoothOnPolyhedron({&A, &body, A.r_OS_I, A.A_IK}, B, feature).g;
    ofRound += middle - begin, ofPolyhedra += Clock::now() - middle;
  }
  const auto mean = [n](Clock::duration d) {
    return std::chrono::duration<double, std::micro>(d).count() / n;
  };
  std::cout << "round body  " << mean(ofRound) << " us\npolyhedron  " << mean(ofPolyhedra)
            << " us\nsum of gaps " << sum << " m\n";
  return EXIT_SUCCESS;
}
