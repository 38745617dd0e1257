/// StopWith: passes on another rule's request to stop, without its measure, for problems other than
/// the one that the rule was made for.
#pragma once
#include <dynamy/solver/problem/stopping_rule.hpp>

namespace dynamy {

class StopWith final : public StoppingRule {
 public:
  /// `other`: borrowed, may be null.
  explicit StopWith(const StoppingRule* other) : other_(other) {}
  /// −1: no other measure than E_f and E_u.
  double measure(const InclusionProblem&, const double*, const double*) const override {
    return -1.0;
  }
  bool enough() const override { return other_ && other_->enough(); }

 private:
  const StoppingRule* other_;
};

}  // namespace dynamy
