/// Pictures of a report, as SVG.
#pragma once
#include <dynamy/io/run_files/signals_file.hpp>
#include <string>
#include <vector>

namespace dynamy::app {

/// One line of events.csv.
struct EventLine {
  double t = 0.0;  ///< [s]
  bool impact = false;
  std::string contact, from, to;
  double speed = 0.0, impulse = 0.0;  ///< of an impact [m/s], [N s]
};

/// Reads events.csv. Throws FileError.
std::vector<EventLine> readEvents(const std::filesystem::path& file);

/// Picture of the status over time of the contacts with the most events, with a tick for each
/// impact. "" if there are no events.
std::string timelineSvg(const std::vector<EventLine>& events, double begin, double end);

/// Columns of the energies, and of the works that are not always zero. `ledger`: ledger.csv.
SignalTable energyTable(const SignalTable& ledger);

/// Columns of residual (decades), iterations, contacts and penetration that are not always zero.
SignalTable solverTable(const SignalTable& ledger);

/// An SVG picture as an <img> element, so that the style of the picture does not affect the page.
std::string imageOf(const std::string& svg, const std::string& text);

}  // namespace dynamy::app
