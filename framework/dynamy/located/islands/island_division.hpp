/// IslandDivision: what joins systems to islands beside contacts that are held: elements for good,
/// and shapes that may meet soon.
#pragma once
#include <dynamy/located/governed/governed_motion.hpp>
#include <dynamy/located/islands/path_boxes.hpp>

namespace dynamy {

class IslandDivision {
 public:
  using Groups = std::vector<std::vector<int>>;
  /// Learns the model of s, if it is another one.
  void learn(const MechanicalSystem& s);
  /// True: the model has several islands, and positions, velocities and held contacts are all of
  /// their state.
  bool possible(const State& x) const { return several_ && x.memory.size() == 0; }
  /// True: elements join these systems for the whole run.
  bool inseparable(const std::vector<int>& systems) const;
  /// A contact that is held and the systems that it joins.
  struct Joined {
    ContactKey key;
    std::vector<int> systems;
  };
  /// The contacts that are held at x, a state of an island with its state data; s: the view on it.
  static std::vector<Joined> joinedAt(MechanicalSystem& s, const State& x);
  /// The islands among `systems`, ascending, at x, joined by contacts and by shapes that may meet
  /// within `h` [s]. Each list is ascending, and they are in the order of their first systems.
  Groups groups(const std::vector<int>& systems, const std::vector<Joined>& joined, const State& x,
                double h);
  std::span<const MovingShape> shapes() const { return shapes_; }
  /// Number of clocks for which there is memory.
  std::size_t most() const { return most_; }
  Kinematics& kinematics() { return kinematics_; }

 private:
  const Topology* topology_ = nullptr;
  std::vector<const ExternalForce*> forces_;
  std::vector<const NonSmoothElement*> contacts_;
  bool several_ = false;
  std::size_t most_ = 1;
  Islands joined_;
  std::vector<MovingShape> shapes_;
  Kinematics kinematics_;
};

}  // namespace dynamy
