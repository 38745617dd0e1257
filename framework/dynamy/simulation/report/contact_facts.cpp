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

namespace {

/// Contacts with percussions and velocities, of a step or at an instant of it.
struct Acting {
  const ContactSet& c;
  const double *Lambda, *gamma, *gammaA;  ///< of its rows; γ after and before percussions
  double dt, gTol;
};

Status statusOf(const Acting& a, int contact) {
  const ContactSet& c = a.c;
  const auto at = static_cast<std::size_t>(contact);
  const int first = c.row0[at], dim = c.dim(contact);
  if (dim > kMostRows) return Status::open;
  // Schemes that aim at the gap include contacts that are not reached yet.
  const bool away = c.position[static_cast<std::size_t>(first)] > a.gTol;
  if (c.law[at]->unilateral() && away && !(a.Lambda[first] > 0.0)) return Status::open;
  std::array<double, kMostRows> epsilon{}, argument{};
  c.law[at]->epsilon(dim, epsilon.data());
  for (int r = 0; r < dim; ++r) {
    const auto k = static_cast<std::size_t>(r);
    const double xi = a.gamma[first + r] + epsilon[k] * a.gammaA[first + r];
    argument[k] = a.Lambda[first + r] - xi;
  }
  return c.law[at]->status(c.input(contact, a.dt, a.gammaA), argument.data());
}

/// Friction limit of a contact: |prox_C(Λ_N, 100 Λ_N, 0, …)| of the tangential rows [N s].
double frictionLimit(const Acting& a, int contact) {
  const ContactSet& c = a.c;
  const auto at = static_cast<std::size_t>(contact);
  const int dim = c.dim(contact);
  const double N = a.Lambda[c.row0[at]];
  if (dim < 2 || dim > kMostRows || !(N > 0.0) || c.law[at]->rowKind(0) != RowKind::normal)
    return 0.0;
  std::array<double, kMostRows> r{}, xi{}, Lambda{};
  r.fill(1.0);
  Lambda[0] = N, Lambda[1] = 100.0 * N;
  c.law[at]->prox({dim, a.dt, a.gamma + c.row0[at], nullptr}, r.data(), xi.data(), Lambda.data());
  return dim > 2 ? std::hypot(Lambda[1], Lambda[2]) : std::abs(Lambda[1]);
}

/// True if the contact drills or rolls more than a thousand times faster than its point slides; the
/// scene's length converts the unit.
bool spins(const Acting& a, int contact, double length) {
  const double* gamma = a.gamma + a.c.row0[static_cast<std::size_t>(contact)];
  double spin = 0.0;
  for (int r = 3; r < a.c.dim(contact); ++r) spin = std::max(spin, std::abs(gamma[r]));
  return spin > 0.0 && std::hypot(gamma[1], gamma[2]) < 1e-3 * spin * length;
}

ContactRecord record(const Acting& a, int contact, Status status, double length) {
  const ContactSet& c = a.c;
  const auto at = static_cast<std::size_t>(contact);
  const int first = c.row0[at], dim = c.dim(contact);
  ContactRecord out;
  out.point = c.places.point[at], out.normal = c.places.normal[at];
  out.status = status;
  out.spin = status == Status::slip && dim > 3 && spins(a, contact, length);
  const Vec3* const direction[] = {&c.places.normal[at], &c.places.t1[at], &c.places.t2[at]};
  for (int r = 0; r < dim && r < 3; ++r) out.force += a.Lambda[first + r] / a.dt * *direction[r];
  out.limit = frictionLimit(a, contact) / a.dt;
  return out;
}

Acting ofStep(const StepView& view) {
  return {view.system.slot(0).contacts,        view.Lambda.data(), view.gammaE.data(),
          view.system.problem().gammaA.data(), view.report.dt,     view.system.gTol()};
}

}  // namespace

Status contactStatus(const StepView& view, int contact) {
  const int rows = view.system.slot(0).contacts.rows();
  if (view.system.problem().gammaA.size() != static_cast<std::size_t>(rows) ||
      view.Lambda.size() != rows)
    return Status::open;
  return statusOf(ofStep(view), contact);
}

ContactRecord contactRecord(const StepView& view, StepImpacts& impacts, int contact) {
  ContactRecord out =
      record(ofStep(view), contact, contactStatus(view, contact), view.model.length());
  out.impact = impacts(view, contact);
  return out;
}

ContactRecord contactRecord(const StepView& view, const ContactInstant& instant, int contact) {
  const double* gamma = instant.gamma.data();
  const Acting acting{*instant.contacts, instant.lambda.data(), gamma, gamma,
                      view.report.dt,    view.system.gTol()};
  return record(acting, contact, statusOf(acting, contact), view.model.length());
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
