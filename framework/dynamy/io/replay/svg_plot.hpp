#pragma once
/// \file
/// signals.svg: the recorded signals over time as small multiples with one time axis. Signals of
/// one element with the same unit share a panel; a signal without a known unit has its own panel.
/// SVG is text that browsers, papers and reviews all show, so no plotting library is needed.

#include <dynamy/io/run_files/signals_file.hpp>
#include <filesystem>
#include <string>

namespace dynamy {

/// The picture as SVG text with `title` above it. It has at most 40 panels; a note gives the number
/// of omitted ones.
std::string signalsSvg(const SignalTable& table, const std::string& title);

/// Writes signalsSvg to a file. \throws FileError
void writeSignalsSvg(const std::filesystem::path& path, const SignalTable& table,
                     const std::string& title);

/// Which signals are drawn together: indices into `signals`, in order of their first appearance.
std::vector<std::vector<std::size_t>> panelsOf(std::span<const SignalName> signals);

/// `text` with the five characters that XML and HTML reserve replaced by entities.
std::string escapedXml(std::string_view text);

}  // namespace dynamy
