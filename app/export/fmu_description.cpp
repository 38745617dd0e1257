#include "export/fmu_description.hpp"

#include <fmt/format.h>

#include <array>
#include <dynamy/core/version.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <set>
#include <sstream>
#include <string_view>

namespace dynamy::app {
namespace {

using fmu::Role;
using fmu::Variable;

struct BaseUnit {
  std::string_view name;
  UnitExponents exponents;
};
constexpr std::array<BaseUnit, 8> kUnits{{{"kg", {1, 0, 0, 0}},
                                          {"m", {0, 1, 0, 0}},
                                          {"s", {0, 0, 1, 0}},
                                          {"rad", {0, 0, 0, 1}},
                                          {"Hz", {0, 0, -1, 0}},
                                          {"N", {1, 1, -2, 0}},
                                          {"J", {1, 2, -2, 0}},
                                          {"W", {1, 2, -3, 0}}}};

constexpr const char* kStatusType = "ContactStatus";

/// ` name="text"`, or nothing for an empty text.
std::string attribute(std::string_view name, std::string_view text) {
  return text.empty() ? "" : fmt::format(" {}=\"{}\"", name, escapedXml(text));
}

std::string units(const fmu::FmuContents& contents) {
  std::set<std::string> used;
  for (const Variable& v : contents.variables)
    if (!v.unit.empty()) used.insert(v.unit);
  std::string out;
  for (const std::string& unit : used) {
    const UnitExponents e = unitExponents(unit);
    std::string base;
    for (const auto& [name, n] :
         {std::pair("kg", e.kg), std::pair("m", e.m), std::pair("s", e.s), std::pair("rad", e.rad)})
      if (n != 0) base += fmt::format(" {}=\"{}\"", name, n);
    out += fmt::format("    <Unit name=\"{}\"><BaseUnit{}/></Unit>\n", escapedXml(unit), base);
  }
  return out.empty() ? out : "  <UnitDefinitions>\n" + out + "  </UnitDefinitions>\n";
}

std::string types(const fmu::FmuContents& contents) {
  bool used = false;
  for (const Variable& v : contents.variables) used = used || v.role == Role::status;
  if (!used) return {};
  std::string items;
  for (std::size_t i = 0; i < fmu::statusNames().size(); ++i)
    items += fmt::format("      <Item name=\"{}\" value=\"{}\"/>\n", fmu::statusNames()[i], i);
  return fmt::format(
      "  <TypeDefinitions>\n    <EnumerationType name=\"{}\">\n{}    </EnumerationType>\n"
      "  </TypeDefinitions>\n",
      kStatusType, items);
}

std::string variable(const Variable& v, std::size_t reference) {
  const std::string head = attribute("name", v.name) +
                           fmt::format(" valueReference=\"{}\"", reference) +
                           attribute("description", v.text);
  const std::string unit = attribute("unit", v.unit);
  switch (v.role) {
    case Role::time:
      return fmt::format("<Float64{} causality=\"independent\" variability=\"continuous\"{}/>",
                         head, unit);
    case Role::parameter:
      return fmt::format(
          "<Float64{} causality=\"parameter\" variability=\"fixed\" initial=\"exact\" "
          "start=\"{}\"/>",
          head, v.start);
    case Role::input:
      return fmt::format(
          "<Float64{} causality=\"input\" variability=\"continuous\" intermediateUpdate=\"true\" "
          "start=\"{}\"/>",
          head, v.start);
    case Role::output:
      return fmt::format(
          "<Float64{} causality=\"output\" variability=\"continuous\" initial=\"calculated\" "
          "intermediateUpdate=\"true\"{}/>",
          head, unit);
    case Role::status:
      break;
  }
  return fmt::format(
      "<Enumeration{} causality=\"output\" variability=\"discrete\" initial=\"calculated\" "
      "declaredType=\"{}\"/>",
      head, kStatusType);
}

std::string variables(const fmu::FmuContents& contents) {
  std::string out = "  <ModelVariables>\n";
  for (std::size_t i = 0; i < contents.variables.size(); ++i)
    out += "    " + variable(contents.variables[i], i) + '\n';
  return out + "  </ModelVariables>\n";
}

std::string structure(const fmu::FmuContents& contents) {
  std::string out = "  <ModelStructure>\n";
  for (const char* role : {"Output", "InitialUnknown"})
    for (std::size_t i = 0; i < contents.variables.size(); ++i)
      if (const Role k = contents.variables[i].role; k == Role::output || k == Role::status)
        out += fmt::format("    <{} valueReference=\"{}\"/>\n", role, i);
  return out + "  </ModelStructure>\n";
}

}  // namespace

UnitExponents unitExponents(const std::string& unit) {
  UnitExponents out;
  std::string spaced;
  for (const char c : unit) spaced += c == '/' ? std::string(" / ") : std::string(1, c);
  std::istringstream words(spaced);
  int sign = 1;
  for (std::string word; words >> word;) {
    if (word == "/") {
      sign = -1;
      continue;
    }
    const std::size_t hat = word.find('^');
    const int power = sign * (hat == std::string::npos ? 1 : std::stoi(word.substr(hat + 1)));
    for (const BaseUnit& b : kUnits) {
      if (b.name != word.substr(0, hat)) continue;
      out.kg += power * b.exponents.kg, out.m += power * b.exponents.m;
      out.s += power * b.exponents.s, out.rad += power * b.exponents.rad;
    }
  }
  return out;
}

std::string fmuDescription(const FmuHead& head, const fmu::FmuContents& contents) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription";
  out += attribute("fmiVersion", "3.0") + attribute("modelName", head.title);
  out += attribute("description", head.text) + attribute("instantiationToken", contents.token);
  out += attribute("generationTool", std::string("dynamY ") + kVersionText);
  out += " variableNamingConvention=\"flat\">\n  <CoSimulation";
  out += attribute("modelIdentifier", head.identifier);
  for (const char* ability :
       {"canGetAndSetFMUState", "canSerializeFMUState", "canHandleVariableCommunicationStepSize",
        "providesIntermediateUpdate", "mightReturnEarlyFromDoStep",
        "canReturnEarlyAfterIntermediateUpdate", "hasEventMode"})
    out += attribute(ability, "true");
  if (head.fixedStep > 0.0) out += fmt::format(" fixedInternalStepSize=\"{}\"", head.fixedStep);
  out += "/>\n" + units(contents) + types(contents);
  out +=
      "  <LogCategories><Category name=\"logStatusError\" description=\"why a call "
      "failed\"/></LogCategories>\n";
  out += fmt::format("  <DefaultExperiment startTime=\"0\" stopTime=\"{}\"", head.until);
  if (head.tolerance > 0.0) out += fmt::format(" tolerance=\"{}\"", head.tolerance);
  out += fmt::format(" stepSize=\"{}\"/>\n", head.step);
  return out + variables(contents) + structure(contents) + "</fmiModelDescription>\n";
}

}  // namespace dynamy::app
