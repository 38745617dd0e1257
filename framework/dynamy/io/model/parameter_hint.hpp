/// Hints for a parameter that a file does not have.
#pragma once
#include <dynamy/io/xml/xml.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// How a number that stands in an attribute `asked` becomes a parameter, where the file below `root`
/// has such an attribute ("box.mass": the mass of the element "box"); else the nearest of `known`.
std::string parameterHint(const XmlNode& root, const std::string& asked,
                          const std::vector<std::string>& known);
/// The same for the file of a model that was read.
std::string parameterHint(const Model& model, const std::string& name,
                          const std::vector<std::string>& known);

}  // namespace dynamy
