/// LocatedGragg: LocatedDormandPrince with Gragg's extrapolation in the smooth phases (theory 50),
/// for comparison. Between the ends of steps it shows Hermite's cubics.
#pragma once
#include <dynamy/integrator/located_dormand_prince.hpp>

namespace dynamy {

class LocatedGragg final : public LocatedDormandPrince {
 public:
  explicit LocatedGragg(const Parameters& x);
  static void declare(Attributes& a);
};

}  // namespace dynamy
