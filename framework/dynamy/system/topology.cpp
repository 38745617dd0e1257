#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/system/body_carrier.hpp>
#include <dynamy/system/system_subset.hpp>
#include <dynamy/system/topology.hpp>

namespace dynamy {
namespace {

/// A frame "block.tip" that the known "block" does not have: where it is added; else "".
std::string frameToAdd(std::string_view name, const std::vector<std::string>& known) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || !nearest(name, known).empty()) return {};
  const std::string owner(name.substr(0, dot));
  if (std::find(known.begin(), known.end(), owner) == known.end()) return {};
  return "add <Frame name=\"" + std::string(name.substr(dot + 1)) + "\"/> inside of \"" + owner +
         '"';
}

[[noreturn]] void unknown(const Element& asking, const std::string& what, std::string_view name,
                          const std::vector<std::string>& known) {
  Diagnostic d;
  d.place = asking.place();
  d.element = asking.type().empty()   ? asking.name()
              : asking.name().empty() ? asking.type()
                                      : asking.type() + " name=\"" + asking.name() + "\"";
  d.text = "no " + what + " named \"" + std::string(name) + "\"";
  d.hint = what == "frame" ? frameToAdd(name, known) : std::string();
  if (d.hint.empty()) d.hint = unknownNameHint(name, known);
  throw ModelError(d);
}

[[noreturn]] void refuseCarried(const Element& asking, std::string_view name) {
  Diagnostic d;
  d.place = asking.place();
  d.element = asking.type() + " name=\"" + asking.name() + '"';
  d.text = "\"" + std::string(name) + "\" is carried by joints: it has no coordinates of its own";
  d.hint = "coordinates=\"absolute\" keeps them; OwnCoordinates serves both";
  throw ModelError(d);
}

}  // namespace

Topology::Topology(const std::vector<const PartialMechanicalSystem*>& systems, JointList joints)
    : systems_(systems), names_(std::move(joints)) {
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
    names_.add(*s, d);
    indexOf_.emplace_back();
    for (const PlacedShape& p : d.shapes)
      if (!p.shape->material().empty()) materials_.push_back({p.shape, p.frame, h.index});
  }
}

Topology topologyOf(const SystemSubset& some, const Topology& whole) {
  Topology out({});
  const OwnNumbers& own = *some.own();
  out.handles_ = own.handles(), out.whole_ = &whole;
  for (const int i : some.systems())
    out.systems_.push_back(whole.systems_[static_cast<std::size_t>(i)]);
  if (!out.handles_.empty()) {
    const SystemHandle& last = out.handles_.back();
    out.nq_ = last.q0 + last.nq, out.nu_ = last.u0 + last.nu;
    out.blocks_ = last.block0 + last.blocks;
  }
  for (const int i : some.frames()) {
    const auto& [system, id] = whole.requested_[static_cast<std::size_t>(i)];
    out.requested_.emplace_back(own.of(system), id);
  }
  for (const Connection& c : whole.connections()) {
    Connection part{c.element, {}, c.shapes};
    for (const int i : c.systems)
      if (const int k = own.of(i); k >= 0) part.systems.push_back(k);
    if (part.shapes || !part.systems.empty()) out.connections_.add(std::move(part));
  }
  return out;
}

SystemHandle Topology::system(std::string_view name, const Element& asking, int* body) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    // A carrier goes by the names of its bodies, not by its own.
    const BodyCarrier* carrier = systems_[i]->abilities().carrier;
    const int first = carrier ? 0 : -1, end = carrier ? carrier->carriedBodies() : 0;
    for (int k = first; k < end; ++k) {
      const std::string& its = carrier ? carrier->carriedBody(k).name() : systems_[i]->name();
      known.push_back(its);
      if (its != name) continue;
      if (carrier && body == nullptr) refuseCarried(asking, name);
      if (body != nullptr) *body = k;
      connections_.note(static_cast<int>(i));
      return handles_[i];
    }
  }
  unknown(asking, "system", name, known);
}

FrameHandle Topology::frame(std::string_view name, const Element& asking) {
  std::vector<std::string> known;
  const auto [system, id] = names_.find(name, known);
  if (system >= 0) return frame(handles_[static_cast<std::size_t>(system)], id);
  unknown(asking, "frame", name, known);
}

FrameHandle Topology::frame(const SystemHandle& system, int id) {
  connections_.note(system.index);
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

std::vector<const KnownJoint*> jointsBetween(const Topology& topology, FrameHandle A,
                                             FrameHandle B) {
  const auto bodyOf = [&](FrameHandle f) {
    const auto [system, id] = topology.requestedFrames()[static_cast<std::size_t>(f.index)];
    const NamedBody* carried = topology.names().body(system, id);
    return carried ? carried->name : topology.systems()[static_cast<std::size_t>(system)]->name();
  };
  return topology.names().joints().between(bodyOf(A), bodyOf(B));
}

void Topology::bindSignals(std::vector<ReadSignals::Source> sources) {
  for (std::size_t i = 0; i < sources.size(); ++i)
    connections_.add(*signals_.requests()[i].element, sources[i].systems);
  signals_.bind(std::move(sources));
}

std::vector<ShapeInstance> Topology::shapesWithMaterial() {
  std::vector<ShapeInstance> out;
  out.reserve(materials_.size());
  for (const Placed& p : materials_)
    out.push_back({p.shape, requested(p.system, p.frame), p.system});
  connections_.noteShapes();
  return out;
}

}  // namespace dynamy
