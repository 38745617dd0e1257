#include <algorithm>
#include <cctype>
#include <cstddef>
#include <dynamy/core/suggestion.hpp>
#include <vector>

namespace dynamy {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool sameLetter(char a, char b) { return lower(a) == lower(b); }

/// Letters that differ in place; only used to order names that are equally near.
std::size_t caseErrors(std::string_view word, std::string_view name) {
  std::size_t errors = 0;
  for (std::size_t i = 0; i < std::min(word.size(), name.size()); ++i) errors += word[i] != name[i];
  return errors;
}

bool begins(std::string_view word, std::string_view name) {
  return word.size() < name.size() &&
         std::equal(word.begin(), word.end(), name.begin(), sameLetter);
}

/// The only known name that begins with word, "" if there are none or several.
std::string completion(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t kShortestPrefix = 3;
  if (word.size() < kShortestPrefix) return "";
  std::string found;
  for (const std::string& name : known) {
    if (!begins(word, name)) continue;
    if (!found.empty() && found != name) return "";
    found = name;
  }
  return found;
}

}  // namespace

int typingDistance(std::string_view a, std::string_view b) {
  // d[i][j]: distance of the first i letters of a and the first j of b; three rows are enough.
  const std::size_t n = b.size() + 1;
  std::vector<int> before(n), above(n), row(n);
  for (std::size_t j = 0; j < n; ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < n; ++j) {
      const int replace = above[j - 1] + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({replace, above[j] + 1, row[j - 1] + 1});
      const bool swapped =
          i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[n - 1];
}

std::string nearest(std::string_view word, std::span<const std::string> known) {
  const std::string* best = nullptr;
  int bestDistance = 0;
  std::size_t bestCase = 0;
  for (const std::string& name : known) {
    // Names whose lengths alone are too far apart need no table.
    const std::size_t longer = std::max(word.size(), name.size());
    const std::size_t shorter = std::min(word.size(), name.size());
    const std::size_t limit = (longer + 1) / 3;
    if (longer - shorter > limit) continue;

    const int distance = typingDistance(word, name);
    if (distance > static_cast<int>(limit)) continue;
    const std::size_t errors = caseErrors(word, name);
    const bool better = best == nullptr || distance < bestDistance ||
                        (distance == bestDistance && errors < bestCase);
    if (better) {
      best = &name;
      bestDistance = distance;
      bestCase = errors;
    }
  }
  return best != nullptr ? *best : completion(word, known);
}

}  // namespace dynamy
