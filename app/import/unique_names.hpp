/// Names that a model may have, each once, for names of a file that has other rules.
#pragma once
#include <set>
#include <string>

namespace dynamy::app {

class UniqueNames {
 public:
  /// `wanted` with _ instead of what a name must not contain, and a number behind it if it is taken.
  std::string take(const std::string& wanted);

 private:
  std::set<std::string> taken_;
};

}  // namespace dynamy::app
