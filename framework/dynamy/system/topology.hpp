/// Topology: where everything lies in the flat arrays; turns names into handles, once, in
/// connect().
#pragma once
#include <dynamy/core/types.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/shape.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// One system in q, u and the mass blocks.
struct SystemHandle {
  int index = -1;
  int q0 = 0, nq = 0;          ///< slice of q, all blocks
  int u0 = 0, nu = 0;          ///< slice of u, all blocks
  int block0 = 0, blocks = 1;  ///< mass blocks
  int blockNq = 0, blockNu = 0;
};

/// One frame among those the model's elements asked for.
struct FrameHandle {
  int index = -1;
};

/// Numbers of one element in State::memory (a latch, a damage variable, the state of a controller).
struct MemoryHandle {
  int first = 0, size = 0;
};

/// A shape in the scene: which frame carries it.
struct ShapeInstance {
  const Shape* shape = nullptr;
  FrameHandle frame;
  int system = -1;  ///< index of the system
};

class Topology {
 public:
  /// Systems in order of the model; computes all offsets.
  explicit Topology(const std::vector<const PartialMechanicalSystem*>& systems);

  /// Handle of the system called `name`. Throws ModelError with the nearest known name.
  SystemHandle system(std::string_view name, const Element& asking) const;
  const SystemHandle& system(int index) const { return handles_[static_cast<std::size_t>(index)]; }
  /// Frame by name: "body" (its frame 0) or "body.name" as named in describe(). From then on it is
  /// evaluated in every step.
  FrameHandle frame(std::string_view name, const Element& asking);
  FrameHandle frame(const SystemHandle& system, int id);
  /// Which of the bodies of a system that consists of several carries frame `id`; null: it is one.
  const NamedBody* body(int system, int id) const;
  /// All shapes of all systems that have a material; asks for their frames.
  std::vector<ShapeInstance> shapesWithMaterial();

  /// Reserves numbers of `owner` in State::memory, with their values at the start; in connect(),
  /// once. The element reads them from Kinematics and changes them in remember() alone.
  MemoryHandle memory(const Element& owner, const std::vector<double>& initial);
  /// What `owner` reserved; size 0 if nothing.
  MemoryHandle memoryOf(const Element& owner) const;
  const std::vector<double>& memoryStart() const { return memoryStart_; }

  int nq() const { return nq_; }
  int nu() const { return nu_; }
  int blocks() const { return blocks_; }
  const std::vector<const PartialMechanicalSystem*>& systems() const { return systems_; }
  /// Frames asked for so far: (system index, frame id).
  const std::vector<std::pair<int, int>>& requestedFrames() const { return requested_; }

 private:
  std::vector<const PartialMechanicalSystem*> systems_;
  std::vector<SystemHandle> handles_;
  std::vector<std::pair<int, int>> requested_;
  std::vector<std::vector<int>>
      indexOf_;  // per system and frame id: of requested_, −1: not asked for
  std::vector<std::pair<const Element*, MemoryHandle>> memories_;
  std::vector<double> memoryStart_;
  struct Placed {
    const Shape* shape;
    int frame, system;
  };
  std::vector<Placed> materials_;
  std::vector<std::vector<std::pair<std::string, int>>> frameNames_;  // per system
  std::vector<std::vector<NamedBody>> bodies_;                        // the same
  int nq_ = 0, nu_ = 0, blocks_ = 0;
};

}  // namespace dynamy
