#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/simulation/equilibrium/equilibrium.hpp>
#include <dynamy/simulation/equilibrium/kinetic_damping.hpp>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/simulation/linear/steady_search.hpp>
#include <optional>

namespace dynamy {
namespace {

/// Forces may be beyond their bounds by this share of the largest: rounding.
constexpr double kBeyond = 1e-9;
constexpr int kMostRelaxations = 400;
/// The longest part of the relaxation, in units of the time that the largest acceleration needs for the
/// scene's length.
constexpr double kLongest = 30.0;
constexpr int kMostJudged = 120;  ///< velocities of a model whose disturbances are looked at
constexpr double kAway =
    30.0;  ///< a body that moves by this many lengths of the scene rests nowhere
/// Newton's method looks for a rest after 1, 2, 3, 5, 8 … maxima: each time this factor more.
constexpr double kMoreSeldom = 1.5;

const char* statusOf(const HeldMotion::Contact& c) {
  if (c.slips) return "slips";
  if (!c.law->unilateral()) return "is held";
  return c.lambda.size() > 1 ? "sticks" : "is closed";
}

class Search {
 public:
  Search(Model& model, const EquilibriumOptions& options) : model_(model), options_(options) {}

  /// An equilibrium near x with the contacts that are closed there. None: fault() says why.
  std::optional<Equilibrium> near(const State& x) {
    HeldMotion motion(model_, x, gap(), options_.near * std::max(1.0, maxAbs(x.u)));
    SteadySearch search(model_, motion);
    Equilibrium out;
    out.sampled = samplingElements(model_);
    out.at = x, out.rest = maxAbs(x.u) == 0.0;
    MotionSample here = motion.at(x);
    if (!(maxAbs(here.a) <= search.allowed()) || maxAbs(here.position) > gap()) {
      try {
        out.moved = search.seek(out.at);
      } catch (const ModelError& lost) {
        return refuse(lost.what());
      }
      here = motion.at(out.at);
    }
    acceleration_ = std::max(acceleration_, motion.freeAcceleration());
    out.residual = maxAbs(here.a);
    if (!(out.residual <= search.allowed())) return refuse(accelerates(here.a));
    if (!search.staysSteady(out.at)) return refuse("the motion does not stay steady");
    if (maxAbs(here.position) > gap()) return refuse("joints or contacts cannot be closed");
    if (!out.rest) motion.at(out.at);  // the forces are those at the start of the motion
    motion.shareWidely();
    out.margin = motion.margin();
    for (const HeldMotion::Contact& c : motion.contacts())
      out.contacts.push_back({c.name, statusOf(c), c.lambda, c.margin});
    if (!(out.margin >= -kBeyond)) return refuse(pulls(out.contacts));
    if (overlaps(out.at)) return refuse("bodies would overlap");
    out.state = coordinatesOf(model_, out.at, !out.rest);
    return out;
  }
  /// Sets how many disturbances of a rest grow.
  void judge(Equilibrium& e) {
    if (model_.topology().nu() > kMostJudged) return;
    try {
      e.growing = linearise(model_, e.at, {.near = options_.near, .seek = false}).growing();
    } catch (const ModelError&) {
      e.growing = -1;  // not known, as beside a contact without force
    }
  }
  const std::string& fault() const { return fault_; }
  /// Largest acceleration by forces alone that was seen [m/s², rad/s²].
  double acceleration() const { return acceleration_; }

 private:
  double gap() const { return options_.near * model_.length(); }
  std::nullopt_t refuse(std::string why) {
    fault_ = std::move(why);
    return std::nullopt;
  }
  std::string accelerates(const Eigen::VectorXd& a) const {
    Eigen::Index most = 0;
    a.cwiseAbs().maxCoeff(&most);
    const std::vector<std::string> names = StateVariation(model_).names();
    return fmt::format("{} accelerates with {:.3g}",
                       names[static_cast<std::size_t>(a.size() + most)], a[most]);
  }
  static std::string pulls(const std::vector<CarryingContact>& contacts) {
    const auto least = std::min_element(
        contacts.begin(), contacts.end(),
        [](const CarryingContact& a, const CarryingContact& b) { return a.margin < b.margin; });
    return fmt::format("{} does not permit the forces of a rest: they are {:.3g} N beyond its law",
                       least->name, -least->margin);
  }
  bool overlaps(const State& x) {
    MechanicalSystem system = model_.mechanicalSystem();
    system.gTol(gap());
    const ContactSet& c = system.evaluate(x).contacts;
    for (int i = 0; i < c.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (c.law[at]->rowKind(0) == RowKind::normal &&
          c.position[static_cast<std::size_t>(c.row0[at])] < -gap())
        return true;
    }
    return false;
  }

  Model& model_;
  const EquilibriumOptions& options_;
  std::string fault_;
  double acceleration_ = 0.0;
};

}  // namespace

Equilibrium equilibrium(Model& model, const State& from, const EquilibriumOptions& options) {
  Search search(model, options);
  std::optional<Equilibrium> found = search.near(from);
  std::string first = search.fault();
  if (!found && maxAbs(from.u) > 0.0)
    throw ModelError("no steady motion near the start: " + first,
                     "give a start nearer to it (--start), or switch off what drives it");
  if (found && found->rest) search.judge(*found);
  if (found && (!options.relax || found->moved == 0.0 || found->growing <= 0)) return *found;
  const std::optional<Equilibrium> nearest = found;
  if (nearest) first = "the rest nearby is unstable";
  if (!options.relax) throw ModelError("no rest near the start: " + first);
  const double time = std::sqrt(model.length() / std::max(search.acceleration(), 1e-12));
  KineticDamping damped(model, from, kLongest * time);
  double next = 1.0;
  for (int i = 1; i <= kMostRelaxations; ++i) {
    if (!damped.next()) break;
    const double way = maxAbs(StateVariation(model).between(damped.at(), from));
    if (way > kAway * std::max(1.0, model.length())) break;
    if (i < next) continue;
    next = std::max(i + 1.0, kMoreSeldom * i);
    found = search.near(damped.at());
    if (found) {
      search.judge(*found);
      if (found->growing > 0 && found->moved > 0.0) continue;
      found->start = first, found->relaxations = i, found->steps = damped.steps();
      return *found;
    }
  }
  if (nearest) return *nearest;
  const std::string& last = damped.why().empty() ? search.fault() : damped.why();
  throw ModelError("no rest found: at the start " + first,
                   "on the way from there: " + last +
                       "; give a start nearer to a rest (--start), or another parameter (--set)");
}

}  // namespace dynamy
