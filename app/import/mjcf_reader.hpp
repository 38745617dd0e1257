/// Machines in MJCF (mujoco.readthedocs.io, XML reference).
#pragma once
#include <dynamy/io/xml/xml.hpp>

#include "import/import_options.hpp"
#include "import/machine.hpp"

namespace dynamy::app {

/// \throws ModelError with all errors of the file and of those it includes
Machine readMjcf(const XmlDocument& document, const ImportOptions& options);

}  // namespace dynamy::app
