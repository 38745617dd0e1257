/// gradient: derivatives of a run with respect to parameters, exact through its impacts, stick and
/// slip (theory 53):
///
///   d = (v(p + δ) − v(p − δ)) / 2δ
///
/// where v(p ± δ) are runs with the steps of the run at p, each with its own instants of the same
/// switches. So v is smooth in p, and differences are good to about ten digits. The error is the
/// change when tolerance and δ grow, with the rounding. Where a run at p ± δ has other switches, however small δ is,
/// there is no derivative: the result says where and at which contact, and gives the derivatives
/// towards either side that exist.
///
/// Rejected: differences of runs that choose their own steps. They are as good with the best δ, which
/// is between 1e-3 and 1e-6 of p from run to run; nothing tells which it is, or the error.
#pragma once
#include <dynamy/simulation/gradient/run_differences.hpp>
#include <limits>

namespace dynamy {

struct GradientRequest {
  std::vector<SignalAt> of;  ///< t: NaN for the end; empty: all signals of systems at the end
  std::vector<WantedInstant> instants = {};  ///< of events
  std::vector<Varied> by;  ///< parameters and the values at which derivatives are taken
  /// Those of `by` that are coordinates and velocities: their initial values are varied.
  std::vector<std::string> initial = {};
  bool checks = false;     ///< also the values of the model's checks
  double tolerance = 0.0;  ///< of the run; 0: the model's, or 1e-9 if it has none
};

/// Derivative towards one side of a parameter; NaN: none.
struct SideDerivative {
  double d = std::numeric_limits<double>::quiet_NaN(), error = d;
  double limit = d;    ///< of the value from this side
  bool jumps = false;  ///< the limit is not the value at the parameter
};

struct GradientValue {
  std::string of;            ///< signal, or contact of an event
  double at = 0.0;           ///< instant [s]; of a check over an interval its end
  std::string measure = {};  ///< of a check: "max over 0 … 1 s"; of an event: "instant"; else empty
  double value = 0.0, error = 0.0;
  std::vector<double> d = {}, dError = {};  ///< by each parameter; NaN: no derivative
  /// Where there is no derivative: those towards smaller and larger parameters. As long as d if any
  /// parameter is refused, else empty.
  std::vector<SideDerivative> left = {}, right = {};
};

struct Gradient {
  double tolerance = 0.0;
  std::vector<std::string> by;
  std::vector<std::string> refused;  ///< per parameter: why it has no derivatives; empty: it has
  std::vector<GradientValue> values;
  long switches = 0, impacts = 0;  ///< of the run: their instants
};

/// Throws ModelError for unknown signals and instants after the end, and if the run ends early or
/// does not locate its switches.
Gradient gradient(const ModelMaker& make, GradientRequest request);

}  // namespace dynamy
