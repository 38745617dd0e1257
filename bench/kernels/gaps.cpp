/// Time of the geometry of one pair of shapes, by kind of pair and of placement.
///
///   bench_gaps [N [TEXT]]     mean over N calls a line [µs], default 20000; lines with TEXT only
///
/// "on a face": flat on each other, at rest. "touching": turned at random, moved together until
/// they touch. "near" and "deep": the same, 0.02 m apart, or overlapping by 0.1 m. Bodies measure 1
/// m. Smooth bodies are placed at random, and their gap alone is computed.
#include <chrono>
#include <cstdlib>
#include <dynamy/core/rotation.hpp>
#include <dynamy/system/convex_hull.hpp>
#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <dynamy_elements/contacts/pairs/disc_on_polyhedron.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace dynamy;

constexpr int kPlacements = 200;
constexpr double kReach = 0.05, kTouching = -1e-12;  // [m]

/// Random numbers, places and bodies.
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
  Polyhedron polyhedron(int corners, bool onBall) {
    std::vector<Vec3> points, hull;
    for (int i = 0; i < corners; ++i)
      points.push_back(onBall ? Vec3(0.5 * vec().normalized()) : Vec3(0.5 * vec()));
    for (const Triangle& t : convexHull(points))
      for (const int i : t) hull.push_back(points[static_cast<std::size_t>(i)]);
    return Polyhedron(hull);
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

/// Cylinder, torus, capsule, cone.
enum Round { cylinder, torus, capsule, cone };
DiscBody roundBody(const Frame& f, int kind) {
  const double half[] = {0.3, 0.0, 0.3, 0.3}, rho[] = {0.3, 0.3, 0.0, 0.3},
               r[] = {0.0, 0.1, 0.2, 0.0};
  return {&f, f.r_OS_I, f.A_IK.col(2), f.A_IK.col(0), half[kind], rho[kind], r[kind], kind == 3};
}

struct Measured {
  double micros = 0.0, contacts = 0.0;  ///< mean of calls
};

/// Mean time of `of`, called with each of the placements in turn.
template <class Call>
Measured measured(const std::vector<std::array<Frame, 2>>& at, int n, Call&& of) {
  using Clock = std::chrono::steady_clock;
  double contacts = 0.0;
  const auto begin = Clock::now();
  for (int i = 0; i < n; ++i) {
    const auto& [A, B] = at[static_cast<std::size_t>(i) % at.size()];
    contacts += of(A, B);
  }
  const std::chrono::duration<double, std::micro> took = Clock::now() - begin;
  return {took.count() / n, contacts / n};
}

/// Moves B along a random way until `separation` of the two is `wanted` [m].
template <class Separation>
std::array<Frame, 2> apartBy(double wanted, Placements& random, Separation&& separation) {
  const Frame A = random.frame(random.vec());
  Frame B = random.frame(A.r_OS_I);
  const Vec3 way = random.vec().normalized();
  double in = 0.0, out = 3.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (in + out);
    B.r_OS_I = A.r_OS_I + middle * way;
    (separation(A, B) < wanted ? in : out) = middle;
  }
  return {A, B};
}

/// B with its plane at `bottom` along −z of B on A's plane n·x = height, in axes of A.
std::array<Frame, 2> onFace(Placements& random, const Vec3& n, const Vec3& middle, const Mat3& up,
                            const Vec3& bottom) {
  const Frame A = random.frame(random.vec());
  Frame B = A;
  const double turn = std::numbers::pi * random.number();
  Mat3 axes;
  axes.col(2) = n, axes.col(0) = n.unitOrthogonal(), axes.col(1) = n.cross(axes.col(0));
  Mat3 spin;
  spin << std::cos(turn), -std::sin(turn), 0, std::sin(turn), std::cos(turn), 0, 0, 0, 1;
  B.A_IK = A.A_IK * axes * spin * up.transpose();
  B.r_OS_I = A.r_OS_I + A.A_IK * (middle + kTouching * n) - B.A_IK * bottom;
  return {A, B};
}

/// Middle of the corners of a face.
Vec3 middleOf(const Polyhedron& body, const Polyhedron::Face& f) {
  Vec3 sum = Vec3::Zero();
  for (int i = f.first; i < f.first + f.count; ++i) sum += body.corner(body.border(i).corner);
  return sum / f.count;
}
/// Axes of a body whose third is against the normal of a face.
Mat3 against(const Vec3& n) {
  Mat3 out;
  out.col(2) = -n, out.col(0) = n.unitOrthogonal(), out.col(1) = out.col(2).cross(out.col(0));
  return out;
}

class Table {
 public:
  Table(int n, std::string only) : n_(n), only_(std::move(only)) {}
  /// A line for each kind of placement: `resting` makes one flat on a face.
  template <class Resting, class Separation, class Call>
  void lines(const char* pair, Resting&& resting, Separation&& separation, Call&& contacts) {
    std::vector<std::array<Frame, 2>> at(kPlacements);
    if (isWanted(pair, "on a face")) {
      for (auto& frames : at) frames = resting(random_);
      line(pair, "on a face", measured(at, n_, contacts));
    }
    const auto placed = [&](const char* kind, double wanted) {
      if (!isWanted(pair, kind)) return;
      for (auto& frames : at) frames = apartBy(wanted, random_, separation);
      line(pair, kind, measured(at, n_, contacts));
    };
    placed("touching", kTouching), placed("near", 0.02), placed("deep", -0.1);
  }
  Placements& random() { return random_; }

 private:
  bool isWanted(const char* pair, const char* kind) const {
    return (std::string(pair) + " " + kind).find(only_) != std::string::npos;
  }
  static void line(const char* pair, const char* kind, const Measured& m) {
    std::cout << std::left << std::setw(22) << pair << std::setw(11) << kind << std::right
              << std::fixed << std::setprecision(3) << std::setw(9) << m.micros << " us"
              << std::setprecision(2) << std::setw(8) << m.contacts << " contacts\n";
  }

  int n_;
  std::string only_;
  Placements random_;
};

PlacedPolyhedron placed(const Frame& f, const Polyhedron& body) {
  return {&f, &body, f.r_OS_I, f.A_IK};
}

void boxes(Table& table) {
  const Vec3 half(0.5, 0.4, 0.3);
  const auto place = [&](const Frame& f) { return PlacedBox{&f, f.r_OS_I, f.A_IK, half}; };
  table.lines(
      "box, box",
      [&](Placements& random) {
        const Vec3 shift(0.3 * random.number(), 0.3 * random.number(), 0.3);
        return onFace(random, Vec3::UnitZ(), shift, Mat3::Identity(), -0.3 * Vec3::UnitZ());
      },
      [&](const Frame& A, const Frame& B) { return separation(place(A), place(B)); },
      [&](const Frame& A, const Frame& B) {
        std::array<BoxContact, kMostBoxContacts> out;
        return betweenBoxes(place(A), place(B), false, out);
      });
}

void polyhedra(Table& table, const char* name, const Polyhedron& a, const Polyhedron& b) {
  table.lines(
      name,
      [&](Placements& random) {
        const auto any = [&](const Polyhedron& body) -> const Polyhedron::Face& {
          const double last = static_cast<double>(body.faces().size()) - 1.0;
          return body.face(static_cast<int>(0.5 * (1.0 + random.number()) * last));
        };
        const Polyhedron::Face &f = any(a), &g = any(b);
        return onFace(random, f.n, middleOf(a, f), against(g.n), middleOf(b, g));
      },
      [&](const Frame& A, const Frame& B) { return separation(placed(A, a), placed(B, b)); },
      [&](const Frame& A, const Frame& B) {
        PolyhedraContacts out;
        return betweenPolyhedra(placed(A, a), placed(B, b), kReach, false, out);
      });
}

void discs(Table& table, const char* name, const Polyhedron& body, int kind) {
  const double height = kind == torus ? 0.1 : 0.3;
  table.lines(
      name,
      [&](Placements& random) {
        const Polyhedron::Face& f = body.face(0);
        return onFace(random, f.n, middleOf(body, f), Mat3::Identity(), -height * Vec3::UnitZ());
      },
      [&](const Frame& A, const Frame& B) {
        return separation(placed(A, body), roundBody(B, kind));
      },
      [&](const Frame& A, const Frame& B) {
        DiscContacts out;
        return discOnPolyhedron(placed(A, body), roundBody(B, kind), kReach, 0.0, false, out);
      });
}

void discs(Table& table, const char* name, int a, int b) {
  const double height[] = {0.3, 0.1, 0.5, 0.3};
  table.lines(
      name,
      [&](Placements& random) {
        const Vec3 shift(0.2 * random.number(), 0.2 * random.number(), height[a]);
        return onFace(random, Vec3::UnitZ(), shift, Mat3::Identity(), -height[b] * Vec3::UnitZ());
      },
      [&](const Frame& A, const Frame& B) { return separation(roundBody(A, a), roundBody(B, b)); },
      [&](const Frame& A, const Frame& B) {
        DiscContacts out;
        return betweenDiscs(roundBody(A, a), roundBody(B, b), kReach, 0.0, false, out);
      });
}

/// Gaps of ellipsoids at random placements, a few sizes apart; 3 % overlap.
void smooth(int n) {
  using Clock = std::chrono::steady_clock;
  Placements random;
  Clock::duration ofRound{}, ofPolyhedra{};
  double sum = 0.0;  // so that nothing is left out
  for (int i = 0; i < n; ++i) {
    const Frame A = random.frame(random.vec());
    const Frame B = random.frame(A.r_OS_I + (i % 3 == 0 ? 1.2 : 2.5) * random.vec());
    const SupportFeature feature = random.ellipsoid();
    const Polyhedron body = random.polyhedron(4 + i % 12, false);
    const DiscBody disc = roundBody(A, i % 4);
    const auto begin = Clock::now();
    sum += smoothOnDisc(disc, B, feature).g;
    const auto middle = Clock::now();
    sum += smoothOnPolyhedron(placed(A, body), B, feature).g;
    ofRound += middle - begin, ofPolyhedra += Clock::now() - middle;
  }
  const auto mean = [n](Clock::duration d) {
    return std::chrono::duration<double, std::micro>(d).count() / n;
  };
  std::cout << "ellipsoid on round body  " << mean(ofRound) << " us\nellipsoid on polyhedron  "
            << mean(ofPolyhedra) << " us\nsum of gaps " << sum << " m\n";
}

}  // namespace

int main(int argc, char** argv) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 20000;
  Table table(n, argc > 2 ? argv[2] : "");
  boxes(table);
  const Polyhedron box(boxTriangles({0.5, 0.4, 0.3})), small = table.random().polyhedron(12, true),
                                                       other = table.random().polyhedron(12, true),
                                                       many = table.random().polyhedron(60, true);
  polyhedra(table, "12 corners, 12", small, other);
  polyhedra(table, "box, 12 corners", box, other);
  polyhedra(table, "12 corners, 60", small, many);
  discs(table, "box, cylinder", box, cylinder);
  discs(table, "box, cone", box, cone);
  discs(table, "box, torus", box, torus);
  discs(table, "12 corners, cylinder", small, cylinder);
  discs(table, "cylinder, cylinder", cylinder, cylinder);
  discs(table, "cylinder, cone", cylinder, cone);
  discs(table, "cylinder, capsule", cylinder, capsule);
  if (argc < 3) smooth(n);
  return EXIT_SUCCESS;
}
