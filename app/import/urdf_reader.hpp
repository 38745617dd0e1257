/// Machines in the Unified Robot Description Format (wiki.ros.org/urdf/XML).
#pragma once
#include <dynamy/io/xml/xml.hpp>

#include "import/import_options.hpp"
#include "import/machine.hpp"

namespace dynamy::app {

/// \throws ModelError with all errors of the file
Machine readUrdf(const XmlDocument& document, const ImportOptions& options);

}  // namespace dynamy::app
