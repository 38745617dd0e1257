// Automatic on random problems of bodies: mixed laws, redundant contacts, joints, rolling, mass
// ratios, near jam. c = Wᵀu, so that "nothing moves" is a motion the laws allow and a solution
// exists.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <unit/solver/inclusion_fixture.hpp>

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

enum class Sort { planar, spatial, rolling, joints, redundant, masses, nearJam, mixed };
constexpr int kSorts = 8;

class RandomProblem {
 public:
  explicit RandomProblem(unsigned seed) : seed_(seed), random_(seed) {
    sort_ = static_cast<Sort>(seed % kSorts);
    spatial_ = sort_ != Sort::planar && !(sort_ == Sort::mixed && seed % 16 > 7);
    dof_ = spatial_ ? 6 : 3;
    bodies_ = whole(1, 6);
    const double decades = sort_ == Sort::masses ? 4.0 : 0.5;
    std::vector<MatrixXd> masses;
    for (int b = 0; b < bodies_; ++b) {
      const double m = std::pow(10.0, number(-decades, decades)), J = m * number(0.03, 0.3);
      VectorXd d(dof_);
      d.head(dof_ / 2 + (spatial_ ? 0 : 1)).setConstant(m);
      d.tail(spatial_ ? 3 : 1).setConstant(J);
      masses.push_back(d.asDiagonal());
      centres_.emplace_back(number(-2, 2), number(-2, 2), spatial_ ? number(-2, 2) : 0.0);
    }
    scene_ = std::make_unique<fixture::Inclusion>(masses);
    if (sort_ == Sort::nearJam) wedges();
    for (int k = whole(1, 12); k > 0; --k) touch();
  }
  InclusionProblem& problem() {
    MatrixXd Wt(rows_, dof_ * bodies_);
    int row = 0;
    for (const MatrixXd& w : all_)
      Wt.middleRows(row, w.rows()) = w, row += static_cast<int>(w.rows());
    VectorXd u(dof_ * bodies_);
    for (double& x : u) x = number(-1, 1);
    return scene_->pose(Wt * u, 1.0,
                        seed_ % 3 == 0 ? Delassus::Form::matrixFree : Delassus::Form::automatic);
  }

 private:
  double number(double a, double b) {
    return a + (b - a) * static_cast<double>(random_()) / 4294967296.0;
  }
  int whole(int a, int b) {
    return a + static_cast<int>(random_() % static_cast<unsigned>(b - a + 1));
  }
  Vec3 direction() {
    return Vec3(number(-1, 1), number(-1, 1), spatial_ ? number(-1, 1) : 0.0).normalized();
  }
  Vec3 across(const Vec3& n) const {
    return spatial_ ? n.unitOrthogonal() : Vec3(n.y(), -n.x(), 0);
  }

  const SetValuedForceLaw& law() {
    const double mu = number(0, 1.2);
    const int k = whole(0, 9);
    const bool mixed = sort_ == Sort::mixed;
    if (sort_ == Sort::rolling || (mixed && spatial_ && k == 0))
      laws_.push_back(std::make_unique<UnilateralRolling>(mu, number(0, 0.2)));
    else if (sort_ == Sort::joints ? k < 4 : mixed && k == 1)
      laws_.push_back(std::make_unique<Bilateral>());
    else if (mixed && k == 2)
      laws_.push_back(std::make_unique<GivenFriction>(0.3, 0.3));
    else if (mixed && k == 3)
      laws_.push_back(std::make_unique<Unilateral>());
    else
      laws_.push_back(std::make_unique<UnilateralCoulomb>(0.0, 0.0, k == 9 ? 0.0 : mu));
    return *laws_.back();
  }
  void add(const SetValuedForceLaw& law, int on, int by, const Vec3& point, const Vec3& n) {
    const Vec3 t1 = across(n), directions[3] = {n, t1, n.cross(t1)};
    const int dim = law.dim(spatial_ ? 3 : 2);
    MatrixXd Wt = MatrixXd::Zero(dim, dof_ * bodies_);
    for (const auto& [body, sign] : {std::pair{on, 1.0}, std::pair{by, -1.0}}) {
      if (body < 0) continue;
      const Vec3 a = point - centres_[static_cast<std::size_t>(body)];
      for (int r = 0; r < dim; ++r) {
        const Vec3 d = directions[r < 3 ? r : r - 2], turn = r < 3 ? Vec3(a.cross(d)) : d;
        const int at = dof_ * body;
        if (spatial_) {
          if (r < 3) Wt.row(r).segment<3>(at) = sign * d.transpose();
          Wt.row(r).segment<3>(at + 3) = sign * turn.transpose();
        } else {
          Wt.row(r).segment<3>(at) = sign * Eigen::RowVector3d(d.x(), d.y(), turn.z());
        }
      }
    }
    scene_->contact(law, Wt);
    all_.push_back(Wt), rows_ += dim;
  }
  void touch() {
    const int on = whole(0, bodies_ - 1);
    int by = whole(-1, bodies_ - 1);
    if (by == on) by = -1;
    const Vec3 n = direction(), t = across(n), s = spatial_ ? Vec3(n.cross(t)) : Vec3::Zero();
    const SetValuedForceLaw& l = law();
    const int copies = sort_ == Sort::redundant ? whole(2, 4) : 1;
    const Vec3 point = centres_[static_cast<std::size_t>(on)] - 0.5 * n;
    for (int c = 0; c < copies; ++c)
      add(l, on, by,
          copies == 1
              ? point
              : Vec3(point + 0.3 * ((c & 1) ? 1.0 : -1.0) * t + 0.3 * ((c & 2) ? 1.0 : -1.0) * s),
          n);
  }
  /// Every body between two walls that enclose about twice the angle of friction.
  void wedges() {
    for (int b = 0; b < bodies_; ++b) {
      const double mu = number(0.05, 0.6), tilt = std::atan(mu) * number(0.9, 1.1);
      laws_.push_back(std::make_unique<UnilateralCoulomb>(0.0, 0.0, mu));
      const Vec3 n = direction(), t = across(n), centre = centres_[static_cast<std::size_t>(b)];
      for (const double side : {1.0, -1.0}) {
        const Vec3 normal = side * std::cos(tilt) * n + std::sin(tilt) * t;
        add(*laws_.back(), b, -1, centre - 0.5 * normal, normal);
      }
    }
  }

  unsigned seed_;
  std::mt19937 random_;
  Sort sort_;
  bool spatial_;
  int dof_, bodies_, rows_ = 0;
  std::vector<Vec3> centres_;
  std::vector<std::unique_ptr<SetValuedForceLaw>> laws_;
  std::unique_ptr<fixture::Inclusion> scene_;
  std::vector<MatrixXd> all_;
};

/// Solves problems [from, to); returns how many were not solved. Nothing may be called solved that
/// is not.
int unsolved(unsigned from, unsigned to) {
  int count = 0;
  for (unsigned seed = from; seed < to; ++seed) {
    RandomProblem random(seed);
    const InclusionProblem& p = random.problem();
    Automatic solver({.tolerance = 1e-10});
    VectorXd Lambda = VectorXd::Zero(p.rows());
    const SolveReport report = solver.solve(p, view(Lambda));
    std::vector<double> scratch;
    const double E = residuals(p, {Lambda.data(), Lambda.size()}, scratch).largest();
    EXPECT_TRUE(Lambda.allFinite()) << "seed " << seed;
    EXPECT_EQ(report.ok(), E <= 1e-10) << "seed " << seed;
    EXPECT_NE(report.status, SolveStatus::diverged) << "seed " << seed;
    if (!report.ok()) {
      ++count;
      std::printf("seed %u, %d rows: %s, %s\n", seed, p.rows(),
                  std::string(solveStatusText(report.status)).c_str(),
                  attemptsText(report).c_str());
    }
  }
  return count;
}

TEST(RandomProblems, AreSolvedAndNeverCalledSolvedWhenTheyAreNot) {
  EXPECT_EQ(unsolved(0, 400), 0);
}

TEST(LongRandomProblems, FewerThanOneInAThousandIsNotSolved) {
  EXPECT_LE(unsolved(1000, 21000), 20);
}

}  // namespace
}  // namespace dynamy
