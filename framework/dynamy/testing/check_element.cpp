#include <dynamy/io/model_loader.hpp>
#include <dynamy/testing/check_element.hpp>
#include <ostream>
#include <utility>

namespace dynamy {

std::string CheckResult::message() const {
  std::string text;
  for (const std::string& fault : faults_) text += (text.empty() ? "" : "\n") + fault;
  return text;
}

void CheckResult::fault(std::string text) {
  // The same fault at several states is one fault.
  constexpr std::size_t kMost = 50;
  if (faults_.size() < kMost) faults_.push_back(std::move(text));
}

void CheckResult::add(const CheckResult& part) {
  for (const std::string& text : part.faults_) fault(text);
}

std::ostream& operator<<(std::ostream& out, const CheckResult& check) {
  return out << (check ? "no fault" : check.message());
}

CheckResult checkModel(Model& model, const CheckOptions& options) {
  CheckResult result;
  for (const auto& system : model.systems()) result.add(checkSystem(*system, options));
  // A model with faulty systems would only repeat their faults as those of its contacts.
  if (!result) return result;
  result.add(checkForces(model, options));
  result.add(checkContacts(model, options));
  return result;
}

CheckResult checkModel(const std::filesystem::path& file, Registry& registry, PluginLoader& plugins,
                       const CheckOptions& options) {
  CheckResult result;
  try {
    Model model = loadModel(file, registry, plugins);
    result.add(checkModel(model, options));
  } catch (const ModelError& error) {
    result.fault(format(error.diagnostics()));
  }
  return result;
}

}  // namespace dynamy
