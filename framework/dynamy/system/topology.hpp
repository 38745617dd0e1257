/// Topology: the places of all systems and frames in the flat arrays. Elements turn names into
/// handles with it, once, in connect(). Names of frames, memory of elements, connections and systems
/// left out are classes of their own, which it holds.
#pragma once
#include <dynamy/core/types.hpp>
#include <dynamy/system/connections.hpp>
#include <dynamy/system/element_memory.hpp>
#include <dynamy/system/frame_names.hpp>
#include <dynamy/system/read_signals.hpp>
#include <dynamy/system/shape.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

class SystemSubset;

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

/// A shape in the scene, and the frame that carries it.
struct ShapeInstance {
  const Shape* shape = nullptr;
  FrameHandle frame;
  int system = -1;  ///< index of the system
};

class Topology {
 public:
  /// Systems in order of the model, and the joints between them; computes all offsets.
  explicit Topology(const std::vector<const PartialMechanicalSystem*>& systems,
                    JointList joints = {});

  /// Handle of the system called `name`. Throws ModelError with the nearest known name.
  /// `body` given: bodies that a system carries are known, too; then it is the body's index there, else −1.
  SystemHandle system(std::string_view name, const Element& asking, int* body = nullptr) const;
  const SystemHandle& system(int index) const { return handles_[static_cast<std::size_t>(index)]; }
  /// Frame by name: "body" (its frame 0) or "body.name" as named in describe(). From then on it is
  /// evaluated in every step.
  FrameHandle frame(std::string_view name, const Element& asking);
  FrameHandle frame(const SystemHandle& system, int id);
  const FrameNames& names() const { return names_; }
  /// All shapes of all systems that have a material; requests their frames.
  std::vector<ShapeInstance> shapesWithMaterial();

  /// Reserves numbers of `owner` in State::memory, with their values at the start. Called once, in
  /// connect(). The element reads them from Kinematics and changes them only in remember().
  MemoryHandle memory(const Element& owner, const std::vector<double>& initial) {
    return memories_.reserve(owner, initial);
  }
  const ElementMemory& memories() const { return memories_; }

  /// Requests the signal of this full name for an element, e.g. of a formula: its value is then
  /// Kinematics::signal(). Called in connect(); Model::build() reports a name that no signal has at
  /// `place`.
  SignalHandle signal(std::string_view name, const Place& place, const Element& asking) {
    return signals_.request(name, place, asking);
  }
  const ReadSignals& signals() const { return whole_ ? whole_->signals_ : signals_; }
  /// Binds all requested signals, in the order of the requests; called by Model::build(). An
  /// element is connected with the systems behind the signals that it reads.
  void bindSignals(std::vector<ReadSignals::Source> sources);

  /// Where the requests of the element that is being connected are noted.
  Connections& noting() const { return connections_; }
  const std::vector<Connection>& connections() const { return connections_.list(); }

  int nq() const { return nq_; }
  int nu() const { return nu_; }
  int blocks() const { return blocks_; }
  const std::vector<const PartialMechanicalSystem*>& systems() const { return systems_; }
  /// Frames requested so far: (system index, frame id).
  const std::vector<std::pair<int, int>>& requestedFrames() const { return requested_; }
  friend Topology topologyOf(const SystemSubset& some, const Topology& whole);

 private:
  FrameHandle requested(int system, int id);
  std::vector<const PartialMechanicalSystem*> systems_;
  std::vector<SystemHandle> handles_;
  std::vector<std::pair<int, int>> requested_;
  std::vector<std::vector<int>>
      indexOf_;  // per system and frame id: index in requested_, −1: not requested
  FrameNames names_;
  ElementMemory memories_;
  ReadSignals signals_;
  mutable Connections connections_;  // system() const notes the request
  struct Placed {
    const Shape* shape;
    int frame, system;
  };
  std::vector<Placed> materials_;
  const Topology* whole_ = nullptr;
  int nq_ = 0, nu_ = 0, blocks_ = 0;
};

/// Joints between the bodies of two frames; one that cannot say what it leaves free is missing.
std::vector<const KnownJoint*> jointsBetween(const Topology& topology, FrameHandle A,
                                             FrameHandle B);

/// The systems of a subset that omits others alone, numbered anew; `whole` is borrowed. Nothing more
/// can be requested from it.
Topology topologyOf(const SystemSubset& some, const Topology& whole);

}  // namespace dynamy
