#include <dynamy/contact/contact_name.hpp>

namespace dynamy {

std::string contactName(const NonSmoothElement& e, std::size_t number, std::uint64_t id) {
  std::string name = e.name();
  if (const std::string own = e.contactName(id); !own.empty())
    return name.empty() ? own : name + "." + own;
  if (name.empty()) name = (e.type().empty() ? "contact" : e.type()) + "#" + std::to_string(number);
  return id == 0 ? name : name + "/" + std::to_string(id);
}

}  // namespace dynamy
