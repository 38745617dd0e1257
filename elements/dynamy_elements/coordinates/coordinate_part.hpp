/// CoordinatePart: what stands inside of <Coordinates>: a frame or a jump.
#pragma once
#include <dynamy/core/declared/element.hpp>

namespace dynamy {

class CoordinateFrame;
class CoordinateJump;

class CoordinatePart : public Element {
 public:
  static constexpr Kind kKind = Kind::part;
  using Element::Element;
  virtual CoordinateFrame* frame() { return nullptr; }
  virtual CoordinateJump* jump() { return nullptr; }
};

}  // namespace dynamy
