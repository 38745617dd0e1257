/// SceneDescription: what the elements of a built model report of themselves, and the length of the
/// scene that follows from it.
#pragma once
#include <dynamy/system/description.hpp>
#include <string>
#include <vector>

namespace dynamy {

class Element;
class Model;

/// A signal with its full name and the element it belongs to.
struct NamedSignal {
  std::string name;  ///< "ball.z"
  Signal signal;
  int system = -1;   ///< index of the system, −1: none
  int contact = -1;  ///< index of the contact element, −1: none
  int memory0 = 0, memory = 0;
  const Element* element = nullptr;
};

class SceneDescription {
 public:
  /// Asks all elements of a model whose topology is complete. Called once.
  void describe(const Model& model);
  /// Of the systems, then of the contact elements, then of the forces, without their signals.
  const std::vector<Description>& elements() const { return elements_; }
  const std::vector<NamedSignal>& signals() const { return signals_; }
  /// The signal of this full name; null: there is none.
  const NamedSignal* signal(std::string_view name) const;
  /// Extent of initial frame positions and shapes [m], at least 1e-6; 1 if there is nothing to
  /// measure.
  double length() const { return length_; }

 private:
  void take(const Model& model, const Element& e, int system, int contact);
  void measure(const Model& model);
  std::vector<Description> elements_;
  std::vector<NamedSignal> signals_;
  double length_ = 1.0;
};

}  // namespace dynamy
