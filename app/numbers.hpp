/// Checks of numbers on the command line. CLI11's own checks accept "inf", and also "nan", which is
/// neither too small nor too large.
#pragma once
#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace dynamy::app {

/// Accepts a text that is a finite number for which `fits` holds; `expected` describes such numbers
/// in the error message.
template <class Fits>
CLI::Validator finiteNumber(const std::string& name, const std::string& expected,
                            const Fits& fits) {
  return CLI::Validator(
      [expected, fits](std::string& text) {
        double x = 0.0;
        const bool reads = CLI::detail::lexical_cast(text, x);
        if (reads && std::isfinite(x) && fits(x)) return std::string();
        return "expects " + expected + ", is " + text;
      },
      name);
}

/// Accepts a finite number > 0.
inline CLI::Validator positiveNumber() {
  return finiteNumber("POSITIVE", "a positive number", [](double x) { return x > 0.0; });
}

/// Accepts a whole number from `low` to `high`.
inline CLI::Validator wholeNumber(double low, double high = 2147483647.0) {
  const bool open = high >= 2147483647.0;
  const std::string bounds =
      open ? CLI::detail::to_string(low) + " or more"
           : CLI::detail::to_string(low) + " to " + CLI::detail::to_string(high);
  return finiteNumber("", "a whole number, " + bounds, [low, high](double x) {
    return x == std::floor(x) && low <= x && x <= high;
  });
}

/// Accepts a number between two bounds, both included.
inline CLI::Validator numberBetween(double low, double high) {
  const std::string bounds = CLI::detail::to_string(low) + " - " + CLI::detail::to_string(high);
  return finiteNumber("FLOAT in [" + bounds + "]", "a number in " + bounds,
                      [low, high](double x) { return low <= x && x <= high; });
}

}  // namespace dynamy::app
