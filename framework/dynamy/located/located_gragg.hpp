/// LocatedGragg: LocatedDormandPrince with Gragg's extrapolation in the smooth phases (theory 50),
/// for comparison: as a tableau on accelerations, or half-explicit on velocities. Between the ends
/// of a step it interpolates by Hermite's cubic; the half-explicit rule uses the quintic.
#pragma once
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {

class LocatedGragg final : public LocatedDormandPrince {
 public:
  explicit LocatedGragg(const Parameters& x);
  static void declare(Attributes& a);
};

}  // namespace dynamy
