/// Machines in the Simulation Description Format (sdformat.org), with closed loops.
#pragma once
#include <dynamy/io/xml/xml.hpp>

#include "import/import_options.hpp"
#include "import/machine.hpp"

namespace dynamy::app {

/// \throws ModelError with all errors of the file
Machine readSdf(const XmlDocument& document, const ImportOptions& options);

}  // namespace dynamy::app
