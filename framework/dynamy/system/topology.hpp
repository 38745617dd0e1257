/// Topology: the places of all systems, frames and memory in the flat arrays. Elements turn names
/// into handles with it, once, in connect().
#pragma once
#include <algorithm>
#include <dynamy/core/types.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/shape.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Place of one system in q, u and the mass blocks.
struct SystemHandle {
  int index = -1;
  int q0 = 0, nq = 0;          ///< slice of q, all blocks
  int u0 = 0, nu = 0;          ///< slice of u, all blocks
  int block0 = 0, blocks = 1;  ///< mass blocks
  int blockNq = 0, blockNu = 0;
};

/// One of the frames that elements of the model requested.
struct FrameHandle {
  int index = -1;
};

/// Numbers of one element in State::memory (a latch, a damage variable, the state of a controller).
struct MemoryHandle {
  int first = 0, size = 0;
};

/// What one force or contact element requested while it was connected.
struct Connection {
  const Element* element = nullptr;
  std::vector<int> systems;  ///< systems whose frames or coordinates it requested, ascending
  bool shapes = false;       ///< true: all shapes with a material, of all systems
};

/// A shape in the scene, and the frame that carries it.
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
  /// The body that carries frame `id`, in a system of several bodies; null: the system is one body.
  const NamedBody* body(int system, int id) const;
  /// All shapes of all systems that have a material; requests their frames.
  std::vector<ShapeInstance> shapesWithMaterial();

  /// Reserves numbers of `owner` in State::memory, with their values at the start. Called once, in
  /// connect(). The element reads them from Kinematics and changes them only in remember().
  MemoryHandle memory(const Element& owner, const std::vector<double>& initial);
  /// The numbers that `owner` reserved in State::memory; size 0 if none.
  MemoryHandle memoryOf(const Element& owner) const;
  const std::vector<double>& memoryStart() const { return memoryStart_; }

  /// Until the next call, what is requested is noted as a connection of `element`; null: not noted.
  void connecting(const Element* element);
  const std::vector<Connection>& connections() const { return connections_; }

  /// Leaves out, until the next call, all systems whose entry in `systems` is not 0 (empty: none).
  /// Their frames are absent, nothing acts on them, and elements between them report no contact.
  void leaveOut(std::vector<char> systems);
  bool leavesOut() const { return !leftOut_.empty(); }
  bool leftOut(int system) const {
    return leavesOut() && leftOut_[static_cast<std::size_t>(system)] != 0;
  }
  /// True: all systems that this element requested are left out.
  bool leftOut(const Element& element) const {
    return leavesOut() && std::binary_search(without_.begin(), without_.end(), &element);
  }

  int nq() const { return nq_; }
  int nu() const { return nu_; }
  int blocks() const { return blocks_; }
  const std::vector<const PartialMechanicalSystem*>& systems() const { return systems_; }
  /// Frames requested so far: (system index, frame id).
  const std::vector<std::pair<int, int>>& requestedFrames() const { return requested_; }

 private:
  FrameHandle requested(int system, int id);
  void note(int system) const;
  std::vector<const PartialMechanicalSystem*> systems_;
  std::vector<SystemHandle> handles_;
  std::vector<std::pair<int, int>> requested_;
  std::vector<std::vector<int>>
      indexOf_;  // per system and frame id: index in requested_, −1: not requested
  std::vector<std::pair<const Element*, MemoryHandle>> memories_;
  std::vector<double> memoryStart_;
  mutable std::vector<Connection> connections_;  // system() const notes the request
  bool connecting_ = false;
  std::vector<char> leftOut_;
  std::vector<const Element*> without_;  // elements between the systems left out
  struct Placed {
    const Shape* shape;
    int frame, system;
  };
  std::vector<Placed> materials_;
  std::vector<std::vector<std::pair<std::string, int>>> frameNames_;  // per system
  std::vector<std::vector<NamedBody>> bodies_;                        // per system
  int nq_ = 0, nu_ = 0, blocks_ = 0;
};

}  // namespace dynamy
