/// FmuContents: what an FMU knows of its model beside the model's own files: its variables, in the
/// order of their value references. The program that exports writes it as resources/contents.json,
/// the library of the FMU reads it. Rejected: reading modelDescription.xml, which need not be at
/// hand where a FMU runs.
#pragma once
#include <dynamy/simulation/model/scene_description.hpp>
#include <string>
#include <utility>
#include <vector>

namespace dynamy::fmu {

enum class Role {
  time,       ///< t [s]
  parameter,  ///< of the model; fixed from the end of initialization on
  input,      ///< a number that others set
  output,     ///< a signal
  status      ///< a signal that is the status of a contact
};

struct Variable {
  Role role = Role::output;
  std::string name;
  std::string source;  ///< name of the parameter, of the input or of the signal in the model
  std::string unit;    ///< "m/s"; empty: none
  std::string text;    ///< one sentence
  double start = 0.0;  ///< of parameters and inputs
};

struct FmuContents {
  std::string model;  ///< file name relative to resources/model
  std::string token;  ///< instantiationToken
  /// Parameters that the export has set: (name, value).
  std::vector<std::pair<std::string, std::string>> set;
  std::vector<Variable> variables;  ///< by value reference

  std::string json() const;
  /// Throws FileError.
  static FmuContents read(const std::string& file);
};

/// True: the signal is the status of a contact.
bool isStatus(const NamedSignal& signal);

/// Statuses of contacts in the order of dynamy::Status, as an enumeration counts them: from 0.
const std::vector<std::string>& statusNames();

}  // namespace dynamy::fmu
