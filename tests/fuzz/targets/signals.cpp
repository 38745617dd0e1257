/// A signals.csv of any text: columns of equal length, or an error with its line.
#include <cstdint>
#include <cstdlib>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/signals_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dynamy;
  try {
    const SignalTable table = signalsIn({reinterpret_cast<const char*>(data), size}, "signals.csv");
    for (const std::vector<double>& column : table.columns)
      if (column.size() != table.t.size()) std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
