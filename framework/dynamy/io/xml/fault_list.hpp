/// FaultList: the errors of files, each once, up to a limit that ends the reading: a file of a
/// million mistakes costs no more than one of a thousand, and nobody reads more.
#pragma once
#include <dynamy/core/error.hpp>
#include <string>
#include <unordered_set>
#include <vector>

namespace dynamy {

/// Different errors after which reading ends.
inline constexpr std::size_t kMostErrors = 1000;
/// Errors, with those that are equal to an earlier one, after which reading ends.
inline constexpr std::size_t kMostRepeatedErrors = 50000;

class FaultList {
 public:
  /// Leaves an equal one out. Throws ModelError with all so far after kMostErrors different ones or
  /// kMostRepeatedErrors.
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
