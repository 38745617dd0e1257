#include <algorithm>
#include <array>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/simulation/linear/held_motion.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Joints with friction stick below this velocity [m/s, rad/s].
constexpr double kSticks = 1e-9;

/// Initial status of a part of contact i, its rows from `part[0]` on; `gamma`: of the contact. False:
/// the contact opens, or never acts, and is not held.
bool begins(const ContactSet& c, int i, std::array<int, 2> part, const double* gamma, double still,
            Held& out) {
  const auto at = static_cast<std::size_t>(i);
  const SetValuedForceLaw& law = *c.law[at];
  out.key = c.key[at], out.first = part[0], out.rows = part[1];
  ForceSet set;
  LawInput in = c.input(i, 1.0, nullptr);
  in.gammaA = gamma;
  if (in.dim > kMostRows || !forceSet(law, in, set, part[0]))
    return true;  // accelerate() reports the reason
  if (set.idle()) return false;
  if (law.unilateral() && gamma[0] > still) return false;
  if (set.form == ForceSet::Form::notch) {
    const double x = in.position[0];
    out.slips = std::abs(x) > kSticks || std::abs(gamma[0]) > kSticks;
    out.sign = (std::abs(x) > kSticks ? x : gamma[0]) > 0.0 ? 1.0 : -1.0;
    return true;
  }
  const bool cone = set.form == ForceSet::Form::cone, disc = set.form == ForceSet::Form::disc;
  if (!cone && !disc && set.form != ForceSet::Form::given) return true;
  const int first = part[0] + (cone ? 1 : 0), k = part[0] + part[1] - first;
  double slip = 0.0;
  for (int r = first; r < first + k; ++r) slip = std::hypot(slip, gamma[r]);
  out.slips = k > 0 && slip > (cone || disc ? still : kSticks);
  out.sign = k == 1 ? (gamma[first] > 0.0 ? 1.0 : -1.0) : 0.0;
  for (int r = 0; out.slips && k == 2 && r < 2; ++r)
    out.direction[static_cast<std::size_t>(r)] = gamma[first + r] / slip;
  return true;
}

}  // namespace

HeldMotion::HeldMotion(Model& model, const State& x, double gap, double slip)
    : model_(model), system_(model.mechanicalSystem()) {
  system_.gTol(gap);
  const ContactSet& c = system_.evaluate(x, {.bias = true}).contacts;
  Eigen::VectorXd gamma(c.rows());
  c.gamma(view(x.u), view(gamma));
  std::vector<std::array<int, 2>> parts;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    statusParts(*c.law[at], c.dim(i), parts);
    for (const std::array<int, 2>& part : parts) {
      Held held;
      if (!begins(c, i, part, gamma.data() + c.row0[at], slip, held)) break;
      if (parts.size() == 1) held.rows = 0;  // all
      phase_.held.push_back(held);
    }
  }
  heldKeys(phase_.held, keys_);
}

MotionSample HeldMotion::at(const State& x) {
  widest_.reset();
  const Evaluation& e = system_.evaluate(x, {.held = HeldContacts{keys_}, .bias = true});
  if (const int wrong = system_.indefiniteMass(); wrong >= 0)
    throw ModelError(systemName(model_, wrong) + ": the mass matrix is not positive definite",
                     "the motion cannot be linearised here");
  MotionSample out;
  if (!phase_.accelerate(e, x.u, out.a))
    throw ModelError("the motion cannot be linearised: " + std::string(phase_.fault()),
                     "eigenvalues need joints, frictionless contacts and Coulomb's friction");
  Eigen::VectorXd free(x.u.size());
  e.mass.applyInverse(view(e.h), view(free));
  freeAcceleration_ = free.size() > 0 ? free.lpNorm<Eigen::Infinity>() : 0.0;
  std::vector<double> gamma, position;
  const HeldRows& rows = phase_.rows();
  for (std::size_t i = 0; i < phase_.held.size(); ++i) {
    const bool slips = phase_.held[i].slips;
    const bool cone = rows.set(i).form == ForceSet::Form::cone;
    const int kept = !slips ? rows.dim(i) : cone ? 1 : 0;
    const auto at = static_cast<std::size_t>(
        std::find(e.contacts.key.begin(), e.contacts.key.end(), phase_.held[i].key) -
        e.contacts.key.begin());
    for (int r = 0; r < kept; ++r) {
      gamma.push_back(rows.gamma()[rows.row0(i) + r]);
      position.push_back(
          e.contacts
              .position[static_cast<std::size_t>(e.contacts.row0[at] + phase_.held[i].first + r)]);
    }
  }
  out.gamma = ConstVec(gamma.data(), static_cast<Eigen::Index>(gamma.size()));
  out.position = ConstVec(position.data(), static_cast<Eigen::Index>(position.size()));
  return out;
}

Eigen::VectorXd HeldMotion::qdot(const State& x, const Eigen::VectorXd& u) const {
  const Topology& t = model_.topology();
  Eigen::VectorXd out = Eigen::VectorXd::Zero(t.nq());
  for (std::size_t i = 0; i < model_.systems().size(); ++i) {
    const SystemHandle& s = t.system(static_cast<int>(i));
    if (s.nq > 0)
      model_.systems()[i]->qdot(x.t, slice(x.q, s.q0, s.nq), slice(u, s.u0, s.nu),
                                slice(out, s.q0, s.nq));
  }
  return out;
}

Eigen::VectorXd HeldMotion::rate(const State& x, const Eigen::VectorXd& v) const {
  return qdot(x, v) - qdot(x, Eigen::VectorXd::Zero(v.size()));
}

State HeldMotion::displaced(const State& x, const Eigen::VectorXd& delta) const {
  State out = x;
  out.q += rate(x, delta);
  for (std::size_t i = 0; i < model_.systems().size(); ++i) {
    const SystemHandle& s = model_.topology().system(static_cast<int>(i));
    if (s.nq > 0) model_.systems()[i]->normalise(slice(out.q, s.q0, s.nq));
  }
  return out;
}

State HeldMotion::movedOn(const State& x, double tau) const {
  State out = x;
  system_.move(out, x.u, tau);
  return out;
}

void HeldMotion::shareWidely() { widest_.emplace(phase_); }

double HeldMotion::margin() const {
  const double force = std::max(phase_.forceScale(), std::numeric_limits<double>::min());
  double least = std::numeric_limits<double>::infinity();
  for (const Contact& c : contacts()) least = std::min(least, c.margin / force);
  return least;
}

std::vector<HeldMotion::Contact> HeldMotion::contacts() const {
  std::vector<Contact> out;
  const ContactSet& c = system_.slot(0).contacts;
  const Eigen::VectorXd& lambda = widest_ ? widest_->lambda() : phase_.lambda();
  for (std::size_t i = 0; i < phase_.held.size(); ++i) {
    const Held& held = phase_.held[i];
    double margin = 0.0;
    if (!(widest_ ? widest_->margin(i, margin) : phase_.margin(i, margin)))
      margin = std::numeric_limits<double>::infinity();
    if (held.first == 0) {
      Contact contact;
      contact.name = contactName(model_, held.key);
      const auto at = std::find(c.key.begin(), c.key.end(), held.key) - c.key.begin();
      contact.law = c.law[static_cast<std::size_t>(at)];
      contact.margin = std::numeric_limits<double>::infinity();
      out.push_back(std::move(contact));
    }
    Contact& contact = out.back();  // later parts of a contact follow its first one
    contact.slips = contact.slips || held.slips, contact.margin = std::min(contact.margin, margin);
    const HeldRows& rows = phase_.rows();
    for (int r = 0; r < rows.dim(i); ++r) contact.lambda.push_back(lambda[rows.row0(i) + r]);
  }
  return out;
}

}  // namespace dynamy
