#include "run/model_notes.hpp"

#include <fmt/format.h>

#include <dynamy/law/pair_laws.hpp>

namespace dynamy::app {
namespace {

std::string lineOf(const Place& place) { return Place(place.file, place.line).format(); }

/// A newcomer may name bodies in the place of their materials.
std::string whyIdle(const Model& model, const MaterialRule& rule) {
  for (const std::string& name : model.pairLaws().namesOf(rule))
    for (const auto& system : model.systems())
      if (system->name() == name)
        return '"' + name + "\" is a system; between=\"…\" names the materials of shapes";
  return "no shapes that can touch ask for it";
}

/// Shapes without a material take part in no contact, and bodies fall through each other.
std::string idleRules(const Model& model) {
  std::string out;
  for (const MaterialRule* rule : model.pairLaws().idle())
    out += fmt::format(" note: <{}{}> ({}) never acts: {}\n", rule->type(),
                       rule->name().empty() ? "" : " name=\"" + rule->name() + '"',
                       lineOf(rule->place()), whyIdle(model, *rule));
  return out;
}

/// A part that is included may bring a field of its own.
std::string severalGravities(const Model& model) {
  std::string places;
  int count = 0;
  for (const auto& force : model.forces()) {
    if (force->type() != "Gravity") continue;
    ++count;
    if (const std::string place = lineOf(force->place()); !place.empty())
      places += (places.empty() ? "" : ", ") + place;
  }
  if (count < 2) return {};
  return fmt::format(" note: {} <Gravity>{} act together: their accelerations add up\n", count,
                     places.empty() ? "" : " (" + places + ")");
}

std::string longStep(const Model& model) {
  const SimulationSettings& s = model.simulation;
  if (model.scheme().choosesSteps() || !(s.step > s.until)) return {};
  return fmt::format(
      " note: the step, {:g} s, is longer than the run: one step of {:g} s is taken\n", s.step,
      s.until);
}

}  // namespace

std::string modelNotes(const Model& model) {
  return idleRules(model) + severalGravities(model) + longStep(model);
}

}  // namespace dynamy::app
