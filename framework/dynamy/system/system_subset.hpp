/// SystemSubset: some systems of a model, those of an island for example, with the frames, forces
/// and contact elements that act on them. Evaluations of a view on them loop over these alone.
#pragma once
#include <algorithm>
#include <dynamy/system/own_numbers.hpp>

namespace dynamy {

class SystemSubset {
 public:
  /// What evaluations hold of systems outside: nothing, or the frames where they rest, which what
  /// moves may touch. Omitted: there is no room for them either. The systems of the subset are then
  /// numbered anew, in a Topology of their own, and elements keep their handles of the whole model.
  enum class Outside : std::uint8_t { absent, resting, omitted };
  SystemSubset() = default;
  explicit SystemSubset(Outside outside) : outside_(outside) {}
  /// Holds the systems whose entry in `without` is 0, one entry for each system. Elements that
  /// requested systems, all of which are outside or have no velocities, do not act.
  template <class Forces, class Contacts>
  void assign(const Topology& topology, std::vector<char> without, const Forces& forces,
              const Contacts& contacts) {
    if (without == without_) return;
    choose(topology, std::move(without));
    forces_ = acting(forces), contacts_ = acting(contacts);
    for (const int i : forces_) addBeside(topology, forces[static_cast<std::size_t>(i)]);
  }
  /// True: the system with this index is outside.
  bool leavesOut(int system) const { return without_[static_cast<std::size_t>(system)] != 0; }
  const std::vector<int>& systems() const { return systems_; }    ///< their indices, ascending
  const std::vector<int>& frames() const { return frames_; }      ///< of Topology::requestedFrames
  const std::vector<int>& forces() const { return forces_; }      ///< indices of those that act
  const std::vector<int>& contacts() const { return contacts_; }  ///< likewise
  /// Systems outside on which a force of the subset acts as well; all of them if there is a force
  /// that requested no system by name.
  const std::vector<int>& beside() const { return beside_; }
  bool outsideRests() const { return outside_ == Outside::resting; }
  /// Where others are omitted: the new numbers of the systems; else null.
  const OwnNumbers* own() const { return outside_ == Outside::omitted ? &own_ : nullptr; }
  /// True: some systems with velocities rest outside. They have u = 0 and feel no forces.
  bool anyRests() const { return rests_; }
  /// Another number after each change; no two subsets have the same.
  std::uint64_t stamp() const { return stamp_; }

 private:
  void choose(const Topology& topology, std::vector<char> without);
  void addBeside(const Topology& topology, const Element* force);
  bool acts(const Element* element) const {
    return !std::binary_search(idle_.begin(), idle_.end(), element);
  }
  template <class Elements>
  std::vector<int> acting(const Elements& elements) const {
    std::vector<int> out;
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (acts(elements[i])) out.push_back(static_cast<int>(i));
    return out;
  }
  Outside outside_ = Outside::absent;
  std::vector<char> without_;
  std::vector<int> systems_, frames_, forces_, contacts_, beside_;
  OwnNumbers own_;
  std::vector<const Element*> idle_;  // elements that do not act, ascending
  std::uint64_t stamp_ = 0;
  bool rests_ = false;
};

/// The handle by which a view finds a system: its own where others are omitted. some: null: all.
inline const SystemHandle& ownHandle(const SystemSubset* some, const SystemHandle& whole) {
  const OwnNumbers* own = some != nullptr ? some->own() : nullptr;
  return own != nullptr ? own->handle(whole.index) : whole;
}

}  // namespace dynamy
