/// knownDefect: a test states the right result of something that is known to come out wrong. It
/// passes and reports the wrong figures while the defect is there, and fails once the right result
/// comes out, so that nobody forgets to take the mark off.
///
///   knownDefect("robot_arm_minimal", [&] { EXPECT_NEAR(phi, truth, tolerance); });
///
/// Every name has a row in doc/trust.md, section "Known defects"; a test compares both. To take the
/// mark off: keep the expectations, delete the call around them and the row, and move the test to
/// the folder of its kind. Rejected: tests that are disabled, which rot unseen, and tests that
/// state the wrong figure, which pass for a reason that is none.
#pragma once
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <string>

namespace dynamy {

/// Calls `claim`, a function without arguments that holds expectations of the right result. An
/// exception passes through: what cannot be set up is no known defect.
template <class Claim>
void knownDefect(const std::string& name, Claim&& claim) {
  testing::TestPartResultArray results;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    claim();
  }
  int failed = 0;
  for (int i = 0; i < results.size(); ++i) {
    const testing::TestPartResult& result = results.GetTestPartResult(i);
    if (!result.failed()) continue;
    ++failed;
    std::printf("known defect %s, line %d: %s\n", name.c_str(), result.line_number(),
                result.message());
  }
  if (failed == 0)
    ADD_FAILURE() << "the known defect " << name
                  << " is gone: take the mark off (tests/support/known_defect.hpp says how)";
}

/// Ends a run after `steps` accepted steps or `evaluations`, so that a run without an end costs a
/// test little:
///
///   WorkLimit limit(1000, 20'000);
///   limit.holdFor(simulation);
class WorkLimit final : public Observer {
 public:
  WorkLimit(long steps, long evaluations) : steps_(steps), evaluations_(evaluations) {}
  /// The limit outlives the simulation.
  void holdFor(Simulation& simulation) {
    report_ = &simulation.report();
    simulation.observe(*this);
    simulation.stopWhen(stop_);
  }
  void step(const StepView& view) override {
    newton_ += view.report.solved.newton;
    if (--steps_ <= 0 || report_->cost.evaluations >= evaluations_) stop_ = true;
  }
  /// Newton steps of all inclusions that accepted steps report.
  long newtonSteps() const { return newton_; }

 private:
  long steps_, evaluations_, newton_ = 0;
  const RunReport* report_ = nullptr;
  std::atomic<bool> stop_ = false;
};

}  // namespace dynamy
