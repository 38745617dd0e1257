#include <algorithm>
#include <dynamy/system/connections.hpp>

namespace dynamy {

void Connections::begin(const Element* element) {
  noting_ = element != nullptr;
  if (noting_) list_.push_back({element, {}, false});
}

namespace {

void insert(std::vector<int>& known, int system) {
  const auto at = std::lower_bound(known.begin(), known.end(), system);
  if (at == known.end() || *at != system) known.insert(at, system);
}

}  // namespace

void Connections::note(int system) {
  if (noting_) insert(list_.back().systems, system);
}

void Connections::add(const Element& element, const std::vector<int>& systems) {
  for (Connection& c : list_)
    if (c.element == &element)
      for (const int i : systems) insert(c.systems, i);
}

void Connections::noteShapes() {
  if (noting_) list_.back().shapes = true;
}

}  // namespace dynamy
