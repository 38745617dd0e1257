/// The text of a model with bodies in joints and a frame "world" at rest.
#pragma once
#include <string>

namespace dynamy::reference {

/// Each argument holds the elements of the section of its name; `scheme` stands in <simulation>.
inline std::string jointScene(const std::string& systems, const std::string& forces,
                              const std::string& elements, const std::string& scheme = {}) {
  return "<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + systems +
         "</systems><forces>" + forces + "</forces><elements>" + elements +
         "</elements><simulation until=\"1\" step=\"1e-2\">" + scheme + "</simulation></dynamy>";
}

}  // namespace dynamy::reference
