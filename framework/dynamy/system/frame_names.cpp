#include <dynamy/system/frame_names.hpp>

namespace dynamy {

void FrameNames::add(const PartialMechanicalSystem& system, Description& description) {
  systems_.push_back({&system, std::move(description.frames), std::move(description.bodies)});
}

std::pair<int, int> FrameNames::find(std::string_view name, std::vector<std::string>& known) const {
  // System names may contain dots, so whole names are compared.
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    const Names& names = systems_[i];
    const int index = static_cast<int>(i);
    const std::string& system = names.system->name();
    const bool several = !names.bodies.empty();
    if (!several && system == name && names.system->frames() > 0) return {index, 0};
    if (!several && names.system->frames() > 0) known.push_back(system);
    for (const NamedBody& b : names.bodies) {
      if (b.name == name) return {index, b.frame};
      known.push_back(b.name);
    }
    for (const auto& [label, id] : names.frames) {
      const std::string whole = (several ? body(index, id)->name : system) + "." + label;
      if (name == whole) return {index, id};
      known.push_back(whole);
    }
  }
  return {-1, -1};
}

const NamedBody* FrameNames::body(int system, int id) const {
  const NamedBody* out = nullptr;
  for (const NamedBody& b : systems_[static_cast<std::size_t>(system)].bodies)
    if (b.frame <= id) out = &b;
  return out;
}

}  // namespace dynamy
