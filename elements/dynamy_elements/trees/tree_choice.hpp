/// TreeChoice: which joints become coordinates where a model leaves it to the program, and why the
/// others do not (theory 39.8). It decides by the structure of the model and its method:
///
///   * steps of a fixed length by a scheme that the model names: none but joints with rotors and what
///     hangs together with them, since what a scheme does to joints is part of what it is asked for
///   * other steps of a fixed length: where nobody reads q and u (SimulationSettings::reduce),
///     mechanisms of at most kFewVelocities, whose bodies have no contacts by their shapes; of more
///     velocities the equations of motion cost more than constraints
///   * a joint whose forces are recorded or checked stays a constraint, which has forces
///   * a loose mechanism in space whose bodies meet other moving bodies by their shapes stays one of
///     bodies: its impacts are dense, and steps in time hold constraints better than coordinates
///   * bodies that carry more than kLostDigits times their own mass keep coordinates of their own
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/system/tree_part.hpp>
#include <map>
#include <string>
#include <vector>

namespace dynamy {

class TreeChoice {
 public:
  explicit TreeChoice(Model& model);
  /// Why no joint becomes a coordinate unless it has a rotor; empty: they may.
  const std::string& reason() const { return reason_; }
  /// Why this joint stays a constraint; empty: it may become a coordinate.
  std::string whyNot(const NonSmoothElement& joint) const;
  /// Why the joints between these bodies stay constraints. `loose`: no joint connects them with
  /// something at rest. `velocities`: of the mechanism with its joints as coordinates.
  std::string whyNot(const std::vector<int>& bodies, bool loose, int velocities);
  /// The same for a body of mass m [kg] that carries others of the mass `carried` in all.
  static bool losesDigits(double m, double carried);

 private:
  std::string whyNotInFixedSteps(const std::vector<int>& bodies, int velocities);
  bool meets(int system, const std::map<std::string, std::vector<int>>& others);
  static constexpr int kFewVelocities = 6;
  Model& model_;
  std::string reason_;
  std::vector<std::string> read_;              // names of signals that are recorded or checked
  std::vector<std::vector<std::string>> own_;  // materials of the shapes of each system
  std::map<std::string, std::vector<int>> all_, moving_;  // systems with shapes of a material
};

}  // namespace dynamy
