/// SampleInstants: the instants at which elements of a model sample the motion, and at which steps
/// therefore end (system/announced_signals.hpp).
#pragma once
#include <dynamy/system/description.hpp>
#include <string>
#include <vector>

namespace dynamy {

class Model;

class SampleInstants {
 public:
  SampleInstants() = default;  ///< none
  /// Those of the model's elements, and of its settings (sampleEvery).
  explicit SampleInstants(const Model& model);
  /// The first instant after t; one that t reaches up to rounding is not after it. Infinity: none.
  double after(double t) const;
  /// Why the instants near `until`, where a run ends, do not move t, so that it never ends; empty:
  /// they do.
  std::string fault(double until) const;
  /// True: a step to tE passes instant `at` by more than rounding.
  static bool isWithin(double at, double tE);

 private:
  struct Announced {
    std::string element;
    SignalFunction next;
  };
  std::vector<Announced> announced_;
};

}  // namespace dynamy
