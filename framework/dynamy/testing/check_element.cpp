#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/testing/random_motion.hpp>
#include <ostream>
#include <utility>

namespace dynamy {
namespace {

/// Tolerance of a remembered number: angles that are counted over turns are rounded at each call.
constexpr double kSameMemory = 1e-12;

}  // namespace

std::string Verdict::message() const {
  std::string text;
  for (const std::string& fault : faults_) text += (text.empty() ? "" : "\n") + fault;
  return text;
}

void Verdict::fault(std::string text) {
  // A fault at every state would fill pages.
  constexpr std::size_t kMost = 50;
  if (faults_.size() < kMost) faults_.push_back(std::move(text));
}

void Verdict::leftOut(std::string text) {
  if (std::find(uncompared_.begin(), uncompared_.end(), text) == uncompared_.end())
    uncompared_.push_back(std::move(text));
}

void Verdict::add(const Verdict& part) {
  for (const std::string& text : part.faults_) fault(text);
  for (const std::string& text : part.uncompared_) leftOut(text);
}

std::ostream& operator<<(std::ostream& out, const Verdict& check) {
  return out << (check ? "no fault" : check.message());
}

namespace {

/// Memory is changed at the end of steps and wherever any element switches. A second call of
/// remember() at the same state must therefore leave it unchanged except for rounding.
template <class E>
void checkMemory(Model& model, const E& element, testing::RandomMotion& motion, Verdict& out) {
  const MemoryHandle m = model.topology().memories().of(element);
  State x = motion.x();
  if (m.size == 0) return;
  const auto remember = [&] {
    Eigen::VectorXd memory = x.memory;
    element.remember(motion.kinematics(x), slice(memory, m.first, m.size));
    x.memory = memory;
    return Eigen::VectorXd(memory.segment(m.first, m.size));
  };
  const Eigen::VectorXd once = remember(), twice = remember();
  for (int i = 0; i < m.size; ++i)
    if (!(std::abs(twice[i] - once[i]) <= kSameMemory * (1.0 + std::abs(once[i]))))
      out.fault(fmt::format("{}: remember() gives memory[{}] = {:.9g}, called again there {:.9g}",
                            testing::labelOf(element, "element"), i, once[i], twice[i]));
}

Verdict checkMemories(Model& model, const CheckOptions& options) {
  Verdict result;
  testing::RandomMotion motion(model, options);
  for (int i = 0; i < options.states && result; ++i) {
    motion.sample(i);
    for (const auto& e : model.forces()) checkMemory(model, *e, motion, result);
    for (const auto& e : model.contacts()) checkMemory(model, *e, motion, result);
  }
  return result;
}

}  // namespace

Verdict checkModel(Model& model, const CheckOptions& options) {
  Verdict result;
  for (const auto& system : model.systems()) result.add(checkSystem(*system, options));
  // A model with faulty systems would only repeat their faults as those of its contacts.
  if (!result) return result;
  result.add(checkForces(model, options));
  result.add(checkContacts(model, options));
  result.add(checkMemories(model, options));
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
