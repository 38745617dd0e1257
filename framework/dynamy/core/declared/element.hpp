/// Element: everything made from XML or code. Elements describe; numbers live in flat arrays of the
/// workspace.
#pragma once
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/core/error.hpp>
#include <string>

namespace dynamy {

class Parameters;
class Description;
struct MirrorPlane;

/// Base of all elements. Elements are const during a run; what must change (latch, damage) is
/// `memory` in State.
class Element {
 public:
  virtual ~Element() = default;
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;

  /// Names coordinates, signals, shapes on frames and the memory the element needs. Called once in
  /// build().
  virtual void describe(Description&) const {}

  /// True: the element, and a system with its state at the start, is its own mirror image at this
  /// plane, whatever the rest of the model does in the plane. A model of such elements alone is
  /// computed in the plane (theory 39.10). For shapes and laws: in axes of the shape, or of any
  /// contact whose normal lies in the plane. False (default): the element cannot tell.
  virtual bool isMirrored(const MirrorPlane&) const { return false; }

  const std::string& name() const { return name_; }
  const std::string& type() const { return type_; }  ///< registered type name, e.g. "RigidBody"
  const Place& place() const { return place_; }      ///< where in the model file it stands

 protected:
  Element() = default;
  explicit Element(const Parameters& x);

 private:
  std::string name_, type_;
  Place place_;
};

}  // namespace dynamy
