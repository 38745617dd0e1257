#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>

#include "signals.hpp"

namespace dynamy::python {

double NamedSignals::value(const StepView& view, const std::string& name) {
  std::unique_ptr<SignalSampler>& sampler = samplers_[name];
  if (!sampler) {
    const NamedSignal* signal = model_.signal(name);
    if (signal == nullptr) signal = model_.signal(name + ".out");
    if (signal == nullptr) {
      std::vector<std::string> known;
      for (const NamedSignal& s : model_.signals()) known.push_back(s.name);
      throw ModelError("no signal named \"" + name + '"', unknownNameHint(name, known));
    }
    sampler = std::make_unique<SignalSampler>(model_, std::vector<const NamedSignal*>{signal});
  }
  return sampler->sampleOne(view, 1.0, 0);
}

MemoryHandle NamedSignals::input(const std::string& name) const {
  std::vector<std::string> known;
  for (const auto& f : model_.forces()) {
    if (f->type() != "Input") continue;
    if (f->name() == name) return model_.topology().memories().of(*f);
    known.push_back(f->name());
  }
  throw ModelError("no input named \"" + name + '"',
                   known.empty() ? "add <Input name=\"" + name + "\"/> to the forces"
                                 : unknownNameHint(name, known));
}

bool NamedSignals::hasInput(const std::string& name) const {
  const auto& forces = model_.forces();
  return std::any_of(forces.begin(), forces.end(),
                     [&](const auto& f) { return f->type() == "Input" && f->name() == name; });
}

}  // namespace dynamy::python
