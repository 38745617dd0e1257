/// LawProbe: finds extreme points and bounds of the convex set of any law by evaluating its prox.
///
///   extreme point of C in direction d  =  prox_C(s d),  s → ∞
///
/// The projection of a far point is the point of C that lies farthest in its direction: exactly for
/// intervals and discs, within |C|²/s for other bounded sets. So solvers that need vertices or
/// bounds work with every law, those of plug-ins too. Rejected: another virtual function of the
/// laws, which each author would have to write for the sake of two solvers.
///
/// A law that is unilateral() has the normal force N ≥ 0 in row 0 and, in its other rows, sets that
/// grow with N; they are evaluated at N = 1.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

class LawProbe {
 public:
  /// `law` and `in` are borrowed.
  LawProbe(const SetValuedForceLaw& law, const LawInput& in) : law_(law), in_(in) {}
  /// Ends of the interval of one row of the law; ±∞ for an end that does not exist.
  void interval(int row, double& lower, double& upper) const;
  /// Point of the set of rows [first, first + k) farthest in `direction` (k numbers, |d| = 1);
  /// false: the set is unbounded in that direction.
  bool extreme(int first, int k, const double* direction, double* point) const;
  /// Radius of the set of rows [first, first + 2) if it is a disc around 0, else −1.
  double discRadius(int first) const;

 private:
  void project(int first, int k, double* x) const;
  const SetValuedForceLaw& law_;
  LawInput in_;
};

}  // namespace dynamy
