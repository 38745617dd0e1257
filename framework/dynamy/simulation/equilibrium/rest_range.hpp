/// RestRange: the parts of an interval of a parameter in which an equilibrium exists at the start of
/// the model, e.g. the coefficients of friction that hold a ladder (theory 57.3).
#pragma once
#include <dynamy/simulation/equilibrium/equilibrium.hpp>
#include <functional>

namespace dynamy {

struct RestRange {
  double from = 0.0, to = 0.0;
  /// What ends the rest there: the contact whose law permits no more, or why no state is found;
  /// empty: the end of the interval.
  std::string endsFrom, endsTo;
};

/// `at` finds an equilibrium for a value, and throws ModelError if there is none. The interval is
/// looked at in `count` ≥ 2 values; ends between two of them are found by bisection, to rounding.
std::vector<RestRange> restRanges(double a, double b, int count,
                                  const std::function<Equilibrium(double)>& at);

}  // namespace dynamy
