/// FrameNames: finds frames by the names that model files use: "body" (its frame 0) or "body.name"
/// as named in describe(). A system of several bodies has the names of its bodies, not its own.
/// With them stand the joints between bodies, which are known by the names of these.
#pragma once
#include <dynamy/system/description.hpp>
#include <dynamy/system/joint_list.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

class FrameNames {
 public:
  explicit FrameNames(JointList joints) : joints_(std::move(joints)) {}
  const JointList& joints() const { return joints_; }
  /// Takes the names of the next system from its description.
  void add(const PartialMechanicalSystem& system, Description& description);
  /// (system index, frame id); (−1, −1) if no frame has this name. `known`: names of frames are
  /// added, all of them if the name is not found.
  std::pair<int, int> find(std::string_view name, std::vector<std::string>& known) const;
  /// The body that carries frame `id`, in a system of several bodies; null: the system is one body.
  const NamedBody* body(int system, int id) const;

 private:
  struct Names {
    const PartialMechanicalSystem* system;
    std::vector<std::pair<std::string, int>> frames;
    std::vector<NamedBody> bodies;
  };
  std::vector<Names> systems_;
  JointList joints_;
};

}  // namespace dynamy
