/// FmuFile: what an FMU for co-simulation (FMI 2.0 or 3.0) says of itself, unpacked into a folder of
/// its own that is removed with it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

struct XmlNode;

/// What a number is in the interface of the FMU.
enum class FmuType { real, real32, int8, uint8, int16, uint16, int32, uint32, int64, uint64, flag };

struct FmuVariable {
  std::string name, causality;  ///< causality: input, output, parameter, local, …
  std::uint32_t reference = 0;
  FmuType type = FmuType::real;
};

/// A clock that ticks at shift + k interval and is an input.
struct FmuClock {
  std::uint32_t reference = 0;
  double interval = 0.0, shift = 0.0;  ///< [s]
};

class FmuFile {
 public:
  /// Unpacks `path`; one that is in use already is unpacked once. Throws std::runtime_error with the
  /// reason why it cannot serve.
  static std::shared_ptr<const FmuFile> open(const std::filesystem::path& path);
  FmuFile(const FmuFile&) = delete;
  FmuFile& operator=(const FmuFile&) = delete;
  ~FmuFile();

  int version = 0;                     ///< 2 or 3
  std::string token, identifier;       ///< GUID or token, and the name of the library
  std::filesystem::path folder;        ///< where it lies unpacked
  std::filesystem::path library;       ///< for this machine
  std::vector<FmuVariable> variables;  ///< single numbers alone: no arrays, texts, binaries
  std::vector<FmuClock> clocks;
  std::vector<std::string> left;  ///< inputs and outputs that are no single numbers, by their names
  double stepSize = 0.0;          ///< of its default experiment; 0: it states none [s]
  bool serializes = false;        ///< its state can be written as bytes and set back
  bool onlyOnce = false;          ///< one instance in a process
  bool events = false;            ///< it has the event mode of FMI 3.0

  /// The variable of this name and causality, or null.
  const FmuVariable* find(std::string_view name, std::string_view causality) const;
  std::vector<std::string> names(std::string_view causality) const;

 private:
  FmuFile() = default;
  void read();
  void add(const XmlNode& variable);
};

}  // namespace dynamy
