// Automatic on random problems whose solution is known by construction: it is judged by a residual
// written down in the tests. Nothing may crash and nothing may be called solved that is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <support/known_problems.hpp>

namespace dynamy {
namespace {

constexpr double kKnownTolerance = 1e-8;
// CPU time of one problem. Of one that may have no solution a false claim is looked for, which needs
// no end; ten parts with 10 s for each of those would take days.
constexpr double kSeconds = 10.0, kSecondsOfOthers = 0.1;

/// CPU seconds, so that other programs on the machine do not count.
double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// No measure of its own; asks to stop after the time limit.
class TimeLimit final : public StoppingRule {
 public:
  explicit TimeLimit(double seconds) : end_(cpuSeconds() + seconds) {}
  double measure(const InclusionProblem&, const double*, const double*) const override {
    return -1.0;
  }
  bool enough() const override { return cpuSeconds() > end_; }

 private:
  double end_;
};

struct Count {
  int known = 0, unsolved = 0;
  double longest = 0.0;  ///< CPU time of one with a known solution [s]
};

/// Solves problems [from, to); of those that may have no solution the ones of up to `most`
/// contacts.
Count solve(unsigned from, unsigned to, int most) {
  Count count;
  Automatic solver(
      {.tolerance = kKnownTolerance});  // one for all: nothing may be left from the last
  for (unsigned seed = from; seed < to; ++seed) {
    const KnownProblem known = KnownProblems(seed).take();
    if (!known.known() && known.problem.contacts() > most) continue;
    const std::unique_ptr<GivenProblem> given = inclusionProblem(known.problem);
    const TimeLimit limit(known.known() ? kSeconds : kSecondsOfOthers);
    const double begin = cpuSeconds();
    given->problem().rule = &limit;
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(given->problem().rows());
    const SolveReport report = solver.solve(given->problem(), view(Lambda));
    EXPECT_TRUE(Lambda.allFinite()) << "seed " << seed;
    const Missed missed = dynamy::missed(known.problem, Lambda);
    if (report.ok()) {
      // What the solver may take for rounding, 4ε(|G||Λ| + |c|), is no false claim.
      EXPECT_LE(missed.error, kKnownTolerance + missed.rounding) << "seed " << seed;
    }
    if (!known.known()) continue;
    ++count.known;
    count.longest = std::max(count.longest, cpuSeconds() - begin);
    if (report.ok()) continue;
    ++count.unsolved;
    std::printf("seed %u, %s, %d contacts of %d rows, %s: %s\n", seed, known.problem.title.c_str(),
                known.problem.contacts(), known.problem.dim,
                std::string(solveStatusText(report.status)).c_str(), attemptsText(report).c_str());
  }
  std::printf("%d of %d problems with a known solution not solved, the longest took %.2g s\n",
              count.unsolved, count.known, count.longest);
  return count;
}

TEST(KnownSolutions, FulfilTheLawsByConstruction) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const KnownProblem known = KnownProblems(seed).take();
    if (!known.known()) continue;
    // q = ξ − WΛ is rounded once more than the checker's sum of the same terms.
    const Missed missed = dynamy::missed(known.problem, known.r);
    EXPECT_LE(missed.error, 2.0 * missed.rounding + 1e-15) << "seed " << seed;
  }
}

TEST(KnownSolutions, AreFound) {
  const Count count = solve(0, 2700, 4);
  EXPECT_LE(count.unsolved, count.known / 1000) << "of " << count.known;
}

/// 10^5 problems, in ten parts: --gtest_filter='LongKnownSolutions*'.
class LongKnownSolutions : public ::testing::TestWithParam<unsigned> {};

TEST_P(LongKnownSolutions, AreFound) {
  const unsigned from = 100'000 + 10'000 * GetParam();
  const Count count = solve(from, from + 10'000, 60);
  EXPECT_LE(count.unsolved, count.known / 1000) << "of " << count.known;
}

INSTANTIATE_TEST_SUITE_P(LongKnownSolutions, LongKnownSolutions, ::testing::Range(0U, 10U));

}  // namespace
}  // namespace dynamy
