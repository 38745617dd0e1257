/// Measurements in a CSV file: a column of times, columns of signals, and columns of their standard
/// deviations if they are known.
///
///     t [ms], ball.z [mm], sigma(ball.z)
///     0,      1000.2,      0.5
///
/// Lines that begin with # are comments. An empty cell: nothing was measured.
#pragma once
#include <dynamy/simulation/fit/measured_run.hpp>
#include <filesystem>

namespace dynamy {

/// Reads a file of measurements of signals of `model`, at times within its run. Throws FileError if
/// it cannot be read, else ModelError with all faults, each with file, line and column.
std::vector<MeasuredValue> readMeasurements(const std::filesystem::path& file, const Model& model);
std::vector<MeasuredValue> measurementsIn(std::string_view text, const std::string& file,
                                          const Model& model);

/// Names in the head of such a file, of time and of signals alike; empty if it cannot be read.
std::vector<std::string> measuredNames(const std::filesystem::path& file);

/// "0.5mm" in SI units. Throws ModelError if it is no quantity of this kind; `what`: in its text.
double quantityOf(Unit unit, const std::string& text, const std::string& what);

}  // namespace dynamy
