#include <dynamy/io/model_loader.hpp>
#include <dynamy/testing/check_element.hpp>
#include <ostream>
#include <utility>

namespace dynamy {

std::string Verdict::message() const {
  std::string text;
  for (const std::string& fault : faults_) text += (text.empty() ? "" : "\n") + fault;
  return text;
}

void Verdict::fault(std::string text) {
  // The same fault at several states is one fault.
  constexpr std::size_t kMost = 50;
  if (faults_.size() < kMost) faults_.push_back(std::move(text));
}

void Verdict::add(const Verdict& part) {
  for (const std::string& text : part.faults_) fault(text);
}

std::ostream& operator<<(std::ostream& out, const Verdict& check) {
  return out << (check ? "no fault" : check.message());
}

Verdict checkModel(Model& model, const CheckOptions& options) {
  Verdict result;
  for (const auto& system : model.systems()) result.add(checkSystem(*system, options));
  // A model with faulty systems would only repeat their faults as those of its contacts.
  if (!result) return result;
  result.add(checkForces(model, options));
  result.add(checkContacts(model, options));
  return result;
}

Verdict checkModel(const std::filesystem::path& file, Registry& registry, PluginLoader& plugins,
                   const CheckOptions& options) {
  Verdict result;
  try {
    Model model = loadModel(file, registry, plugins);
    result.add(checkModel(model, options));
  } catch (const ModelError& error) {
    result.fault(format(error.diagnostics()));
  }
  return result;
}

}  // namespace dynamy
