/// FaultList: the errors of files, each once, up to a limit that ends the reading. So a file with a
/// million errors costs no more than one with a thousand, and nobody reads more.
#pragma once
#include <dynamy/core/error.hpp>
#include <string>
#include <unordered_set>
#include <vector>

namespace dynamy {

/// Number of different errors after which reading ends.
inline constexpr std::size_t kMostErrors = 1000;
/// Number of errors, including repeated ones, after which reading ends.
inline constexpr std::size_t kMostRepeatedErrors = 50000;

class FaultList {
 public:
  /// Adds an error unless it equals an earlier one. Throws ModelError with all errors so far after
  /// kMostErrors different or kMostRepeatedErrors errors in total.
  void add(Diagnostic diagnostic);
  std::size_t size() const { return items_.size(); }
  const std::vector<Diagnostic>& items() const { return items_; }
  bool full() const { return items_.size() >= kMostErrors || added_ >= kMostRepeatedErrors; }
  /// Throws ModelError with all errors, file by file and in the order of their places, if there is
  /// any.
  void throwIfAny() const;
  [[noreturn]] void throwAll() const;

 private:
  std::vector<Diagnostic> items_;
  std::unordered_set<std::string> known_;
  std::size_t added_ = 0;
};

}  // namespace dynamy
