#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/located/switch_governor.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/run_watch.hpp>
#include <dynamy/stages/error_norm.hpp>
#include <limits>
#include <map>

namespace dynamy {
namespace {

constexpr double kPositions = 1e-11;  ///< relative error of energies by positions known to g_tol
constexpr double kFewSteps = 64.0;    ///< added to the number of steps, for the rounding of one
/// Gaps at the end of a step are evaluated if the extrapolated depth exceeds all before by the
/// factor kDeeper. This is done kFirstLooks times, then once in kStepsPerLook steps on average.
/// Each evaluation costs up to a step, so that a run of 1000 steps takes 1.6 % longer. Beyond that
/// the depth is extrapolated by γ^E alone, with an error of (ω Δt/2)²/2 of a body's size.
constexpr double kDeeper = 1.01;
constexpr long kFirstLooks = 8, kStepsPerLook = 128;
constexpr double kOverlapNoise = 1e-12;  ///< of the scene's length
constexpr double kSamples = 256.0;       ///< samples of the energy in a run
/// After the first kFirst steps only three in a row of every kEvery are examined, so that watching
/// costs little.
constexpr long kFirst = 256, kEvery = 16;

/// Smallest extent along an axis [m]; infinite for flat shapes: nothing passes the ground.
double extent(const std::vector<Vec3>& points) {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double least = (high - low).minCoeff();
  return least > 0.0 ? least : std::numeric_limits<double>::infinity();
}

/// Smallest extent of a shape [m]; infinite for a half space, which nothing passes.
double smallestSize(const ShapeGeometry& g) {
  if (g.type == "HalfSpace") return std::numeric_limits<double>::infinity();
  if (g.type == "Box") return std::min({g.size[0], g.size[1], g.size[2]});
  if (g.type == "Cylinder" || g.type == "Cone") return std::min(2.0 * g.size[0], g.size[1]);
  if (g.type == "Ellipsoid") return 2.0 * std::min({g.size[0], g.size[1], g.size[2]});
  if (g.type == "Torus") return 2.0 * g.size[1];
  if (g.type == "Mesh" || g.type == "Polyhedron") return extent(g.points);
  return g.type == "Point" ? 0.0 : 2.0 * g.size[0];
}

}  // namespace

RunWatch::RunWatch(Model& model, EnergyLedger& ledger, RunReport& report)
    : model_(model),
      ledger_(ledger),
      report_(report),
      sampleEvery_(std::max(model.simulation.until, 0.0) / kSamples) {
  for (Eigen::VectorXd* v : {&increment_, &before_, &momentum_}) v->setZero(model.topology().nu());
  collectShapes(model);
}

void RunWatch::collectShapes(const Model& model) {
  struct Sized {
    int system, frame;
    double size;
  };
  std::vector<Sized> shapes;
  for (std::size_t i = 0; i < model.systems().size(); ++i)
    for (const PlacedShape& p : model.description(static_cast<int>(i)).shapes)
      if (!p.shape->material().empty())
        shapes.push_back({static_cast<int>(i), p.frame, smallestSize(p.shape->geometry())});
  // Two points never touch. For all other shapes the smallest shape of another system decides.
  std::sort(shapes.begin(), shapes.end(),
            [](const Sized& a, const Sized& b) { return a.size < b.size; });
  const auto extended =
      std::find_if(shapes.begin(), shapes.end(), [](const Sized& s) { return s.size > 0.0; });
  const std::vector<std::pair<int, int>>& asked = model.topology().requestedFrames();
  std::map<std::pair<int, int>, int> frames;
  for (std::size_t i = 0; i < asked.size(); ++i) frames.emplace(asked[i], static_cast<int>(i));
  for (const Sized& a : shapes) {
    const auto from = a.size > 0.0 ? shapes.begin() : extended;
    const auto partner = std::find_if(from, shapes.end(), [&](const Sized& b) {
      const bool many = model.topology().system(b.system).blocks > 1;
      return b.system != a.system || (many && b.frame != a.frame);
    });
    const auto at = frames.find({a.system, a.frame});
    if (partner == shapes.end() || at == frames.end()) continue;
    const double size = a.size + partner->size;
    if (std::isfinite(size)) movers_.push_back({{at->second}, size});
  }
}

void RunWatch::start(const StepView& initial) {
  const double until = model_.simulation.until - initial.after.t;
  const Eigen::Index nu = initial.after.u.size();
  if (until > 0.0 && nu > 0) {
    Eigen::VectorXd positions;
    unitScales(model_.topology(), model_.length(), positions, before_);
    initial.system.slot(0).mass.apply(dynamy::view(std::as_const(before_)),
                                      dynamy::view(momentum_));
    inertia_ = 0.5 * before_.dot(momentum_) / (until * until);
  }
  const std::vector<const SetValuedForceLaw*>& laws = initial.system.slot(0).contacts.law;
  joints_ = std::any_of(laws.begin(), laws.end(),
                        [](const SetValuedForceLaw* law) { return holds(law->rowKind(0)); });
  sample(initial);
  positions(initial.after);  // bodies may overlap in the initial state
}

void RunWatch::step(const StepView& view) {
  // Schemes that choose their steps control the resolution of the motion themselves.
  if (!view.scheme.choosesSteps() && (view.index <= kFirst || view.index % kEvery < 3)) {
    travel(view);
    resolution(view);
  } else {
    smooth_ = -1;
  }
  report_.damped = std::max(report_.damped, view.system.damped());
  if (!view.scheme.choosesSteps()) ends(view);
  if (view.after.t >= nextSample_) sample(view);
}

void RunWatch::sample(const StepView& view) {
  if (view.after.t == lastSample_) return;
  lastSample_ = view.after.t;
  nextSample_ = view.after.t + sampleEvery_;
  energy(view);
  // Joints are held at ends of steps, where steps do not evaluate them; every step, and ends(),
  // examines overlaps.
  const std::vector<const SetValuedForceLaw*>& laws = view.system.slot(0).contacts.law;
  if (std::any_of(laws.begin(), laws.end(), [](const auto* law) { return !law->unilateral(); }))
    positions(view.after);
}

void RunWatch::ends(const StepView& view) {
  const ContactSet& c = view.system.slot(0).contacts;
  const double rest = view.after.t - view.system.slot(0).t;
  const double known = kDeeper * report_.penetration.value + kOverlapNoise * model_.length();
  if (!(rest > 0.0) || view.gammaE.size() != c.rows()) return;
  // With joints the positions may follow the mean velocity.
  const std::vector<double>& gammaA = view.system.problem().gammaA;
  const bool mean = joints_ && gammaA.size() == static_cast<std::size_t>(c.rows());
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!c.law[at]->unilateral()) continue;
    const int row = c.row0[at];
    double rate = view.gammaE[row];
    if (mean) rate = std::min(rate, 0.5 * (rate + gammaA[static_cast<std::size_t>(row)]));
    const double deep = -c.position[static_cast<std::size_t>(row)] - rest * rate;
    if (!(deep > known)) continue;
    if (looks_ <= kFirstLooks + view.index / kStepsPerLook) {
      ++looks_;
      overlapsAt(view.after);
      return;
    }
    Worst& worst = report_.penetration;
    if (!mean && deep > worst.value)
      worst.value = deep, worst.t = view.after.t, worst.contact = c.key[at];
  }
}

MechanicalSystem& RunWatch::ends() {
  if (!ends_) ends_ = std::make_unique<MechanicalSystem>(model_.mechanicalSystem());
  return *ends_;
}

void RunWatch::overlapsAt(const State& x) {
  const ContactSet& c = ends().look(x);
  Worst& worst = report_.penetration;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    const int closed = c.closedIndex[i];
    if (closed >= 0 && !c.law[static_cast<std::size_t>(closed)]->unilateral()) continue;
    if (-c.g[i] > worst.value)
      worst.value = -c.g[i], worst.t = x.t, worst.contact = c.candidateKey[i];
  }
}

void RunWatch::positions(const State& x) {
  const ContactSet& c = ends().evaluate(x).contacts;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    const int closed = c.closedIndex[i];
    const SetValuedForceLaw* law = closed >= 0 ? c.law[static_cast<std::size_t>(closed)] : nullptr;
    const bool joint = law != nullptr && !law->unilateral();
    if (joint && law->rowKind(0) != RowKind::joint) continue;  // others have no position error
    Worst& worst = joint ? report_.jointError : report_.penetration;
    const double value = joint ? c.g[i] : -c.g[i];
    if (value > worst.value) worst.value = value, worst.t = x.t, worst.contact = c.candidateKey[i];
  }
}

void RunWatch::energy(const StepView& view) {
  const EnergyReport e = ledger_.upTo(view.after);
  RunTrust& trust = report_.trust;
  if (!std::isfinite(e.end())) {  // beyond what numbers hold: squares of velocities overflow first
    trust.energyRise = std::numeric_limits<double>::infinity();
    trust.energyRiseTime = view.after.t;
    return;
  }
  trust.kineticMax = std::max(trust.kineticMax, e.kineticEnd);
  const double unexplained = e.discretisation + e.joints;
  if (report_.impacts == sampledImpacts_) unexplained_ += unexplained - sampled_;
  sampled_ = unexplained, sampledImpacts_ = report_.impacts;
  const double error = std::abs(unexplained_);
  if (error > trust.energyError) trust.energyError = error, trust.energyErrorTime = view.after.t;
  rounding(e);
  const double rise = e.end() - e.start() - e.nonPotential - e.boundaries;
  if (rise > trust.energyRise) trust.energyRise = rise, trust.energyRiseTime = view.after.t;
  // Gains count from the lowest level, so that losses in impacts do not hide later gains. Laws that
  // store energy give it back: only a rise that the scheme's own part shares is a gain.
  if (rise < least_ || e.discretisation < leastOwn_) sinceLeast_ = 0.0;
  least_ = std::min(least_, rise), leastOwn_ = std::min(leastOwn_, e.discretisation);
  RunTrust now = trust;
  now.energyGain = std::min(rise - least_, e.discretisation - leastOwn_);
  now.energyGainTime = view.after.t, now.gainStep = sinceLeast_;
  if (now.energyGain * trust.gainScale() > trust.energyGain * now.gainScale()) trust = now;
}

void RunWatch::rounding(const EnergyReport& e) {
  moves_ = std::max(moves_, e.kineticEnd + std::abs(e.potentialEnd) + std::abs(e.nonPotential) +
                                std::abs(e.friction) + std::abs(e.normal) + std::abs(e.joints) +
                                std::abs(e.boundaries));
  const double steps = kFewSteps + static_cast<double>(report_.steps);
  report_.trust.rounding = std::max(kEpsilon * steps, kPositions) * moves_ + kEpsilon * inertia_;
}

void RunWatch::resolution(const StepView& view) {
  const Evaluation& e = view.system.slot(0);
  const double dt = view.report.dt;
  // Energy that the forces alone would give in one step: the smallest scale of energies at rest.
  before_ = view.after.u - view.before.u;
  e.mass.applyInverse(dynamy::view(e.h), dynamy::view(momentum_));
  const double force = dt * dt * e.h.dot(momentum_);
  // Forces that the step does not resolve are excluded, because it takes only a part of them in h.
  if (view.system.damped() == 0) {
    report_.trust.stepEnergy = std::max(report_.trust.stepEnergy, 0.5 * force);
    sinceLeast_ = std::max(sinceLeast_, 0.5 * force);
    if (momentum_.size() > 0)
      report_.trust.fall =
          std::max(report_.trust.fall, 0.5 * dt * dt * momentum_.cwiseAbs().maxCoeff());
  }
  const bool changed = report_.switches != switches_ || report_.impacts != impacts_;
  switches_ = report_.switches, impacts_ = report_.impacts;
  smooth_ = changed ? 0 : smooth_ + 1;
  if (smooth_ > 1) {
    increment_ = before_ - increment_;
    e.mass.apply(dynamy::view(std::as_const(increment_)), dynamy::view(momentum_));
    curvature_ += increment_.dot(momentum_);
    e.mass.apply(dynamy::view(view.after.u), dynamy::view(momentum_));
    speed_ += view.after.u.dot(momentum_) + force;
  }
  increment_ = before_;
}

void RunWatch::travel(const StepView& view) {
  const Kinematics& k = view.system.slot(0).kinematics;
  const double dt = view.report.dt;
  RunTrust& trust = report_.trust;
  const std::size_t frames = model_.topology().requestedFrames().size();
  for (std::size_t i = 0; i < frames; ++i) {
    const Frame& f = k.frame({static_cast<int>(i)});
    trust.way = std::max(trust.way, f.v_S_I.norm() * dt);
    trust.turn = std::max(trust.turn, f.Omega_I.norm() * dt);
  }
  // The speed of systems without frames is that of their contacts.
  const ContactSet& c = view.system.slot(0).contacts;
  const std::vector<double>& gammaA = view.system.problem().gammaA;
  for (int i = 0; i < c.size() && gammaA.size() == static_cast<std::size_t>(c.rows()); ++i) {
    const auto row = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)]);
    if (c.law[static_cast<std::size_t>(i)]->unilateral())
      trust.way = std::max(trust.way, -gammaA[row] * dt);
  }
  for (const Mover& m : movers_)
    trust.leap = std::max(trust.leap, k.frame(m.frame).v_S_I.norm() * dt / m.size);
}

void RunWatch::finish(const StepView& last) {
  sample(last);
  for (Worst* w :
       {&report_.residual, &report_.penetration, &report_.solvedOverlap, &report_.jointError})
    if (w->value > 0.0) w->name = contactName(last.model, w->contact);
  if (Worst& first = report_.stepping.first;
      report_.stepping.periods > 0 && first.contact != SwitchGovernor::kNowhere)
    first.name = contactName(last.model, first.contact);
  RunTrust& trust = report_.trust;
  trust.omegaDt = speed_ > 0.0 ? std::sqrt(std::sqrt(curvature_ / speed_)) : 0.0;
  report_.warnings = warningsOf(report_, model_.length());
}

void RunWatch::archive(Archive& a) {
  a.section("watch");
  a(nextSample_), a(lastSample_), a(switches_), a(impacts_), a(smooth_);
  a(sampled_), a(unexplained_), a(sampledImpacts_), a(least_), a(leastOwn_), a(sinceLeast_);
  a(curvature_), a(speed_), a(increment_);
  if (increment_.size() != model_.topology().nu())
    throw ModelError("the checkpoint belongs to another model: it has " +
                     std::to_string(increment_.size()) + " velocities");
  a(inertia_), a(moves_), a(looks_), a(joints_);
}

}  // namespace dynamy
