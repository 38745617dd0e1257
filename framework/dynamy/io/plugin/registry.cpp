#include <algorithm>
#include <dynamy/io/plugin/registry.hpp>
#include <tuple>

namespace dynamy {

namespace {

/// True if `name` may be the name of a type or attribute in XML and in messages: letters, digits
/// and _.
bool isTypeName(const std::string& name) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && isLetter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
    return isLetter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

void expectNames(const RegisteredType& type) {
  const std::string who = "the library \"" + type.library + "\" ";
  constexpr const char* kHint = "a name is made of letters, digits and _ and begins with a letter";
  if (!isTypeName(type.name))
    throw ModelError(who + "registers a type \"" + type.name + "\", which no model can write",
                     kHint);
  const std::vector<Attribute>& all = type.attributes.list();
  for (auto a = all.begin(); a != all.end(); ++a) {
    const std::string text =
        who + "declares the attribute \"" + a->name + "\" of <" + type.name + '>';
    if (!isTypeName(a->name)) throw ModelError(text + ", which no model can write", kHint);
    if (std::any_of(all.begin(), a, [&](const Attribute& b) { return a->name == b.name; }))
      throw ModelError(text + " twice", "declareCommon of its base may have declared it");
  }
}

}  // namespace

void Registry::add(RegisteredType type) {
  expectNames(type);
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
