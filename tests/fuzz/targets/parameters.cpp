/// Parameters, replicates, defaults and settings: a model of the framework's own types. The text up
/// to the first zero byte is what follows <dynamy version="1">; the rest are --set, "name=value" in
/// lines.
#include <sstream>

#include "read_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dynamy;
  static fuzz::World world;
  const std::string all(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(all.find('\0'), all.size());
  Overrides set;
  std::istringstream lines(all.substr(std::min(end + 1, all.size())));
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find('='); at != std::string::npos)
      set.emplace_back(line.substr(0, at), line.substr(at + 1));
  fuzz::readText(world, "<dynamy version=\"1\">\n" + all.substr(0, end) + "\n</dynamy>", set,
                 [](Model&) {});
  return 0;
}
