#include "import/unique_names.hpp"

#include <string_view>

namespace dynamy::app {

std::string UniqueNames::take(const std::string& wanted) {
  constexpr std::string_view kForbidden = " \t\r\n./[]{}*\"'<>&";
  std::string name = wanted.empty() ? "unnamed" : wanted;
  for (char& c : name)
    if (kForbidden.find(c) != std::string_view::npos) c = '_';
  const std::string plain = name;
  for (int k = 2; !taken_.insert(name).second; ++k) name = plain + "_" + std::to_string(k);
  return name;
}

}  // namespace dynamy::app
