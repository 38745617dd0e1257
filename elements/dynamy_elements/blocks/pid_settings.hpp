/// PidSettings: what the sampled and the continuous PID controller have in common:
///
///   F = kp e + I + D + f,   out = clamp(F, lower, upper)
///
/// with the error e, its integral part I, its derivative part D and the feedforward f.
#pragma once
#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/signal_formulas.hpp>
#include <vector>

namespace dynamy {

struct PidSettings {
  /// `aboutRate`: text of the attribute that gives the rate of the error.
  static void declare(Attributes& a, const char* aboutRate);
  /// Throws ModelError if the lower limit lies above the upper one.
  explicit PidSettings(const Parameters& x);

  /// What keeps I from growing at a limit: I stays, I follows the limit, nothing.
  enum class AntiWindup { clamp, back, none };

  SignalFormulas error, rate, feedforward;
  double kp, ki, kd;    ///< gains of e, of its integral [1/s] and of its rate [s]
  double filter;        ///< time constant Tf of the rate [s]
  double lower, upper;  ///< of the output; infinite: none
  double tracking;      ///< time constant of AntiWindup::back [s]
  AntiWindup antiWindup;

  std::vector<SignalFormulas*> formulas() { return {&error, &rate, &feedforward}; }
  double limited(double F) const { return std::clamp(F, lower, upper); }
  /// True: I stays, since a change of it of the sign of `change` drives F further beyond a limit.
  bool staysAt(double F, double change) const {
    return antiWindup == AntiWindup::clamp &&
           ((F > upper && change > 0.0) || (F < lower && change < 0.0));
  }
};

}  // namespace dynamy
