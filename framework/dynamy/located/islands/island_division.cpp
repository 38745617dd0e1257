#include <algorithm>
#include <dynamy/located/islands/island_division.hpp>
#include <map>
#include <utility>

namespace dynamy {
namespace {

/// Memory that clocks may take in all, and what one takes [B]: 187 kB of 300 balls, 392 kB of 1000.
constexpr std::size_t kMemory = 4'000'000'000, kOfClock = 100'000, kOfSystem = 300;

}  // namespace

void IslandDivision::learn(const MechanicalSystem& s) {
  const SystemParts& parts = s.parts();
  if (topology_ == parts.topology && forces_ == parts.forces && contacts_ == parts.contacts) return;
  topology_ = parts.topology, forces_ = parts.forces, contacts_ = parts.contacts;
  const auto& systems = topology_->systems();
  const bool renews = std::any_of(systems.begin(), systems.end(), [](const auto* e) {
    return e->abilities().renewable != nullptr;
  });
  std::vector<int> roots;
  const bool known = joined_.start(parts);
  bool placeless = true;  // systems without velocities have no positions
  for (int i = 0; i < static_cast<int>(systems.size()); ++i) {
    placeless = placeless && (topology_->system(i).nu > 0 || topology_->system(i).nq == 0);
    if (topology_->system(i).nu == 0) continue;
    if (joined_.of(i) == i) roots.push_back(i);
  }
  several_ = known && Islands::forcesAreKnown(parts) && !renews && placeless && roots.size() > 1;
  most_ = kMemory / (kOfClock + kOfSystem * systems.size());
  shapes_.clear();
  // Shapes take part in contact if an element has requested their frames.
  std::map<std::pair<int, int>, int> requested;
  int handle = 0;
  for (const std::pair<int, int>& frame : topology_->requestedFrames())
    requested.try_emplace(frame, handle++);
  for (int i = 0; i < static_cast<int>(systems.size()); ++i) {
    if (topology_->system(i).nu == 0) continue;
    Description d;
    systems[static_cast<std::size_t>(i)]->describe(d);
    for (const PlacedShape& p : d.shapes) {
      const auto frame = requested.find({i, p.frame});
      if (p.shape->material().empty() || frame == requested.end()) continue;
      shapes_.push_back({{frame->second}, i, p.shape->r_SB_K(), boundOf(*p.shape)});
    }
  }
}

bool IslandDivision::inseparable(const std::vector<int>& systems) const {
  return std::all_of(systems.begin(), systems.end(),
                     [&](int i) { return joined_.of(i) == joined_.of(systems.front()); });
}

std::vector<IslandDivision::Joined> IslandDivision::joinedAt(MechanicalSystem& s, const State& x) {
  std::vector<Joined> out;
  GovernedState state;
  std::vector<ContactKey> keys;
  if (!state.read(x.scheme) || state.governor.mode() != SwitchGovernor::Mode::locate) return out;
  heldKeys(state.held.held, keys);
  if (keys.empty()) return out;
  const ContactSet& c =
      s.evaluate(x, {.slot = 1, .held = HeldContacts{.keys = keys, .follow = true, .alone = true}})
          .contacts;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!std::binary_search(keys.begin(), keys.end(), c.key[at])) continue;
    Joined joined{c.key[at], {}};
    for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k)
      joined.systems.push_back(Islands::systemOfVelocity(
          *s.parts().topology, c.segment[static_cast<std::size_t>(k)].u0));
    out.push_back(std::move(joined));
  }
  return out;
}

IslandDivision::Groups IslandDivision::groups(const std::vector<int>& systems,
                                              const std::vector<Joined>& joined, const State& x,
                                              double h) {
  Islands islands = joined_;
  for (const Joined& contact : joined)
    for (const int i : contact.systems) islands.join(contact.systems.front(), i);
  const auto gather = [&] {
    Groups out;
    std::vector<int> groupOf(topology_->systems().size(), -1);
    for (const int i : systems) {
      int& group = groupOf[static_cast<std::size_t>(islands.of(i))];
      if (group < 0) group = static_cast<int>(out.size()), out.emplace_back();
      out[static_cast<std::size_t>(group)].push_back(i);
    }
    return out;
  };
  Groups out = gather();
  if (out.size() < 2) return out;
  std::vector<std::vector<MovingShape>> shapes(out.size());
  std::vector<FrameHandle> frames;
  std::vector<int> groupOf(topology_->systems().size(), -1);
  for (std::size_t g = 0; g < out.size(); ++g)
    for (const int i : out[g]) groupOf[static_cast<std::size_t>(i)] = static_cast<int>(g);
  for (const MovingShape& shape : shapes_)
    if (const int g = groupOf[static_cast<std::size_t>(shape.system)]; g >= 0)
      shapes[static_cast<std::size_t>(g)].push_back(shape), frames.push_back(shape.frame);
  kinematics_.evaluate(*topology_, x.t, view(x.q), view(x.u), view(x.memory), nullptr, frames);
  std::vector<PathBoxes> paths(out.size());
  for (std::size_t g = 0; g < out.size(); ++g) paths[g].expect(shapes[g], kinematics_, h);
  for (std::size_t a = 0; a < out.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (paths[a].meets(paths[b])) islands.join(out[a].front(), out[b].front());
  return gather();
}

}  // namespace dynamy
