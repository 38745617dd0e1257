/// The model of a machine as the text of an XML file.
#pragma once
#include <filesystem>
#include <string>

#include "import/machine.hpp"

namespace dynamy::app {

/// \pre the machine is simplified. `source`: name of the file it comes from; `folder`: of the model,
/// from which the paths of meshes are counted. Renamed links and
/// joints are added to the notes, which stand as a comment in the text.
std::string modelText(Machine& machine, const std::string& source,
                      const std::filesystem::path& folder);

/// "robot.urdf:12:3: <transmission>: …" of a note, one line.
std::string noteText(const ImportNote& note);

}  // namespace dynamy::app
