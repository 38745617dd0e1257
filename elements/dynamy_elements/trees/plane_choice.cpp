#include <algorithm>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy_elements/bodies/flat_body.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <dynamy_elements/trees/plane_choice.hpp>
#include <optional>

namespace dynamy {
namespace {

bool isFree(const PartialMechanicalSystem& system) {
  const RigidSystem* rigid = system.abilities().rigid;
  return rigid != nullptr && !rigid->rigidPart().fixed && system.blocks().planeNormal.isZero(0.0);
}

/// Signals of bodies alone are the same in the plane; contacts have other places there.
bool readsBodiesOnly(const Model& model) {
  std::vector<std::string> read = model.record.signals;
  for (const CheckSettings& check : model.checks) read.push_back(check.signal);
  return std::all_of(read.begin(), read.end(), [&](const std::string& signal) {
    return std::any_of(model.systems().begin(), model.systems().end(), [&](const auto& system) {
      return !system->name().empty() && signal.starts_with(system->name() + ".");
    });
  });
}

/// The first element that may lead the bodies out of a plane in which they start; null: none does.
const Element* leader(const Model& model, const MirrorPlane& plane) {
  const Element* asked = model.systems().front().get();
  try {
    for (const auto& contact : model.contacts()) {
      asked = contact.get();
      if (!contact->keepsPlane(plane)) return asked;
    }
    return model.notMirrored(plane);
  } catch (const ModelError&) {
    return asked;  // connect() reports it with all other faults
  }
}

std::string tagOf(const Element& e) {
  return "<" + e.type() + (e.name().empty() ? "" : " name=\"" + e.name() + "\"") + ">";
}

/// The plane of the motion, through the first body; none: the bodies move in space.
std::optional<Plane> planeOf(Model& model, int first, Topology& topology) {
  const FrameHandle frame = topology.frame(topology.system(first), 0);
  const StartKinematics start(topology, {frame});
  const Vec3 r = start.frame(frame).r_OS_I;
  std::string why;
  for (const char* word : {"xz", "xy", "yz"}) {
    const Plane plane(word);
    const MirrorPlane mirror{plane.n, plane.n.dot(r), &topology};
    if (!std::all_of(model.systems().begin(), model.systems().end(),
                     [&](const auto& system) { return system->isMirrored(mirror); }))
      continue;
    const Element* leads = leader(model, mirror);
    if (leads == nullptr) return plane;
    why = "bodies that start in the plane " + std::string(word) +
          " are computed in space: " + tagOf(*leads) + " may lead them out of it";
  }
  if (!why.empty()) model.composed.notes.push_back(why);
  return std::nullopt;
}

}  // namespace

void flattenBodies(Model& model) {
  if (!model.simulation.reduce || !model.simulation.keep.empty() || !model.observers().empty() ||
      !readsBodiesOnly(model))
    return;
  std::vector<int> bodies;
  std::vector<const PartialMechanicalSystem*> systems;
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    systems.push_back(model.systems()[i].get());
    if (isFree(*systems.back())) bodies.push_back(static_cast<int>(i));
  }
  if (bodies.empty()) return;
  Topology topology(systems, model.composed.jointList);
  const std::optional<Plane> plane = planeOf(model, bodies.front(), topology);
  if (!plane) return;
  for (const int i : bodies)
    model.replaceSystem(i, [&](std::unique_ptr<PartialMechanicalSystem> body) {
      Parameters x;
      x.type = body->type(), x.name = body->name(), x.place = body->place();
      return std::make_unique<FlatBody>(x, std::move(body), *plane);
    });
  model.composed.flat = static_cast<int>(bodies.size());
  model.composed.plane = {plane->first, plane->second};
}

}  // namespace dynamy
