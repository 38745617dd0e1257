#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/core/error.hpp>
#include <new>

namespace dynamy {

void throwNamed(const Element& element) {
  // An element that is built in C++ may have no type, or no name.
  const std::string type = element.type().empty() ? "element" : element.type();
  std::string text = '<' + type;
  if (!element.name().empty()) text += " name=\"" + element.name() + '"';
  text += '>';
  if (const std::string place = element.place().format(); !place.empty())
    text += " (" + place + ')';
  try {
    throw;
  } catch (const ElementFault&) {
    throw;
  } catch (const std::bad_alloc&) {  // no fault of the element
    throw;
  } catch (const ModelError& e) {
    // All contacts of shapes belong to one element, which stands in no file.
    if (element.type().empty() && element.name().empty()) throw;
    throw ElementFault(text + " failed: " + e.what());
  } catch (const std::exception& e) {
    throw ElementFault(text + " failed: " + e.what());
  } catch (...) {
    throw ElementFault(text + " threw something that is no std::exception");
  }
}

}  // namespace dynamy
