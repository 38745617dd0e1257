#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/model/scene_description.hpp>

namespace dynamy {

void SceneDescription::describe(const Model& model) {
  for (std::size_t i = 0; i < model.systems().size(); ++i)
    take(model, *model.systems()[i], static_cast<int>(i), -1);
  for (std::size_t i = 0; i < model.contacts().size(); ++i)
    take(model, *model.contacts()[i], -1, static_cast<int>(i));
  for (const auto& f : model.forces()) take(model, *f, -1, -1);
  measure(model);
}

void SceneDescription::take(const Model& model, const Element& e, int system, int contact) {
  Description d;
  e.describe(d);
  for (Signal& s : d.signals) {
    NamedSignal named;
    named.name = e.name().empty() ? s.name : e.name() + "." + s.name;
    named.signal = std::move(s);
    named.system = system, named.contact = contact;
    const MemoryHandle memory = model.topology().memories().of(e);
    named.element = &e;
    named.memory0 = memory.first, named.memory = memory.size;
    signals_.push_back(std::move(named));
  }
  d.signals.clear(), d.signals.shrink_to_fit();  // one copy is enough for 10⁵ bodies
  elements_.push_back(std::move(d));
}

void SceneDescription::measure(const Model& model) {
  // Extent of all frames at the start plus the sizes of the shapes on them.
  const auto& systems = model.systems();
  Topology all(model.topology().systems());
  for (std::size_t i = 0; i < systems.size(); ++i)
    for (int f = 0; f < systems[i]->frames(); ++f) all.frame(all.system(static_cast<int>(i)), f);
  Kinematics k;
  k.resize(all);
  const State x = model.initialState();
  k.evaluate(all, x.t, {x.q.data(), x.q.size()}, {x.u.data(), x.u.size()});
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  double largest = 0.0;
  for (std::size_t i = 0; i < all.requestedFrames().size(); ++i) {
    low = low.cwiseMin(k.frame({static_cast<int>(i)}).r_OS_I);
    high = high.cwiseMax(k.frame({static_cast<int>(i)}).r_OS_I);
  }
  for (std::size_t i = 0; i < systems.size(); ++i)
    for (const PlacedShape& p : elements_[i].shapes) {
      const ShapeGeometry g = p.shape->geometry();
      if (g.type == ShapeType::halfSpace) continue;
      for (const double size : g.size) largest = std::max(largest, std::abs(size));
      for (const Vec3& point : g.points) largest = std::max(largest, point.norm());
    }
  if (!all.requestedFrames().empty()) largest = std::max(largest, (high - low).maxCoeff());
  length_ = largest > 0.0 && std::isfinite(largest) ? std::max(largest, 1e-6) : 1.0;
}

const NamedSignal* SceneDescription::signal(std::string_view name) const {
  for (const NamedSignal& s : signals_)
    if (s.name == name) return &s;
  return nullptr;
}

}  // namespace dynamy
