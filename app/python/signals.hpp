/// Signals and inputs of a model by their names, for Python.
#pragma once
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <map>
#include <memory>
#include <string>

namespace dynamy::python {

class NamedSignals {
 public:
  explicit NamedSignals(const Model& model) : model_(model) {}
  /// Value of a signal at the end of a step. Throws ModelError with the nearest known name.
  double value(const StepView& view, const std::string& name);
  /// The number that an <Input> of this name holds. Throws ModelError.
  MemoryHandle input(const std::string& name) const;
  /// True: the model has an <Input> of this name.
  bool hasInput(const std::string& name) const;

 private:
  const Model& model_;
  std::map<std::string, std::unique_ptr<SignalSampler>> samplers_;
};

}  // namespace dynamy::python
