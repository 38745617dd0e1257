#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/topology.hpp>

namespace dynamy {
namespace {

[[noreturn]] void unknown(const Element& asking, const std::string& what, std::string_view name,
                          const std::vector<std::string>& known) {
  Diagnostic d;
  d.place = asking.place();
  d.element =
      asking.type().empty() ? asking.name() : asking.type() + " name=\"" + asking.name() + "\"";
  d.text = "no " + what + " named \"" + std::string(name) + "\"";
  d.hint = unknownNameHint(name, known);
  throw ModelError(d);
}

}  // namespace

Topology::Topology(const std::vector<const PartialMechanicalSystem*>& systems) : systems_(systems) {
  for (const PartialMechanicalSystem* s : systems) {
    const Blocks b = s->blocks();
    SystemHandle h;
    h.index = static_cast<int>(handles_.size());
    h.q0 = nq_, h.u0 = nu_, h.block0 = blocks_;
    h.nq = b.nq * b.capacity, h.nu = b.nu * b.capacity;
    h.blockNq = b.nq, h.blockNu = b.nu;
    h.blocks = b.nu > 0 ? b.capacity : 0;
    nq_ += h.nq, nu_ += h.nu, blocks_ += h.blocks;
    handles_.push_back(h);
    Description d;
    s->describe(d);
    frameNames_.push_back(std::move(d.frames));
    indexOf_.emplace_back();
    bodies_.push_back(std::move(d.bodies));
    for (const PlacedShape& p : d.shapes)
      if (!p.shape->material().empty()) materials_.push_back({p.shape, p.frame, h.index});
  }
}

SystemHandle Topology::system(std::string_view name, const Element& asking) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    if (systems_[i]->name() == name) {
      note(static_cast<int>(i));
      return handles_[i];
    }
    known.push_back(systems_[i]->name());
  }
  unknown(asking, "system", name, known);
}

FrameHandle Topology::frame(std::string_view name, const Element& asking) {
  // "body" is frame 0, "body.frame" a named frame. System names may contain dots, so whole names
  // are compared.
  std::vector<std::string> known;
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    const std::string& system = systems_[i]->name();
    const bool several = !bodies_[i].empty();
    if (!several && system == name && systems_[i]->frames() > 0) return frame(handles_[i], 0);
    if (!several && systems_[i]->frames() > 0) known.push_back(system);
    for (const NamedBody& b : bodies_[i]) {
      if (b.name == name) return frame(handles_[i], b.frame);
      known.push_back(b.name);
    }
    for (const auto& [label, id] : frameNames_[i]) {
      const std::string whole =
          (several ? body(static_cast<int>(i), id)->name : system) + "." + label;
      if (name == whole) return frame(handles_[i], id);
      known.push_back(whole);
    }
  }
  unknown(asking, "frame", name, known);
}

const NamedBody* Topology::body(int system, int id) const {
  const NamedBody* out = nullptr;
  for (const NamedBody& b : bodies_[static_cast<std::size_t>(system)])
    if (b.frame <= id) out = &b;
  return out;
}

FrameHandle Topology::frame(const SystemHandle& system, int id) {
  note(system.index);
  return requested(system.index, id);
}

FrameHandle Topology::requested(int system, int id) {
  std::vector<int>& known = indexOf_[static_cast<std::size_t>(system)];
  const auto at = static_cast<std::size_t>(id);
  if (at >= known.size()) known.resize(at + 1, -1);
  if (known[at] < 0) {
    known[at] = static_cast<int>(requested_.size());
    requested_.emplace_back(system, id);
  }
  return {known[at]};
}

void Topology::connecting(const Element* element) {
  connecting_ = element != nullptr;
  if (connecting_) connections_.push_back({element, {}, false});
}

void Topology::note(int system) const {
  if (!connecting_) return;
  std::vector<int>& known = connections_.back().systems;
  const auto at = std::lower_bound(known.begin(), known.end(), system);
  if (at == known.end() || *at != system) known.insert(at, system);
}

void Topology::leaveOut(std::vector<char> systems) {
  expects(systems.empty() || systems.size() == systems_.size(), "one flag for each system");
  leftOut_ = std::move(systems);
  without_.clear();
  const auto out = [&](int i) {
    return leftOut(i) || handles_[static_cast<std::size_t>(i)].nu == 0;
  };
  for (const Connection& c : connections_)
    if (leavesOut() && !c.systems.empty() && std::all_of(c.systems.begin(), c.systems.end(), out))
      without_.push_back(c.element);
  std::sort(without_.begin(), without_.end());
}

MemoryHandle Topology::memory(const Element& owner, const std::vector<double>& initial) {
  expects(memoryOf(owner).size == 0, "an element reserves its memory once");
  const MemoryHandle handle{static_cast<int>(memoryStart_.size()),
                            static_cast<int>(initial.size())};
  memories_.emplace_back(&owner, handle);
  memoryStart_.insert(memoryStart_.end(), initial.begin(), initial.end());
  return handle;
}

MemoryHandle Topology::memoryOf(const Element& owner) const {
  for (const auto& [element, handle] : memories_)
    if (element == &owner) return handle;
  return {};
}

std::vector<ShapeInstance> Topology::shapesWithMaterial() {
  std::vector<ShapeInstance> out;
  out.reserve(materials_.size());
  for (const Placed& p : materials_)
    out.push_back({p.shape, requested(p.system, p.frame), p.system});
  if (connecting_) connections_.back().shapes = true;
  return out;
}

}  // namespace dynamy
