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

/// Throws FileError.
std::vector<EventLine> readEvents(const std::filesystem::path& file);

/// Status of each contact over time, with a tick for each impact; of the contacts with the most
/// events. "" if there is none.
std::string timelineSvg(const std::vector<EventLine>& events, double begin, double end);

/// Energies, and the works that are not zero all the time. `ledger`: ledger.csv.
SignalTable energyTable(const SignalTable& ledger);

/// Residual (decades), iterations, contacts and penetration, as far as they are not zero.
SignalTable solverTable(const SignalTable& ledger);

/// A picture as an element of a page: it brings its own style and must not lend it to the page.
std::string imageOf(const std::string& svg, const std::string& text);

}  // namespace dynamy::app
