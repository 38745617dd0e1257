#include <dynamy/core/kept_text.hpp>
#include <mutex>
#include <set>

namespace dynamy {

std::string_view keptText(std::string text) {
  static std::mutex mutex;
  static std::set<std::string> all;
  const std::scoped_lock lock(mutex);
  return *all.insert(std::move(text)).first;
}

}  // namespace dynamy
