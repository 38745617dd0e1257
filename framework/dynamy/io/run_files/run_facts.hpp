/// What run.json tells of a run, whoever runs it: settings, sizes, costs, energies, certificates.
#pragma once
#include <cstdint>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/checks.hpp>
#include <dynamy/simulation/report/run_report.hpp>
#include <string>
#include <utility>
#include <vector>

namespace dynamy {

/// Writes the general members of run.json. `state`: how the run ended, or that it goes on. `set`:
/// parameters that were given from outside, name and value.
void writeRunFacts(JsonWriter& json, const Model& model, const RunReport& report,
                   const std::vector<CheckResult>& checks, const std::string& state,
                   const std::vector<std::pair<std::string, std::string>>& set);

/// "16 hexadecimal digits".
std::string hashText(std::uint64_t hash);

}  // namespace dynamy
