#include <dynamy/core/error.hpp>
#include <dynamy/system/element_memory.hpp>

namespace dynamy {

MemoryHandle ElementMemory::reserve(const Element& owner, const std::vector<double>& initial) {
  expects(of(owner).size == 0, "an element reserves its memory once");
  const MemoryHandle handle{static_cast<int>(start_.size()), static_cast<int>(initial.size())};
  handles_.emplace_back(&owner, handle);
  start_.insert(start_.end(), initial.begin(), initial.end());
  return handle;
}

MemoryHandle ElementMemory::of(const Element& owner) const {
  for (const auto& [element, handle] : handles_)
    if (element == &owner) return handle;
  return {};
}

}  // namespace dynamy
