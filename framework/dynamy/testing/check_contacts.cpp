// Checks of the contacts and forces of a built model. Every candidate met at the start is frozen:
// it then counts as closed whatever its gap, so that W, χ and the bias are seen for either sign of
// g.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/simulation/contact_facts.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy/testing/difference.hpp>
#include <limits>
#include <random>
#include <set>

namespace dynamy {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

std::string nameOf(const Element& e, const char* otherwise) {
  if (!e.name().empty()) return e.name();
  return e.type().empty() ? otherwise : e.type();
}

/// Random states of a model and the motion through them.
class Motion {
 public:
  Motion(Model& model, const CheckOptions& options)
      : model_(model), options_(options), random_(options.seed), start_(model.initialState()) {
    kinematics_.resize(model.topology());
    x_ = start_;
  }
  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  /// The start itself first, then states near it.
  void sample(int i) {
    x_ = start_;
    if (i == 0) return;
    Eigen::VectorXd v(start_.u.size());
    for (double& x : v) x = options_.speed * uniform();
    move(x_, v, options_.reach * std::abs(uniform()));
    for (std::size_t s = 0; s < model_.systems().size(); ++s) {
      const SystemHandle& h = model_.topology().system(static_cast<int>(s));
      if (h.nq > 0) model_.systems()[s]->normalise(slice(x_.q, h.q0, h.nq));
    }
    for (double& x : x_.u) x += options_.speed * uniform();
    x_.t = options_.reach * std::abs(uniform());
  }
  State after(double s) const { return after(s, x_.u); }
  /// Along another velocity than that of the state.
  State after(double s, const Eigen::VectorXd& u) const {
    State x = x_;
    x.u = u;
    move(x, u, s);
    return x;
  }
  const State& x() const { return x_; }
  Kinematics& kinematics(const State& x) {
    kinematics_.evaluate(model_.topology(), x.t, view(x.q), view(x.u), view(x.memory));
    return kinematics_;
  }

 private:
  void move(State& x, const Eigen::VectorXd& v, double s) const {
    for (std::size_t i = 0; i < model_.systems().size(); ++i) {
      const SystemHandle& h = model_.topology().system(static_cast<int>(i));
      if (h.nq > 0) model_.systems()[i]->move(x.t, slice(x.q, h.q0, h.nq), slice(v, h.u0, h.nu), s);
    }
    x.t += s;
  }
  Model& model_;
  CheckOptions options_;
  std::mt19937 random_;
  State start_, x_;
  Kinematics kinematics_;
};

class ContactCheck {
 public:
  ContactCheck(Model& model, const CheckOptions& options)
      : model_(model), options_(options), motion_(model, options) {}

  Verdict run() {
    for (int i = 0; i < options_.states && result_; ++i) {
      motion_.sample(i);
      freeze();
      evaluate(motion_.x(), here_);
      if (!shapesFit()) break;
      checkAffine();
      checkGaps();
      if (options_.bias) checkBias();
    }
    checkLaws();
    return result_;
  }

 private:
  std::string label(int contact) const {
    const auto i = static_cast<std::size_t>(contact);
    const auto element = static_cast<std::size_t>(here_.element[i]);
    return fmt::format("{}: contact {}", nameOf(*model_.contacts()[element], "contact element"),
                       contactNumber(here_.key[i]));
  }
  void evaluate(const State& x, ContactSet& out) {
    ContactRequest request;
    request.bias = true;
    request.refresh = true;
    request.frozen = frozen_;
    fill(x, request, out);
  }
  void fill(const State& x, const ContactRequest& request, ContactSet& out) {
    out.clear();
    const Kinematics& k = motion_.kinematics(x);
    ContactSink sink(out, request);
    for (std::size_t i = 0; i < model_.contacts().size(); ++i) {
      sink.element(static_cast<int>(i));
      model_.contacts()[i]->contacts(k, sink);
    }
  }
  /// All candidates of this state.
  void freeze() {
    ContactRequest request;
    request.gTol = std::numeric_limits<double>::infinity();
    fill(motion_.x(), request, here_);
    frozen_ = here_.candidateKey;
    std::sort(frozen_.begin(), frozen_.end());
    if (std::adjacent_find(frozen_.begin(), frozen_.end()) != frozen_.end())
      result_.fault("two contacts of one element have the same number");
    for (std::size_t i = 0; i < here_.g.size(); ++i)
      if (std::isnan(here_.g[i]))
        result_.fault(contactName(model_, here_.candidateKey[i]) + ": g is not a number");
  }
  /// Index of the contact `key` in `set`; −1: not reported there.
  static int find(const ContactSet& set, ContactKey key) {
    const auto at = std::find(set.key.begin(), set.key.end(), key);
    return at == set.key.end() ? -1 : static_cast<int>(at - set.key.begin());
  }

  bool shapesFit();
  void checkAffine();
  void checkGaps();
  void explain(int contact);
  std::string velocityName(int u) const;
  void checkBias();
  void checkLaws();

  Model& model_;
  CheckOptions options_;
  Motion motion_;
  std::vector<ContactKey> frozen_;
  ContactSet here_, there_;
  std::set<std::pair<const SetValuedForceLaw*, int>> laws_;
  Verdict result_;
};

bool ContactCheck::shapesFit() {
  const Topology& topology = model_.topology();
  for (int i = 0; i < here_.size(); ++i) {
    const auto c = static_cast<std::size_t>(i);
    laws_.insert({here_.law[c], here_.dim(i)});
    for (int k = here_.segment0[c]; k < here_.segment0[c + 1]; ++k) {
      const Segment& s = here_.segment[static_cast<std::size_t>(k)];
      bool fits = false;
      for (std::size_t j = 0; j < topology.systems().size(); ++j) {
        const SystemHandle& h = topology.system(static_cast<int>(j));
        fits = fits || (s.block >= h.block0 && s.block < h.block0 + h.blocks && s.nu == h.blockNu &&
                        s.u0 == h.u0 + (s.block - h.block0) * h.blockNu);
      }
      if (!fits)
        result_.fault(
            fmt::format("{}: segment (block {}, u0 {}, nu {}) is no mass block of the model",
                        label(i), s.block, s.u0, s.nu));
    }
    for (int r = here_.row0[c]; r < here_.row0[c + 1]; ++r)
      if (!std::isfinite(here_.chi[static_cast<std::size_t>(r)]))
        result_.fault(fmt::format("{}: chi[{}] is not finite", label(i), r - here_.row0[c]));
  }
  for (int i = 0; i < here_.size(); ++i) {
    const auto c = static_cast<std::size_t>(i);
    for (int k = here_.segment0[c]; k < here_.segment0[c + 1]; ++k) {
      const Segment& s = here_.segment[static_cast<std::size_t>(k)];
      for (int w = 0; w < here_.dim(i) * s.nu; ++w)
        if (const double x = here_.W[static_cast<std::size_t>(s.w + w)]; !std::isfinite(x))
          result_.fault(fmt::format("{}: W[{},{}] = {}: not written?", label(i), w / s.nu,
                                    velocityName(s.u0 + w % s.nu), x));
    }
  }
  return static_cast<bool>(result_);
}

void ContactCheck::checkAffine() {
  // W and χ at another u.
  State other = motion_.x();
  for (double& u : other.u) u = options_.speed * motion_.uniform();
  evaluate(other, there_);
  for (int i = 0; i < here_.size(); ++i) {
    const int j = find(there_, here_.key[static_cast<std::size_t>(i)]);
    if (j < 0 || here_.dim(i) != there_.dim(j)) {
      result_.fault(label(i) + " is reported at one velocity and not at another");
      continue;
    }
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    for (int r = 0; r < here_.dim(i); ++r) {
      const double x = here_.chi[static_cast<std::size_t>(here_.row0[a] + r)],
                   y = there_.chi[static_cast<std::size_t>(there_.row0[b] + r)];
      if (std::abs(x - y) > 64.0 * kEps * std::max(std::abs(x), std::abs(y)))
        result_.fault(
            fmt::format("{}: chi[{}] = {:.9g} and {:.9g} at two velocities: it may not depend on u",
                        label(i), r, x, y));
    }
    const int segments = here_.segment0[a + 1] - here_.segment0[a];
    if (segments != there_.segment0[b + 1] - there_.segment0[b]) continue;
    for (int k = 0; k < segments; ++k) {
      const Segment& s = here_.segment[static_cast<std::size_t>(here_.segment0[a] + k)];
      const Segment& o = there_.segment[static_cast<std::size_t>(there_.segment0[b] + k)];
      for (std::ptrdiff_t w = 0; w < static_cast<std::ptrdiff_t>(here_.dim(i)) * s.nu; ++w) {
        const double x = here_.W[static_cast<std::size_t>(s.w + w)],
                     y = there_.W[static_cast<std::size_t>(o.w + w)];
        // One subtraction γ(e_j) − γ(0) of numbers up to 1 + |χ|.
        if (std::abs(x - y) > 64.0 * kEps * (1.0 + std::abs(x))) {
          result_.fault(fmt::format(
              "{}: W[{},{}] = {:.9g} and {:.9g} at two velocities: it may not depend on u",
              label(i), w / s.nu, s.u0 + w % s.nu, x, y));
          break;
        }
      }
    }
  }
}

void ContactCheck::checkGaps() {
  Eigen::VectorXd gamma = Eigen::VectorXd::Zero(here_.rows());
  here_.gamma(view(motion_.x().u), view(gamma));
  const Eigen::Index n = here_.size();
  const testing::Difference D = testing::differentiate([&](double s) {
    evaluate(motion_.after(s), there_);
    Eigen::VectorXd g = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < here_.size(); ++i) {
      const int j = find(there_, here_.key[static_cast<std::size_t>(i)]);
      if (j >= 0)
        g[i] = there_.g[static_cast<std::size_t>(there_.candidate[static_cast<std::size_t>(j)])];
    }
    return g;
  });
  // A feature that vanishes near by leaves NaN: no statement.
  if (!std::isfinite(D.error)) return;
  for (int i = 0; i < here_.size(); ++i) {
    const auto c = static_cast<std::size_t>(i);
    if (!here_.law[c]->unilateral()) continue;
    const double gammaN = gamma[here_.row0[c]];
    if (!(std::abs(gammaN - D.value[i]) <= D.error + 64.0 * kEps * std::abs(gammaN)))
      result_.fault(fmt::format(
          "{}: gamma_N = Wᵀu + chi = {:.9g} m/s, but dg/dt = {:.9g} m/s along the motion (g = "
          "{:.6g} m)",
          label(i), gammaN, D.value[i], here_.g[static_cast<std::size_t>(here_.candidate[c])]));
    else
      continue;
    explain(i);
  }
}

/// "bead.vx", or "u[3]" where the system does not name it.
std::string ContactCheck::velocityName(int u) const {
  for (std::size_t i = 0; i < model_.systems().size(); ++i) {
    const SystemHandle& h = model_.topology().system(static_cast<int>(i));
    if (u < h.u0 || u >= h.u0 + h.nu) continue;
    for (const auto& [name, k] : model_.description(static_cast<int>(i)).velocities)
      if (k == u - h.u0) return nameOf(*model_.systems()[i], "system") + '.' + name;
  }
  return fmt::format("u[{}]", u);
}

/// dg/dt is affine in u: χ_N is its value at u = 0, each W_N what a unit velocity adds to it.
void ContactCheck::explain(int contact) {
  const auto c = static_cast<std::size_t>(contact);
  const auto rate = [&](const Eigen::VectorXd& u) {
    return testing::differentiate([&](double s) {
      evaluate(motion_.after(s, u), there_);
      const int j = find(there_, here_.key[c]);
      const auto k = static_cast<std::size_t>(std::max(j, 0));
      return Eigen::VectorXd::Constant(
                 1, j < 0 ? std::numeric_limits<double>::quiet_NaN()
                          : there_.g[static_cast<std::size_t>(there_.candidate[k])])
          .eval();
    });
  };
  Eigen::VectorXd u = Eigen::VectorXd::Zero(motion_.x().u.size());
  const testing::Difference still = rate(u);
  const double chi = here_.chi[static_cast<std::size_t>(here_.row0[c])];
  if (!(std::abs(chi - still.value[0]) <= still.error + 64.0 * kEps * std::abs(chi)))
    result_.fault(fmt::format("{}: chi_N = {:.6g} m/s, but dg/dt at u = 0 is {:.6g} m/s",
                              label(contact), chi, still.value[0]));
  for (int k = here_.segment0[c]; k < here_.segment0[c + 1]; ++k) {
    const Segment& s = here_.segment[static_cast<std::size_t>(k)];
    for (int j = 0; j < s.nu; ++j) {
      u[s.u0 + j] = 1.0;
      const testing::Difference D = rate(u);
      u[s.u0 + j] = 0.0;
      const double W = here_.W[static_cast<std::size_t>(s.w + j)],
                   expected = D.value[0] - still.value[0];
      if (!(std::abs(W - expected) <= D.error + still.error + 64.0 * kEps * (1.0 + std::abs(W))))
        result_.fault(fmt::format("{}: W_N of {} = {:.6g}, but it changes dg/dt by {:.6g}",
                                  label(contact), velocityName(s.u0 + j), W, expected));
    }
  }
}

void ContactCheck::checkBias() {
  const State& x = motion_.x();
  const testing::Difference D = testing::differentiate([&](double s) {
    evaluate(motion_.after(s), there_);
    Eigen::VectorXd all = Eigen::VectorXd::Zero(there_.rows()),
                    out = Eigen::VectorXd::Constant(here_.rows(),
                                                    std::numeric_limits<double>::quiet_NaN());
    there_.gamma(view(x.u), view(all));
    for (int i = 0; i < here_.size(); ++i) {
      const auto c = static_cast<std::size_t>(i);
      const int j = find(there_, here_.key[c]);
      if (j >= 0 && there_.dim(j) == here_.dim(i))
        out.segment(here_.row0[c], here_.dim(i)) =
            all.segment(there_.row0[static_cast<std::size_t>(j)], here_.dim(i));
    }
    return out;
  });
  if (!std::isfinite(D.error)) return;
  evaluate(x, here_);
  for (int i = 0; i < here_.size(); ++i) {
    const auto c = static_cast<std::size_t>(i);
    for (int r = 0; r < here_.dim(i); ++r) {
      const double bias = here_.bias[static_cast<std::size_t>(here_.row0[c] + r)],
                   expected = D.value[here_.row0[c] + r];
      // The element may itself take differences: 1e-9 of the size.
      const double tolerance = D.error + 1e-9 * (std::abs(bias) + 1.0);
      if (!(std::abs(bias - expected) <= tolerance))
        result_.fault(
            fmt::format("{}: bias[{}] = {:.9g} m/s², but dgamma/dt = {:.9g} m/s² at fixed u",
                        label(i), r, bias, expected));
    }
  }
}

void ContactCheck::checkLaws() {
  // Sorted by address: the order of faults may change from run to run, never what is found.
  for (const auto& [law, dim] : laws_) result_.add(checkLaw(*law, dim, options_));
}

}  // namespace

Verdict checkContacts(Model& model, const CheckOptions& options) {
  return ContactCheck(model, options).run();
}

Verdict checkForces(Model& model, const CheckOptions& options) {
  Verdict result;
  Motion motion(model, options);
  const int nu = model.topology().nu();
  Eigen::VectorXd h(nu), nonPotential(nu);
  for (int i = 0; i < options.states && result; ++i) {
    motion.sample(i);
    const State x = motion.x();
    for (const auto& force : model.forces()) {
      h.setZero(), nonPotential.setZero();
      ForceSink sink(view(h), view(nonPotential));
      sink.hasPotential(force->hasPotential());
      force->addTo(motion.kinematics(x), sink);
      const std::string name = nameOf(*force, "force");
      if (!h.allFinite()) result.fault(name + ": a force is not finite");
      if (!force->hasPotential()) continue;
      const double V = force->potentialEnergy(motion.kinematics(x));
      State later = x;
      later.t += 0.37;
      // Driven through t: its power is not all of dV/dt.
      if (force->potentialEnergy(motion.kinematics(later)) != V) continue;
      const testing::Difference D = testing::differentiate([&](double s) {
        return Eigen::VectorXd::Constant(1,
                                         force->potentialEnergy(motion.kinematics(motion.after(s))))
            .eval();
      });
      const double power = h.dot(x.u), rounding = 64.0 * kEps * h.cwiseAbs().dot(x.u.cwiseAbs());
      if (!(std::abs(power + D.value[0]) <= D.error + rounding))
        result.fault(
            fmt::format("{}: force·u = {:.9g} W, but -dV/dt = {:.9g} W", name, power, -D.value[0]));
    }
  }
  return result;
}

}  // namespace dynamy
