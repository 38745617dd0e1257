#include <algorithm>
#include <dynamy/io/registry.hpp>
#include <tuple>

namespace dynamy {

void Registry::add(RegisteredType type) {
  if (const RegisteredType* first = find(type.name)) {
    if (first->library == type.library)
      throw ModelError("the library \"" + type.library + "\" registers the type \"" + type.name +
                       "\" twice");
    throw ModelError("the type \"" + type.name + "\" of the library \"" + type.library +
                         "\" exists already in the library \"" + first->library + '"',
                     "rename one of them, or load one of the libraries only");
  }
  std::string name = type.name;
  types_.emplace(std::move(name), std::move(type));
}

const RegisteredType* Registry::find(std::string_view name) const {
  const auto it = types_.find(name);
  return it == types_.end() ? nullptr : &it->second;
}

std::vector<const RegisteredType*> Registry::types() const {
  std::vector<const RegisteredType*> out;
  for (const auto& entry : types_) out.push_back(&entry.second);
  std::stable_sort(out.begin(), out.end(), [](const RegisteredType* a, const RegisteredType* b) {
    return std::tie(a->kind, a->name) < std::tie(b->kind, b->name);
  });
  return out;
}

}  // namespace dynamy
