#include <array>
#include <cmath>
#include <dynamy/simulation/contact_facts.hpp>

namespace dynamy {
namespace {

constexpr int kMaxRows = 8;

std::string elementText(const Element& e) {
  std::string text = e.type().empty() ? "" : "<" + e.type();
  if (!e.name().empty())
    text += text.empty() ? "\"" + e.name() + "\"" : " name=\"" + e.name() + "\"";
  if (!e.type().empty()) text += ">";
  const std::string place = e.place().format();
  if (!place.empty()) text += " (" + place + ")";
  return text;
}

}  // namespace

Status contactStatus(const StepView& view, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  const int first = c.row0[at], dim = c.dim(contact);
  const std::vector<double>& gammaA = view.system.problem().gammaA;
  if (dim > kMaxRows || gammaA.size() != static_cast<std::size_t>(c.rows()) ||
      view.Lambda.size() != c.rows())
    return Status::open;
  std::array<double, kMaxRows> epsilon{}, argument{};
  c.law[at]->epsilon(dim, epsilon.data());
  for (int r = 0; r < dim; ++r) {
    const auto k = static_cast<std::size_t>(r), row = static_cast<std::size_t>(first + r);
    const double xi = view.gammaE[first + r] + epsilon[k] * gammaA[row];
    argument[k] = view.Lambda[first + r] - xi;
  }
  return c.law[at]->status({dim, view.report.dt, gammaA.data() + first, nullptr}, argument.data());
}

bool isImpact(const StepView& view, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  if (c.law[at]->rowKind(0) != RowKind::normal) return false;
  const auto row = static_cast<std::size_t>(c.row0[at]);
  const InclusionProblem& p = view.system.problem();
  if (p.gammaA.size() <= row || view.Lambda.size() != c.rows()) return false;
  const double smooth = std::abs(p.gammaFree[row] - p.gammaA[row]);
  const double floor = 1e-9 * view.model.length();
  return -p.gammaA[row] > std::max(smooth, floor) && view.Lambda[c.row0[at]] > 0.0;
}

std::string contactName(const Model& model, ContactKey key) {
  const auto element = static_cast<std::size_t>(key.value >> 40);
  const std::uint64_t id = key.value & ((std::uint64_t{1} << 40) - 1);
  if (element >= model.contacts().size()) return "contact";
  const NonSmoothElement& e = *model.contacts()[element];
  std::string name = e.name();
  if (const std::string own = e.contactName(id); !own.empty())
    return name.empty() ? own : name + "." + own;
  if (name.empty())
    name = (e.type().empty() ? "contact" : e.type()) + "#" + std::to_string(element);
  return id == 0 ? name : name + "/" + std::to_string(id);
}

std::string systemName(const Model& model, int system) {
  return elementText(*model.systems()[static_cast<std::size_t>(system)]);
}

}  // namespace dynamy
