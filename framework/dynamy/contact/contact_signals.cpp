#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/law/most_rows.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Index of the contact among the closed contacts of this step; −1: it is open.
int closed(const SignalView& v, const ContactNumbers& n) {
  int i = v.contacts->find(v.element, n.id);
  for (std::uint64_t k = 0; i < 0 && k < n.count; ++k) i = v.contacts->find(v.element, n.first + k);
  return i;
}

double gap(const SignalView& v, const ContactNumbers& n) {
  for (std::size_t i = 0; i < v.contacts->candidateKey.size(); ++i) {
    if (v.contacts->candidateElement[i] != v.element) continue;
    const std::uint64_t id = contactNumber(v.contacts->candidateKey[i]);
    if (id == n.id || id - n.first < n.count) return v.contacts->g[i];
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double rowOf(const SignalView& v, const ContactNumbers& id, int row, const ConstVec& values) {
  const int i = closed(v, id);
  return i < 0 || values.size() == 0 ? 0.0
                                     : values[v.contacts->row0[static_cast<std::size_t>(i)] + row];
}

/// Percussion of the contact over the whole step.
double percussion(const SignalView& v, const ContactNumbers& n, int row) {
  if (v.stepContacts == nullptr) return rowOf(v, n, row, v.Lambda);
  const auto of = [&](std::uint64_t id) {
    const int i = v.stepContacts->find(v.element, id);
    return i < 0 || v.stepLambda.size() == 0
               ? 0.0
               : v.stepLambda[v.stepContacts->row0[static_cast<std::size_t>(i)] + row];
  };
  double sum = of(n.id);
  for (std::uint64_t k = 0; k < n.count; ++k) sum += of(n.first + k);
  return sum;
}

/// Status from Λ and γ^E: once the inclusion holds, Λ − r ξ is the prox argument for any r. A small
/// r is taken, so that neither the unit of mass nor ε γ^A of a rebound decides.
double statusNumber(const SignalView& v, const ContactNumbers& id) {
  const int i = closed(v, id);
  if (i < 0) return static_cast<double>(Status::open);
  const auto at = static_cast<std::size_t>(i);
  const int first = v.contacts->row0[at], dim = v.contacts->dim(i);
  double argument[kMostRows] = {};
  constexpr double kSmall = 1e-6;
  double size = 0.0, speed = 0.0;
  for (int r = 0; r < dim && r < 8; ++r) {
    size = std::max(size, std::abs(v.Lambda[first + r]));
    speed = std::max(speed, std::abs(v.gammaE[first + r]));
  }
  const double small = speed > 0.0 ? kSmall * size / speed : 0.0;
  for (int r = 0; r < dim && r < 8; ++r)
    argument[r] = v.Lambda[first + r] - small * v.gammaE[first + r];
  const LawInput in = v.contacts->input(i, v.dt, v.gammaE.data());
  return static_cast<double>(v.contacts->law[at]->status(in, argument));
}

std::string rowName(const SetValuedForceLaw& law, int row, int dim) {
  const bool normal = law.rowKind(0) == RowKind::normal;
  if (normal && row == 0) return "N";
  // Names of the rows after the tangents: see rolling_contact.hpp.
  static constexpr const char* kAngular[] = {"spin", "roll1", "roll2", "along1", "along2"};
  if (normal && row > 2) return kAngular[row - (dim == 5 ? 2 : 3)];
  const int tangent = normal ? row : row + 1, tangents = normal ? dim - 1 : dim;
  return tangents == 1 ? "T" : "T" + std::to_string(tangent);
}

/// True: γ of the row is an angular velocity.
bool angular(const SetValuedForceLaw& law, int row) {
  return law.rowKind(0) == RowKind::normal && row > 2 && row < 6;
}

}  // namespace

void describeContact(Description& d, const ContactNumbers& id, int geometric,
                     const SetValuedForceLaw& law, const std::string& prefix,
                     AngularRows ofAngles) {
  const int dim = law.dim(geometric);
  d.signal(prefix + "g", (ofAngles & 1U) != 0 ? Unit::angle : Unit::length, "gap",
           [id](const SignalView& v) { return gap(v, id); });
  d.signal(prefix + "status", Unit::none,
           "0 open, 1 separating, 2 stick, 3 slip, 4 lower, 5 upper, 6 locked",
           [id](const SignalView& v) { return statusNumber(v, id); });
  for (int r = 0; r < dim; ++r) {
    const std::string row = rowName(law, r, dim);
    const bool turns = angular(law, r) || (ofAngles >> r & 1U) != 0;
    d.signal(prefix + "gamma_" + row, turns ? Unit::angularVelocity : Unit::velocity,
             "relative velocity; with fixed steps at the end of the step",
             [id, r](const SignalView& v) { return rowOf(v, id, r, v.gammaE); });
    d.signal(prefix + "Lambda_" + row, turns ? Unit::angularImpulse : Unit::impulse,
             "percussion of the step",
             [id, r](const SignalView& v) { return percussion(v, id, r); });
    d.signal(prefix + "lambda_" + row, turns ? Unit::torque : Unit::force,
             "force; with fixed steps percussion over step length", [id, r](const SignalView& v) {
               return v.dt > 0.0 ? rowOf(v, id, r, v.Lambda) / v.dt : 0.0;
             });
  }
}

}  // namespace dynamy
