#include <algorithm>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
#include <dynamy/simulation/orbit/orbit_mirror.hpp>

namespace dynamy {
namespace {

const NamedNumber& numberNamed(const std::vector<NamedNumber>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NamedNumber& n) { return n.name == name; });
  if (found != all.end()) return *found;
  std::vector<std::string> known;
  for (const NamedNumber& n : all) known.push_back(n.name);
  throw ModelError("no coordinate or velocity named \"" + name + '"', unknownNameHint(name, known));
}

}  // namespace

OrbitMirror::OrbitMirror(const Model& model, const std::vector<std::string>& of) {
  const std::vector<NamedNumber> all = numbersOfState(model);
  const auto add = [&](const std::string& to, const std::string& from, double sign) {
    const NamedNumber &a = numberNamed(all, to), &b = numberNamed(all, from);
    if (a.velocity != b.velocity)
      throw ModelError("a coordinate and a velocity, " + to + " and " + from +
                       ", cannot be mirror images of each other");
    of_.push_back({to, a.velocity, a.index, b.index, from, sign});
    if (!a.rate.empty() && !b.rate.empty())
      of_.push_back({a.rate, true, numberNamed(all, a.rate).index, numberNamed(all, b.rate).index,
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
