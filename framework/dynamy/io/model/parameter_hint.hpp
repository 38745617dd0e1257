/// Hints for a parameter that a file does not have.
#pragma once
#include <dynamy/io/xml/xml.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// How a number that stands in an attribute `name` becomes a parameter, where the file below `root`
/// has such an attribute; else the nearest of the names `known`.
std::string parameterHint(const XmlNode& root, const std::string& name,
                          const std::vector<std::string>& known);
/// The same for the file of a model that was read.
std::string parameterHint(const Model& model, const std::string& name,
                          const std::vector<std::string>& known);

}  // namespace dynamy
