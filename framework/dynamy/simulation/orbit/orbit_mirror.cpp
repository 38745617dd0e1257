#include <algorithm>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/simulation/orbit/orbit_mirror.hpp>
#include <map>

namespace dynamy {
namespace {

/// Where the value of a signal stands in a state.
struct Position {
  bool velocity = false;
  Eigen::Index index = 0;
  std::string rate;  ///< of a coordinate: the signal of its velocity, if it has one
};

std::map<std::string, Position> positionsOf(const Model& model) {
  std::map<std::string, Position> out;
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const SystemHandle& s = model.topology().system(i);
    const std::string of = model.systems()[static_cast<std::size_t>(i)]->name() + ".";
    const Description& d = model.description(i);
    for (const auto& [name, index] : d.velocities) out[of + name] = {true, s.u0 + index, {}};
    for (const auto& [name, index] : d.coordinates) {
      Position p{false, s.q0 + index, {}};
      for (const auto& [rate, k] : d.velocities)
        if (s.nq == s.nu && k == index) p.rate = of + rate;
      out[of + name] = p;
    }
  }
  return out;
}

const Position& positionOf(const std::map<std::string, Position>& all, const std::string& name) {
  if (const auto found = all.find(name); found != all.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [other, position] : all) known.push_back(other);
  throw ModelError("no coordinate or velocity named \"" + name + '"', unknownNameHint(name, known));
}

}  // namespace

OrbitMirror::OrbitMirror(const Model& model, const std::vector<std::string>& of) {
  const std::map<std::string, Position> all = positionsOf(model);
  const auto add = [&](const std::string& to, const std::string& from, double sign) {
    const Position &a = positionOf(all, to), &b = positionOf(all, from);
    if (a.velocity != b.velocity)
      throw ModelError("a coordinate and a velocity, " + to + " and " + from +
                       ", cannot be mirror images of each other");
    of_.push_back({to, a.velocity, a.index, b.index, from, sign});
    if (!a.rate.empty() && !b.rate.empty())
      of_.push_back({a.rate, true, positionOf(all, a.rate).index, positionOf(all, b.rate).index,
                     b.rate, sign});
  };
  for (const std::string& item : of) {
    const std::size_t at = item.find('=');
    if (at == std::string::npos) {
      add(item, item, -1.0);
      continue;
    }
    const bool minus = at + 1 < item.size() && item[at + 1] == '-';
    const std::string a = item.substr(0, at), b = item.substr(at + (minus ? 2 : 1));
    add(a, b, minus ? -1.0 : 1.0);
    if (a != b) add(b, a, minus ? -1.0 : 1.0);
  }
  for (std::size_t i = 0; i < of_.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (of_[i].name == of_[k].name)
        throw ModelError("the mirror names " + of_[i].name + " twice",
                         "the velocity of a coordinate belongs to it");
}

State OrbitMirror::operator()(const State& x) const {
  State out = x;
  for (const Part& p : of_)
    (p.velocity ? out.u : out.q)[p.to] = p.sign * (p.velocity ? x.u : x.q)[p.from];
  return out;
}

OrbitSection OrbitMirror::operator()(const OrbitSection& section) const {
  OrbitSection out = section;
  const auto p = std::find_if(of_.begin(), of_.end(),
                              [&](const Part& part) { return part.name == section.signal; });
  if (p == of_.end()) return out;
  out.signal = p->fromName, out.value = p->sign * section.value;
  out.falling = section.falling != (p->sign < 0.0);
  return out;
}

}  // namespace dynamy
