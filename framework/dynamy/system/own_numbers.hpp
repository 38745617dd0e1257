/// OwnNumbers: the systems and frames of a view that has no room for others, numbered anew. Elements
/// keep the handles of the whole model, and are answered by these.
#pragma once
#include <algorithm>
#include <dynamy/system/topology.hpp>
#include <vector>

namespace dynamy {

class OwnNumbers {
 public:
  /// Of these systems and requested frames of `whole`, ascending.
  void assign(const Topology& whole, const std::vector<int>& systems,
              const std::vector<int>& frames);
  /// New number of a system, or of a frame; −1: there is no room for it.
  int of(int system) const { return placeOf(systems_, system); }
  int of(FrameHandle frame) const { return placeOf(frames_, frame.index); }
  /// New handle of a system. Throws std::logic_error: there is no room for it.
  const SystemHandle& handle(int system) const;
  /// All new handles, by their numbers.
  const std::vector<SystemHandle>& handles() const { return handles_; }

 private:
  static int placeOf(const std::vector<int>& ascending, int i) {
    const auto at = std::lower_bound(ascending.begin(), ascending.end(), i);
    return at == ascending.end() || *at != i ? -1 : static_cast<int>(at - ascending.begin());
  }
  std::vector<int> systems_, frames_;
  std::vector<SystemHandle> handles_;
};

}  // namespace dynamy
