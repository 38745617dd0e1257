/// ElementMemory: which numbers of State::memory belong to which element, and their values at the
/// start.
#pragma once
#include <utility>
#include <vector>

namespace dynamy {

class Element;

/// Numbers of one element in State::memory (a latch, a damage variable, the state of a controller).
struct MemoryHandle {
  int first = 0, size = 0;
};

class ElementMemory {
 public:
  /// Reserves numbers of `owner`, with their values at the start. An element reserves once: a
  /// second call raises std::logic_error.
  MemoryHandle reserve(const Element& owner, const std::vector<double>& initial);
  /// The numbers that `owner` reserved; size 0 if none.
  MemoryHandle of(const Element& owner) const;
  /// All numbers at the start.
  const std::vector<double>& start() const { return start_; }

 private:
  std::vector<std::pair<const Element*, MemoryHandle>> handles_;
  std::vector<double> start_;
};

}  // namespace dynamy
