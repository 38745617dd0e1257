#include <algorithm>
#include <dynamy/stages/islands.hpp>
#include <numeric>

namespace dynamy {

bool Islands::start(const SystemParts& parts) {
  const Topology& topology = *parts.topology;
  const std::size_t n = topology.systems().size();
  parent_.resize(n);
  std::iota(parent_.begin(), parent_.end(), 0);
  systemOfBlock_.clear();
  for (std::size_t i = 0; i < n; ++i)
    systemOfBlock_.insert(systemOfBlock_.end(),
                          static_cast<std::size_t>(topology.system(static_cast<int>(i)).blocks),
                          static_cast<int>(i));
  for (const Connection& c : topology.connections()) {
    int first = -1;
    for (const int i : c.systems) {
      if (topology.system(i).nu == 0) continue;
      if (first >= 0) join(first, i);
      first = i;
    }
  }
  bool known = true;
  parts.forContacts([&](std::size_t i) {
    known = known && std::any_of(topology.connections().begin(), topology.connections().end(),
                                 [&](const Connection& c) {
                                   return c.element == parts.contacts[i] &&
                                          (c.shapes || !c.systems.empty());
                                 });
  });
  return known;
}

bool Islands::forcesAreKnown(const SystemParts& parts) {
  const std::vector<Connection>& all = parts.topology->connections();
  bool known = true;
  parts.forForces([&](std::size_t i) {
    const ExternalForce* f = parts.forces[i];
    known = known && (!f->mayCouple() || std::any_of(all.begin(), all.end(), [f](const auto& c) {
              return c.element == f && !c.systems.empty();
            }));
  });
  return known;
}

void Islands::join(int a, int b) {
  a = of(a), b = of(b);
  parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

void Islands::join(const ContactSet& c, int contact) {
  const int first = systemOf(c, contact);
  const auto at = static_cast<std::size_t>(contact);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k)
    join(first,
         systemOfBlock_[static_cast<std::size_t>(c.segment[static_cast<std::size_t>(k)].block)]);
}

int Islands::of(int system) const {
  while (parent_[static_cast<std::size_t>(system)] != system) {
    int& up = parent_[static_cast<std::size_t>(system)];
    up = parent_[static_cast<std::size_t>(up)];
    system = up;
  }
  return system;
}

int Islands::systemOf(const ContactSet& c, int contact) const {
  const auto at = static_cast<std::size_t>(contact);
  if (c.segment0[at] == c.segment0[at + 1]) return -1;
  return systemOfBlock_[static_cast<std::size_t>(
      c.segment[static_cast<std::size_t>(c.segment0[at])].block)];
}

int Islands::systemOfVelocity(const Topology& topology, int i) {
  // The first system whose velocities end behind i.
  int low = 0, high = static_cast<int>(topology.systems().size()) - 1;
  while (low < high) {
    const int middle = (low + high) / 2;
    const SystemHandle& s = topology.system(middle);
    if (s.u0 + s.nu <= i)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

void Islands::spread(std::vector<char>& systems) const {
  std::vector<char> marked(systems.size(), 0);
  for (std::size_t i = 0; i < systems.size(); ++i)
    if (systems[i] != 0) marked[static_cast<std::size_t>(of(static_cast<int>(i)))] = 1;
  for (std::size_t i = 0; i < systems.size(); ++i)
    systems[i] = marked[static_cast<std::size_t>(of(static_cast<int>(i)))];
}

}  // namespace dynamy
