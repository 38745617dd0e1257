#include <algorithm>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy_elements/trees/tree_choice.hpp>

namespace dynamy {
namespace {

/// M of a body that carries this many times its own mass has lost so many of its digits that a
/// tolerance of 1e-10 is not reached: 16 − 5 digits remain.
constexpr double kLostDigits = 1e5;

/// Materials of the shapes of a system, each once.
std::vector<std::string> materialsOf(const PartialMechanicalSystem& system) {
  std::vector<std::string> out;
  Description d;
  system.describe(d);
  for (const PlacedShape& p : d.shapes)
    if (const std::string& name = p.shape->material(); !name.empty()) out.push_back(name);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// True: `signal`, which stands after the name of a joint, is one of its rows, which a coordinate
/// does not have. Signals of its friction and of its motion remain.
bool isOfRows(std::string_view signal) {
  if (signal == "*") return true;
  if (signal.starts_with("friction.")) return false;
  const std::string_view last = signal.substr(signal.rfind('.') + 1);
  for (const std::string_view start : {"Lambda", "lambda", "gamma", "status"})
    if (last.starts_with(start)) return true;
  return last == "g";
}

}  // namespace

TreeChoice::TreeChoice(Model& model) : model_(model) {
  read_ = model.record.signals;
  for (const CheckSettings& check : model.checks) read_.push_back(check.signal);
  if (!model.runsToTolerance() && !(model.schemeIsDefault() && model.simulation.reduce))
    reason_ = "steps have a fixed length, whose errors depend on the coordinates";
  else if (!model.simulation.keep.empty())
    reason_ = "keep names velocities of bodies";
  else if (std::find(read_.begin(), read_.end(), "*") != read_.end())
    reason_ = "all signals are recorded, forces of joints as well";
  for (const auto& system : model.systems()) {
    const auto i = static_cast<int>(own_.size());
    own_.push_back(materialsOf(*system));
    for (const std::string& material : own_.back()) {
      all_[material].push_back(i);
      if (system->blocks().nu > 0) moving_[material].push_back(i);
    }
  }
}

std::string TreeChoice::whyNot(const NonSmoothElement& joint) const {
  const std::string owner = joint.name() + ".";
  for (const std::string& signal : read_)
    if (!joint.name().empty() && signal.starts_with(owner) &&
        isOfRows(std::string_view(signal).substr(owner.size())))
      return "\"" + signal + "\" is read";
  return {};
}

bool TreeChoice::meets(int system, const std::map<std::string, std::vector<int>>& others) {
  for (const std::string& own : own_[static_cast<std::size_t>(system)])
    for (const auto& [other, systems] : others)
      if ((systems.size() > 1 || systems.front() != system) && model_.pairLaws().meet(own, other))
        return true;
  return false;
}

std::string TreeChoice::whyNotInFixedSteps(const std::vector<int>& bodies, int velocities) {
  if (velocities > kFewVelocities)
    return "in steps of a fixed length " + std::to_string(velocities) +
           " velocities of a mechanism cost more than its constraints";
  for (const int i : bodies)
    if (meets(i, all_))
      return "\"" + model_.systems()[static_cast<std::size_t>(i)]->name() +
             "\" meets others by its shapes, in steps of a fixed length";
  return {};
}

std::string TreeChoice::whyNot(const std::vector<int>& bodies, bool loose, int velocities) {
  if (!model_.runsToTolerance()) return whyNotInFixedSteps(bodies, velocities);
  if (!loose ||
      !model_.systems()[static_cast<std::size_t>(bodies.front())]->blocks().planeNormal.isZero(0.0))
    return {};
  for (const int i : bodies)
    if (meets(i, moving_))
      return "\"" + model_.systems()[static_cast<std::size_t>(i)]->name() +
             "\" of the loose mechanism meets other moving bodies";
  return {};
}

bool TreeChoice::losesDigits(double m, double carried) {
  return m > 0.0 && carried > kLostDigits * m;
}

}  // namespace dynamy
