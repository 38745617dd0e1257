#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/contact/contact_name.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>

namespace dynamy {

std::string elementText(const Element& e) {
  std::string text = e.type().empty() ? "" : "<" + e.type();
  if (!e.name().empty())
    text += text.empty() ? "\"" + e.name() + "\"" : " name=\"" + e.name() + "\"";
  if (!e.type().empty()) text += ">";
  const std::string place = e.place().format();
  if (!place.empty()) text += " (" + place + ")";
  return text;
}

Status contactStatus(const StepView& view, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  const int first = c.row0[at], dim = c.dim(contact);
  const std::vector<double>& gammaA = view.system.problem().gammaA;
  if (dim > kMostRows || gammaA.size() != static_cast<std::size_t>(c.rows()) ||
      view.Lambda.size() != c.rows())
    return Status::open;
  // Schemes that aim at the gap include contacts that are not reached yet.
  const bool away = c.position[static_cast<std::size_t>(first)] > view.system.gTol();
  if (c.law[at]->unilateral() && away && !(view.Lambda[first] > 0.0)) return Status::open;
  std::array<double, kMostRows> epsilon{}, argument{};
  c.law[at]->epsilon(dim, epsilon.data());
  for (int r = 0; r < dim; ++r) {
    const auto k = static_cast<std::size_t>(r), row = static_cast<std::size_t>(first + r);
    const double xi = view.gammaE[first + r] + epsilon[k] * gammaA[row];
    argument[k] = view.Lambda[first + r] - xi;
  }
  return c.law[at]->status(c.input(contact, view.report.dt, gammaA.data()), argument.data());
}

namespace {

/// Friction limit of a contact: |prox_C(Λ_N, 100 Λ_N, 0, …)| of the tangential rows [N s].
double frictionLimit(const StepView& view, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  const int dim = c.dim(contact);
  const double N = view.Lambda[c.row0[at]];
  if (dim < 2 || dim > kMostRows || !(N > 0.0) || c.law[at]->rowKind(0) != RowKind::normal)
    return 0.0;
  std::array<double, kMostRows> r{}, xi{}, Lambda{};
  r.fill(1.0);
  Lambda[0] = N, Lambda[1] = 100.0 * N;
  const double* gammaA = view.gammaE.data() + c.row0[at];
  c.law[at]->prox({dim, view.report.dt, gammaA, nullptr}, r.data(), xi.data(), Lambda.data());
  return dim > 2 ? std::hypot(Lambda[1], Lambda[2]) : std::abs(Lambda[1]);
}

/// True if the contact drills or rolls more than a thousand times faster than its point slides; the
/// scene's length converts the unit.
bool spins(const StepView& view, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const int first = c.row0[static_cast<std::size_t>(contact)];
  double spin = 0.0;
  for (int r = 3; r < c.dim(contact); ++r) spin = std::max(spin, std::abs(view.gammaE[first + r]));
  if (!(spin > 0.0)) return false;
  const double slide = std::hypot(view.gammaE[first + 1], view.gammaE[first + 2]);
  return slide < 1e-3 * spin * view.model.length();
}

}  // namespace

ContactRecord contactRecord(const StepView& view, StepImpacts& impacts, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  const int first = c.row0[at], dim = c.dim(contact);
  ContactRecord out;
  out.point = c.places.point[at], out.normal = c.places.normal[at];
  out.status = contactStatus(view, contact);
  out.impact = impacts(view, contact);
  out.spin = out.status == Status::slip && dim > 3 && spins(view, contact);
  const Vec3* const direction[] = {&c.places.normal[at], &c.places.t1[at], &c.places.t2[at]};
  for (int r = 0; r < dim && r < 3; ++r)
    out.force += view.Lambda[first + r] / view.report.dt * *direction[r];
  out.limit = frictionLimit(view, contact) / view.report.dt;
  return out;
}

std::string contactName(const Model& model, ContactKey key) {
  const auto element = static_cast<std::size_t>(key.value >> 40);
  if (element >= model.contacts().size()) return "contact";
  return dynamy::contactName(*model.contacts()[element], element, contactNumber(key));
}

std::string contactText(const Model& model, ContactKey key) {
  const auto element = static_cast<std::size_t>(key.value >> 40);
  const std::string place =
      element < model.contacts().size() ? model.contacts()[element]->place().format() : "";
  return contactName(model, key) + (place.empty() ? "" : " (" + place + ")");
}

std::string systemName(const Model& model, int system) {
  return elementText(*model.systems()[static_cast<std::size_t>(system)]);
}

}  // namespace dynamy
