/// What an element throws while a run goes on, told with its name and place.
#pragma once
#include <dynamy/core/declared/element.hpp>
#include <stdexcept>

namespace dynamy {

/// `<Wall name="w"> (m.xml:7:5) failed: vector::at`.
class ElementFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Inside of a handler: throws an ElementFault that names `element`, or passes one on.
[[noreturn]] void throwNamed(const Element& element);

/// Calls `call()`; costs nothing unless it throws.
template <class Call>
void named(const Element& element, Call&& call) {
  try {
    call();
  } catch (...) {
    throwNamed(element);
  }
}

}  // namespace dynamy
