/// Fixed steps have an end, whatever fails in them.
#include <gtest/gtest.h>

#include <dynamy/simulation/run/own_steps.hpp>
#include <dynamy/simulation/run/time_loop.hpp>
#include <dynamy/stages/search_pauses.hpp>
#include <functional>
#include <random>

namespace dynamy {
namespace {

TEST(Allowance, IsLessAfterAStepThatDidNotGetAlong) {
  Allowance a(8);
  const auto step = [&](int tries) {
    a.begin();
    int taken = 0;
    while (taken < tries && a.take()) ++taken;
    return taken;
  };
  EXPECT_EQ(step(20), 8);
  EXPECT_EQ(step(20), 2);
  EXPECT_EQ(step(20), 1);
  EXPECT_EQ(step(20), 1);
  EXPECT_EQ(step(1), 1);  // got along with it
  EXPECT_EQ(step(0), 0);
  EXPECT_EQ(step(20), 4);
}

TEST(Allowance, TriesThatStepsLeaveUnusedServeOneThatNeedsMore) {
  Allowance a(40, 5.0);
  const auto step = [&](int tries) {
    a.begin(), a.atMost(8);
    int taken = 0;
    while (taken < tries && a.take()) ++taken;
    return taken;
  };
  EXPECT_EQ(step(100), 8 + 3 * 8);  // its own, 1 of begin() and 0.4 · 5 steps: all that there are
  EXPECT_EQ(step(0), 0);            // a quarter after a step that did not get along
  for (int i = 0; i < 20; ++i) step(0);
  EXPECT_EQ(step(100), 40);         // no step takes more, though 5 · 8 are saved
  EXPECT_EQ(step(100), 2 + 1 * 2);  // the one step that is left, of the present limit
}

/// Attempts that search for long, of 1000 of which one in `every` has no solution.
long searchesOf(int every) {
  SearchPauses pauses;
  long searches = 0;
  for (int i = 0; i < 1000; ++i) {
    searches += pauses.next() == Effort::full ? 1 : 0;
    pauses.done(i % every != 0);
  }
  return searches;
}

TEST(SearchPauses, GrowWhereSearchesAreInVain) {
  // After pauses of 1, 3, 7, 15, 31 and 63 attempts one in 64.
  EXPECT_EQ(searchesOf(1), 6 + (1000 - 6 - (1 + 3 + 7 + 15 + 31 + 63)) / 64 + 1);
  // One pause of one attempt after each failure; the next search shortens it again.
  EXPECT_EQ(searchesOf(100), 990);
}

TEST(SearchPauses, HardlySearchWhereNearlyAllLongSearchesFailed) {
  SearchPauses pauses;
  long little = 0, retried = 0;
  for (int i = 0; i < 1000; ++i) {
    const Effort effort = pauses.next();
    little += effort == Effort::little ? 1 : 0, retried += effort == Effort::retried ? 1 : 0;
    if (i < 1 + 1 + 1 + 3 + 1 + 7) {  // pauses of 1, 3 and 7
      EXPECT_NE(effort, Effort::little) << i;
    }
    pauses.done(false);
  }
  // After them every fourth attempt of a pause is a short search.
  EXPECT_NEAR(static_cast<double>(little) / static_cast<double>(little + retried), 0.75, 0.02);
}

TEST(SearchPauses, LeaveOneOfTwentyAttemptsWhereThreeOfTenFail) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  SearchPauses pauses;
  long searches = 0;
  for (int i = 0; i < 100'000; ++i) {
    searches += pauses.next() == Effort::full ? 1 : 0;
    pauses.done(uniform(random) > 0.3);
  }
  // The chain of pauses, drawn apart from this code, searches in 5.0 %; 1000 cycles scatter by 3 % of it.
  EXPECT_NEAR(static_cast<double>(searches), 5000.0, 500.0);
}

TEST(SearchPauses, AreKeptAndExamined) {
  SearchPauses pauses, same;
  pauses.done(false), pauses.done(false), pauses.done(false);
  Archive out;
  pauses.archive(out);
  Archive in(out.bytes());
  same.archive(in);
  EXPECT_EQ(same.next(), Effort::retried);
  Archive wrong;
  int pause = 1, left = 64;
  wrong(pause), wrong(left);
  Archive back(wrong.bytes());
  EXPECT_THROW(same.archive(back), ModelError);
}

/// A stepper that answers as told, and counts.
class Counted final : public Stepper {
 public:
  StepReport attempt(double tEnd, double dt, StepTry how) override {
    ++attempts, cheap += how == StepTry::cheap;
    StepReport report;
    report.dt = how == StepTry::whole && dt > endsAbove ? dt / endsAfter : dt;
    begin_ = t_, t_ = report.dt < dt ? begin_ + report.dt : tEnd;
    if (!solves(dt)) report.solved.status = SolveStatus::stalled;
    return report;
  }
  bool accept() override { return true; }
  void reject() override { t_ = begin_, ++rejected; }
  bool fail(const StepReport&) override { return false; }
  bool sound() const override { return true; }
  Coarseness coarseness() override { return Coarseness::of(turnRate * (t_ - begin_), {}); }
  void divided(int parts) override { ++divisions, finest = parts; }
  Passing passing(double ahead) override {
    const double dt = ahead > 0.0 ? ahead : t_ - begin_;
    ++looks;
    Passing p;
    if (passes || dt > passesAbove) p.t = 0.5 * dt, p.width = 1e-3 * dt;
    return p;
  }
  void leave(const Passing&) override { ++left; }
  double t() const override { return t_; }
  double nextStep() const override { return 0.0; }
  Spent spent() const override {
    return {attempts,
            workOfOne * static_cast<double>(attempts) + workOfLook * static_cast<double>(looks)};
  }
  bool pause(bool) override { return true; }

  std::function<bool(double)> solves = [](double) { return true; };
  bool passes = false;
  double passesAbove = 1e9;  // length from which a step passes a contact in its middle [s]
  double turnRate = 0.0;     // [rad/s]
  // Whole steps longer than this end after the first of so many parts.
  double endsAbove = 1e9, endsAfter = 4.0;
  double workOfOne = 6.0;   // work of an attempt
  double workOfLook = 0.0;  // work of a look for passed contacts
  long looks = 0, attempts = 0, rejected = 0, left = 0, divisions = 0, cheap = 0;
  int finest = 0;

 private:
  double t_ = 0.0, begin_ = 0.0;
};

TEST(OwnSteps, LookForPassedContactsWithinABudgetAndTellWhereItIsUsedUp) {
  // A hundred steps of 1e5 each up to 1 s, with nothing passed. Looks that cost less than their step
  // are all taken. Of 1e6 each, 9e5 counts: 6e6 in all grants seven, and one of sixteen of the other
  // 93 steps looks; each of the rest is told.
  for (const double look : {5e4, 1e6}) {
    Counted s;
    s.workOfOne = 1e5, s.workOfLook = look;
    OwnSteps loop(0.01, NonConvergence::warn, 6);
    while (loop.next(s, 1.0) == Advance::taken) {
    }
    EXPECT_NEAR(static_cast<double>(s.attempts), 100.0, 1.0);  // a rest of rounding
    EXPECT_EQ(s.looks + s.left, s.attempts);
    if (look < s.workOfOne) {
      EXPECT_EQ(s.left, 0);
    } else {
      EXPECT_LE(s.looks, 7 + 1 + 93 / 16);
    }
  }
}

TEST(OwnSteps, TryToEndAtContactsWithinABudget) {
  // Each step passes a contact, and each try costs 1e6: two tries are granted at once, six in 1 s.
  Counted s;
  s.passes = true, s.workOfOne = 1e6;
  OwnSteps loop(0.01, NonConvergence::warn, 6);
  for (int i = 0; i < 300 && loop.next(s, 1.0) == Advance::taken; ++i) {
  }
  EXPECT_GE(s.rejected, 2);
  EXPECT_LE(s.rejected, 7);
  EXPECT_GT(s.left, 50);
}

TEST(FixedSteps, ThatAreNeverSolvedTakeThreeTriesInTheEnd) {
  Counted s;
  s.solves = [](double) { return false; };
  FixedStep loop(1.0, NonConvergence::retry, 6);
  loop.next(s, 1000.0);
  EXPECT_LE(s.attempts, 60);  // 127 without a bound
  for (int i = 0; i < 5; ++i) loop.next(s, 1000.0);
  const long before = s.attempts;
  for (int i = 0; i < 100; ++i) loop.next(s, 1000.0);
  EXPECT_EQ(s.attempts - before, 300);  // the step and its halves
}

TEST(FixedSteps, ThatAreSolvedInHalvesKeepThem) {
  Counted s;
  s.solves = [](double dt) { return dt < 0.2; };
  FixedStep loop(1.0, NonConvergence::retry, 6);
  for (int i = 0; i < 10; ++i) loop.next(s, 1000.0);
  EXPECT_EQ(s.attempts, 10 * (1 + 2 + 4 + 8));
}

TEST(FixedSteps, ThatTheSchemeEndsEarlyGoOnInPartsOfTheSameLength) {
  Counted s;
  s.endsAbove = 0.5;
  FixedStep loop(1.0, NonConvergence::warn, 6);
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(loop.next(s, 1000.0), Advance::taken);
    EXPECT_EQ(s.t(), i);
    EXPECT_EQ(s.attempts, 4 * i);
  }
  EXPECT_EQ(s.rejected, 0);
  // Where the first part is too coarse, all of them are divided: each turns by 2 rad, where 1 is fine.
  FixedStep dividing(1.0, NonConvergence::warn, 6, true);
  Counted fast;
  fast.endsAbove = 0.5, fast.turnRate = 8.0;
  EXPECT_EQ(dividing.next(fast, 1000.0), Advance::taken);
  EXPECT_EQ(fast.attempts, 1 + 8);
}

TEST(FixedSteps, ThatArePassedAgainAndAgainTakeFewPartsInTheEnd) {
  Counted s;
  s.passes = true;
  FixedStep loop(1.0, NonConvergence::retry, 6);
  for (int i = 0; i < 10; ++i) loop.next(s, 1000.0);
  EXPECT_EQ(s.left, 10);
  const long before = s.attempts;
  for (int i = 0; i < 100; ++i) loop.next(s, 1000.0);
  EXPECT_LE(s.attempts - before, 100 * 6);
}

TEST(FixedSteps, AmongFastBodiesAreCutBeforeTheyAreTried) {
  Counted s;
  s.passesAbove = 0.9;
  FixedStep loop(1.0, NonConvergence::warn, 6);
  loop.next(s, 1000.0);
  EXPECT_EQ(s.rejected, 1);  // the first passing shows after the attempt
  for (int i = 0; i < 9; ++i) loop.next(s, 1000.0);
  EXPECT_EQ(s.rejected, 1);
  EXPECT_EQ(s.attempts, 1 + 10 * 3);  // up to the contact, across it, the rest
  // Ten quiet steps later bodies count as slow: an attempt shows the next passing.
  s.passesAbove = 2.0;
  for (int i = 0; i < 11; ++i) loop.next(s, 1000.0);
  s.passesAbove = 0.9;
  loop.next(s, 1000.0);
  EXPECT_EQ(s.rejected, 2);
}

TEST(FixedSteps, ThatAreTooLongForTheMotionHaveEqualParts) {
  Counted s;
  s.turnRate = 3.0;  // rad/s: four parts of 0.75 rad
  FixedStep divides(1.0, NonConvergence::warn, 6, true), asItIs(1.0, NonConvergence::warn, 6);
  for (int i = 0; i < 10; ++i) divides.next(s, 1000.0);
  EXPECT_EQ(s.rejected, 1);  // the first step shows it
  EXPECT_EQ(s.attempts, 1 + 10 * 4);
  EXPECT_EQ(s.divisions, 10);
  EXPECT_EQ(s.finest, 4);
  EXPECT_DOUBLE_EQ(s.t(), 10.0);
  for (int i = 0; i < 10; ++i) asItIs.next(s, 1000.0);
  EXPECT_EQ(s.attempts, 1 + 10 * 4 + 10);
}

TEST(FixedSteps, ThatAreAlwaysPassedStayWithinTheirBudget) {
  Counted s;
  s.passes = true;
  s.workOfOne = 0.04 * StepBudget::kWork;
  FixedStep loop(1.0, NonConvergence::retry, 6);
  loop.next(s, 1000.0);
  EXPECT_GT(s.cheap, 0);
  for (int i = 0; i < 50; ++i) loop.next(s, 1000.0);
  const long before = s.attempts;
  for (int i = 0; i < 100; ++i) loop.next(s, 1000.0);
  // What is left after the budget is taken by the parts begun: up to the contact, across it, the
  // rest.
  EXPECT_LE(static_cast<double>(s.attempts - before) * s.workOfOne,
            100 * (StepBudget::kWork + 3.0 * s.workOfOne));
}

TEST(FixedSteps, WhoseFirstTryCostsAllStillHaveThree) {
  Counted s;
  s.passes = true;
  s.workOfOne = 10.0 * StepBudget::kWork;
  FixedStep loop(1.0, NonConvergence::retry, 6);
  for (int i = 0; i < 10; ++i) loop.next(s, 1000.0);
  const long before = s.attempts;
  loop.next(s, 1000.0);
  EXPECT_GE(s.attempts - before, 3);
  EXPECT_LE(s.attempts - before, 6);
}

TEST(StepBudget, SavesWhatStepsLeaveForOthers) {
  StepBudget b(6);
  for (int i = 0; i < 1000; ++i) b.begin(), b.spend(0.1 * StepBudget::kWork);
  b.begin(), b.spend(1.0);
  b.spend(50.0 * StepBudget::kWork);
  EXPECT_FALSE(b.exhausted());
  b.spend(200.0 * StepBudget::kWork);
  EXPECT_TRUE(b.exhausted());
  for (int i = 0; i < 2; ++i) {  // nothing is left for the next ones
    b.begin(), b.spend(1.0);
    EXPECT_FALSE(b.exhausted());
    b.spend(1.1 * StepBudget::kWork);
    EXPECT_TRUE(b.exhausted());
  }
}

TEST(StepBudget, LetsStepsThatFailOweTheirWork) {
  StepBudget b(6);
  const double dear = 15.0 * StepBudget::kWork;
  for (int i = 0; i < 20; ++i) b.begin(), b.spend(dear);
  b.begin();
  EXPECT_FALSE(b.exhausted());  // a first try that finds a solution may cost what it costs
  b.spend(dear, false);
  b.begin();
  EXPECT_TRUE(b.exhausted());
  int cheap = 0;  // each pays nine tenths of a budget, until one is owed
  while (b.exhausted() && cheap < 100) b.spend(0.1 * StepBudget::kWork, false), b.begin(), ++cheap;
  EXPECT_GE(cheap, 14);
  EXPECT_LE(cheap, 17);
}

TEST(FixedSteps, OfManyBodiesHaveFewerParts) {
  EXPECT_EQ(partsWithinWork(180, 2), 111);
  EXPECT_EQ(partsWithinWork(100000, 1), 0);

  EXPECT_EQ(mostParts(0, 0), 2000);
  EXPECT_EQ(mostParts(12, 2), 2000);
  EXPECT_EQ(mostParts(180, 2), 400);
  EXPECT_EQ(mostParts(60, 20), 120);
  EXPECT_EQ(mostParts(100000, 1), 8);
}

}  // namespace
}  // namespace dynamy
