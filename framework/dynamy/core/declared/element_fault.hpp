/// Exceptions that elements throw during a run, reported with the name and place of the element.
#pragma once
#include <dynamy/core/declared/element.hpp>
#include <stdexcept>

namespace dynamy {

/// `<Wall name="w"> (m.xml:7:5) failed: vector::at`.
class ElementFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// To be called inside a handler: throws an ElementFault that names `element`. If the exception is
/// an ElementFault already, it is passed on.
[[noreturn]] void throwNamed(const Element& element);

/// Calls `call()`; an exception is rethrown by throwNamed(). Costs nothing unless `call` throws.
template <class Call>
void named(const Element& element, Call&& call) {
  try {
    call();
  } catch (...) {
    throwNamed(element);
  }
}

}  // namespace dynamy
