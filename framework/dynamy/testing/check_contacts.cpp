// Checks of the contacts of a built model. Every candidate met at the start is frozen:
// it then counts as closed whatever its gap, so that W, χ and the bias are seen for either sign of
// g.
#include <fmt/format.h>
#include <dynamy/core/constants.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy/testing/difference.hpp>
#include <dynamy/testing/random_motion.hpp>
#include <limits>
#include <map>
#include <set>

namespace dynamy {
namespace {

using testing::RandomMotion, testing::nameOf;

/// Most contacts that are listed as left out; of more, their number.
constexpr std::size_t kMostLeftOut = 20;

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
      if (i == 0) checkPositions();  // rates of angles hold only where the joint is closed
      if (options_.bias) checkBias();
    }
    checkLaws();
    if (result_) listLeftOut();
    return result_;
  }

 private:
  std::string label(int contact) const {
    const auto i = static_cast<std::size_t>(contact);
    return label(here_.key[i], *here_.law[i]);
  }
  /// Of a gap or a velocity, from positions of the size of the scene.
  double rounding() const {
    return kEpsilon * model_.length() * (1.0 + motion_.x().u.cwiseAbs().sum());
  }
  /// Place of the element, or of the law where one element has the contacts of all shapes.
  std::string label(ContactKey key, const SetValuedForceLaw& law) const {
    const Element& element = *model_.contacts()[static_cast<std::size_t>(key.value >> 40)];
    return testing::withPlace(element.place().line > 0 ? element.place() : law.place(),
                              contactName(model_, key));
  }
  /// What was compared of a contact.
  struct Compared {
    std::string name;
    bool gap = false, bias = false;
  };
  Compared& compared(int contact) {
    const ContactKey key = here_.key[static_cast<std::size_t>(contact)];
    Compared& out = compared_[key];
    if (out.name.empty()) out.name = label(contact);
    return out;
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
  /// Freezes all candidates of this state.
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
  void checkPositions();
  void explain(int contact);
  std::string velocityName(int u) const;
  void checkBias();
  void checkLaws();
  void listLeftOut();

  Model& model_;
  CheckOptions options_;
  RandomMotion motion_;
  std::vector<ContactKey> frozen_;
  ContactSet here_, there_;
  std::set<std::pair<const SetValuedForceLaw*, int>> laws_;
  std::map<ContactKey, Compared> compared_;
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
  // Compare W and χ with those at another u.
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
      // Elements may subtract W u from γ, or two terms of χ from each other.
      if (std::abs(x - y) > 64.0 * kEpsilon * std::max(std::abs(x), std::abs(y)) + rounding())
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
        if (std::abs(x - y) > 64.0 * kEpsilon * (1.0 + std::abs(x))) {
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
  const auto gaps = [&](double s) {
    evaluate(motion_.after(s), there_);
    Eigen::VectorXd g = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < here_.size(); ++i) {
      const int j = find(there_, here_.key[static_cast<std::size_t>(i)]);
      if (j >= 0)
        g[i] = there_.g[static_cast<std::size_t>(there_.candidate[static_cast<std::size_t>(j)])];
    }
    return g;
  };
  const testing::Differences D = testing::differentiateEach(gaps, rounding());
  for (int i = 0; i < here_.size(); ++i) {
    const auto c = static_cast<std::size_t>(i);
    const double gammaN = gamma[here_.row0[c]], off = std::abs(gammaN - D.value[i]);
    const bool fits = off <= D.error[i] + 64.0 * kEpsilon * std::abs(gammaN);
    // Of a contact that vanishes at states nearby, or kinks here, nothing can be stated here.
    const bool states =
        !here_.law[c]->unilateral() ||
        (std::isfinite(D.error[i]) && (fits || testing::contradicts(gaps, i, gammaN, off)));
    compared(i).gap |= states;
    if (!states || !here_.law[c]->unilateral()) continue;
    if (!fits)
      result_.fault(fmt::format(
          "{}: gamma_N = Wᵀu + chi = {:.9g} m/s, but dg/dt = {:.9g} m/s along the motion (g = "
          "{:.6g} m)",
          label(i), gammaN, D.value[i], here_.g[static_cast<std::size_t>(here_.candidate[c])]));
    else
      continue;
    explain(i);
  }
}

/// Checks that γ of a joint's row is the rate of the row's position, where the joint is closed.
void ContactCheck::checkPositions() {
  Eigen::VectorXd gamma = Eigen::VectorXd::Zero(here_.rows()), u = motion_.x().u;
  for (double& v : u) v += options_.speed * motion_.uniform();
  here_.gamma(view(std::as_const(u)), view(gamma));
  const testing::Differences D = testing::differentiateEach([&](double s) {
    evaluate(motion_.after(s, u), there_);
    Eigen::VectorXd g =
        Eigen::VectorXd::Constant(here_.rows(), std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < here_.size(); ++i) {
      const auto c = static_cast<std::size_t>(i);
      const int j = find(there_, here_.key[c]);
      for (int r = 0; j >= 0 && r < here_.dim(i); ++r)
        g[here_.row0[c] + r] =
            there_.position[static_cast<std::size_t>(there_.row0[static_cast<std::size_t>(j)] + r)];
    }
    return g;
  });
  for (int i = 0; i < here_.size(); ++i) {
    const auto c = static_cast<std::size_t>(i);
    const SetValuedForceLaw& law = *here_.law[c];
    if (law.unilateral() || law.rowKind(0) != RowKind::joint) continue;
    for (int r = 0; r < here_.dim(i); ++r) {
      const int row = here_.row0[c] + r;
      // An open joint's rate is off by g ω.
      const double off = std::abs(here_.g[static_cast<std::size_t>(here_.candidate[c])]) *
                         (1.0 + u.cwiseAbs().maxCoeff());
      if (std::abs(gamma[row] - D.value[row]) <=
          D.error[row] + off + 64.0 * kEpsilon * std::abs(gamma[row]))
        continue;
      result_.fault(fmt::format(
          "{}: gamma[{}] = Wᵀu + chi = {:.9g} m/s, but its position changes by {:.9g} m/s{}",
          label(i), r, gamma[row], D.value[row],
          D.value[row] == 0.0 ? ": write rows.position, or give it a BilateralRate" : ""));
    }
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

/// Names the wrong entries. dg/dt is affine in u: χ_N is its value at u = 0, and each entry of W_N
/// is what a unit velocity adds to it.
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
  if (!std::isfinite(still.error)) return;  // the contact vanishes nearby
  const double chi = here_.chi[static_cast<std::size_t>(here_.row0[c])];
  if (!(std::abs(chi - still.value[0]) <= still.error + 64.0 * kEpsilon * std::abs(chi)))
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
      if (std::isfinite(D.error) &&
          !(std::abs(W - expected) <=
            D.error + still.error + 64.0 * kEpsilon * (1.0 + std::abs(W))))
        result_.fault(fmt::format("{}: W_N of {} = {:.6g}, but it changes dg/dt by {:.6g}",
                                  label(contact), velocityName(s.u0 + j), W, expected));
    }
  }
}

void ContactCheck::checkBias() {
  const State& x = motion_.x();
  const auto velocities = [&](double s) {
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
  };
  const testing::Differences D = testing::differentiateEach(velocities, rounding());
  evaluate(x, here_);
  for (int i = 0; i < here_.size(); ++i) {
    const auto c = static_cast<std::size_t>(i);
    if (!std::isfinite(D.error[here_.row0[c]])) continue;
    compared(i).bias = true;
    for (int r = 0; r < here_.dim(i); ++r) {
      const double bias = here_.bias[static_cast<std::size_t>(here_.row0[c] + r)],
                   expected = D.value[here_.row0[c] + r];
      // The element may itself take differences: 1e-9 of the size.
      const double tolerance = D.error[here_.row0[c] + r] + 1e-9 * (std::abs(bias) + 1.0);
      if (const double off = std::abs(bias - expected);
          !(off <= tolerance) && testing::contradicts(velocities, here_.row0[c] + r, bias, off))
        result_.fault(
            fmt::format("{}: bias[{}] = {:.9g} m/s², but dgamma/dt = {:.9g} m/s² at fixed u",
                        label(i), r, bias, expected));
    }
  }
}

void ContactCheck::checkLaws() {
  // Laws are sorted by address: the order of faults may change from run to run, but not the faults.
  for (const auto& [law, dim] : laws_) result_.add(checkLaw(*law, dim, options_));
}

/// Lists what was not compared: of contacts that were met, and pairs that were not. An element
/// without a name has the contacts of many pairs, "A-B.corner3", and announces signals of each.
void ContactCheck::listLeftOut() {
  std::vector<std::string> all;
  std::set<std::string> pairs;
  std::vector<int> listed(model_.contacts().size(), 0);
  const auto pairOf = [](const std::string& contact) {
    return contact.substr(0, contact.find('.'));
  };
  for (const auto& [key, c] : compared_) {
    pairs.insert(pairOf(contactName(model_, key)));
    ++listed[static_cast<std::size_t>(key.value >> 40)];
    const bool bias = c.bias || !options_.bias;
    if (c.gap && bias) continue;
    const char* const part = c.gap ? "its bias" : bias ? "its gap" : "its gap and bias";
    all.push_back(c.name + ": " + part +
                  ", since it comes and goes, or kinks, at the states nearby");
  }
  for (const NamedSignal& s : model_.signals()) {
    if (s.contact < 0 || !s.name.ends_with(".status")) continue;
    const auto element = static_cast<std::size_t>(s.contact);
    if (!model_.contacts()[element]->name().empty()) continue;
    if (!pairs.insert(pairOf(s.name)).second) continue;
    ++listed[element];
    all.push_back(pairOf(s.name) + ": no contact of the two is met near the start");
  }
  for (std::size_t i = 0; i < listed.size(); ++i)
    if (listed[i] == 0)
      all.push_back(testing::labelOf(*model_.contacts()[i], "contacts between shapes") +
                    ": no contact of it is met near the start");
  for (std::size_t i = 0; i < std::min(all.size(), kMostLeftOut); ++i) result_.leftOut(all[i]);
  if (all.size() > kMostLeftOut)
    result_.leftOut(fmt::format("and {} more contacts", all.size() - kMostLeftOut));
}

}  // namespace

Verdict checkContacts(Model& model, const CheckOptions& options) {
  return ContactCheck(model, options).run();
}

}  // namespace dynamy
