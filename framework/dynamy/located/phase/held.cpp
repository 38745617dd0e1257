#include <algorithm>
#include <dynamy/located/phase/held.hpp>

namespace dynamy {

const Held* findHeld(const std::vector<Held>& held, ContactKey key) {
  for (const Held& h : held)
    if (h.key == key) return &h;
  return nullptr;
}

const Held* findHeld(const std::vector<Held>& held, HeldKey part) {
  for (const Held& h : held)
    if (h.key == part.key && h.first == part.first) return &h;
  return nullptr;
}

void heldKeys(const std::vector<Held>& held, std::vector<ContactKey>& out) {
  for (const Held& h : held)
    if (h.first == 0) out.push_back(h.key);
  std::sort(out.begin(), out.end());
}

}  // namespace dynamy
