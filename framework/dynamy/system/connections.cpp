#include <algorithm>
#include <dynamy/system/connections.hpp>

namespace dynamy {

void Connections::begin(const Element* element) {
  noting_ = element != nullptr;
  if (noting_) list_.push_back({element, {}, false});
}

void Connections::note(int system) {
  if (!noting_) return;
  std::vector<int>& known = list_.back().systems;
  const auto at = std::lower_bound(known.begin(), known.end(), system);
  if (at == known.end() || *at != system) known.insert(at, system);
}

void Connections::noteShapes() {
  if (noting_) list_.back().shapes = true;
}

}  // namespace dynamy
