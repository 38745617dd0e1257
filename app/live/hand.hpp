/// Hand: the spring by which a person pulls a body of a running model.
///
///   F = c (r_OT − r_OP) − d v_P     at the point P that the hand holds, T: where it pulls to
///
/// What is held, and T, c and d, are numbers of State::memory, which a live run sets between two
/// steps (Simulation::input). They are part of the state: a repeated run that sets the same numbers
/// before the same steps has the same motion, bit for bit. The work of the hand is that of a force
/// without potential. Rejected: a spring of length zero as an element of the model, because nobody
/// knows before the run which point will be held.
#pragma once
#include <array>
#include <dynamy/simulation/model/model.hpp>
#include <utility>
#include <vector>

namespace dynamy {
class Registry;
}

namespace dynamy::app {

/// What a hand holds and how it pulls.
struct Grip {
  int frame = -1;              ///< among Hand::frames(); −1: nothing is held
  Vec3 point = Vec3::Zero();   ///< P, in axes of the frame [m]
  Vec3 target = Vec3::Zero();  ///< T [m]
  double stiffness = 0.0;      ///< c [N/m]
  double damping = 0.0;        ///< d [N s/m]
};

class Hand final : public ExternalForce {
 public:
  static constexpr int kNumbers = 9;
  static void declare(Attributes& a);
  explicit Hand(const Parameters& x) : ExternalForce(x) {}
  void connect(Topology& topology) override;
  void describe(Description& d) const override { d.timeless = true; }
  bool mayCouple() const override { return false; }
  void addTo(const Kinematics& k, ForceSink& sink) const override;

  /// Frames that can be held: (system, id). Those of systems without velocities are left out.
  const std::vector<std::pair<int, int>>& frames() const { return frames_; }
  /// The numbers in State::memory for this grip.
  static std::array<double, kNumbers> numbers(const Grip& grip);
  MemoryHandle memory() const { return memory_; }
  /// Mass [kg] that the point of the grip sets against a force: the harmonic mean over three
  /// directions of 1/(e·J M⁻¹Jᵀe), without those in which nothing moves; 0: it does not move at all.
  double massAt(const Model& model, const State& x, const Grip& grip) const;

 private:
  std::vector<std::pair<int, int>> frames_;
  std::vector<FrameHandle> handles_;
  MemoryHandle memory_;
};

/// The hand of a model that has one (addHands); null: it has none.
const Hand* handOf(const Model& model);

/// Every model that is loaded with this registry from now on has a hand.
void addHands(Registry& registry);

}  // namespace dynamy::app
