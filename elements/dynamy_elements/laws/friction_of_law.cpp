#include <dynamy_elements/laws/friction_of_law.hpp>

namespace dynamy {

bool hasFriction(const SetValuedForceLaw& law) {
  constexpr int kRows = 2;
  if (!law.unilateral() || law.dim(kRows) != kRows) return false;
  const double r[kRows] = {1.0, 1.0}, xi[kRows] = {-1.0, -1.0}, zero[kRows] = {};
  double Lambda[kRows] = {};
  law.prox({.dim = kRows, .dt = 1.0, .gammaA = zero, .position = zero}, r, xi, Lambda);
  return Lambda[1] != 0.0;
}

void requireLawOfRates(const SetValuedForceLaw& law) {
  if (law.unilateral())
    throw ModelError(
        "the law <" + law.type() + "> needs a gap, and a joint has none",
        "friction of a joint is <GivenFriction force=\"…\">, its stops are a JointStop");
  if (law.rowKind(0) == RowKind::joint)
    throw ModelError("a bilateral law would lock the joint without a position",
                     "a JointDrive holds or moves a coordinate");
}

}  // namespace dynamy
