/// The variations of a sweep, and the list of runs that follows from them.
///
///   mu=0.1:0.5:9          nine values, equal distances
///   mu=1e-3:1:4:log       four values, equal ratios
///   mu=0.3,0.5,0.7        a list
///   mu=0.3                the same in all runs
///   mu=uniform(0.1,0.5)   --samples values drawn at random
///   mu=normal(0.3,0.05)   the same, mean and standard deviation
///
/// Grids and lists are combined with each other; the last one varies fastest. Each combination is
/// repeated --samples times if any value is drawn. All values are written to the manifest before
/// the first run, and every process that computes a run, on any machine, reads them from there.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace dynamy::app {

/// The values of one parameter or option ("--step").
struct Variation {
  enum class Draw { none, uniform, normal };
  std::string name;
  std::vector<std::string> values;  ///< empty if they are drawn
  Draw draw = Draw::none;
  double a = 0.0, b = 0.0;  ///< bounds, or mean and standard deviation
  std::string doubt;        ///< how a range was read that may be meant as FROM:STEP:TO; else ""
  bool fixed() const { return draw == Draw::none && values.size() == 1; }
};

/// Reads the text after "NAME="; messages name `option`. Throws CLI::ValidationError.
Variation readVariation(const std::string& name, const std::string& text,
                        const std::string& option);

/// Reads "A:B" after "NAME=", and takes `count` values between the two. Throws CLI::ValidationError.
Variation readBounds(const std::string& name, const std::string& text, int count,
                     const std::string& option);

/// Table of a sweep: one row for each run, one column for each varied name.
struct SweepPlan {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;
};

/// Combines the variations to runs. Throws CLI::ValidationError if nothing varies or if there are
/// more than a million runs.
SweepPlan planOf(const std::vector<Variation>& variations, int samples, std::uint64_t seed);

/// Reads a plan from a CSV table of the user; a column "id" is ignored. Throws FileError.
SweepPlan readTable(const std::string& file);

/// The values of each varied name, a line each: " mu = 0.1, 0.2, 0.3, … 0.9   9 values".
std::string valuesText(const SweepPlan& plan);

/// manifest.csv: id, then the plan's columns.
std::string manifestText(const SweepPlan& plan);

}  // namespace dynamy::app
