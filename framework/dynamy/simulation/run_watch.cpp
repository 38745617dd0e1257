#include <algorithm>
#include <cmath>
#include <dynamy/simulation/contact_facts.hpp>
#include <dynamy/simulation/run_watch.hpp>
#include <limits>
#include <map>

namespace dynamy {
namespace {

constexpr double kPotential = 1e-9;  ///< of V, the least that energies are compared with
constexpr double kSamples = 256.0;   ///< of the energy in a run
/// After the first steps three in a row of so many are looked at, so that watching costs little.
constexpr long kFirst = 256, kEvery = 16;

/// Smallest extent along an axis [m]; infinite for what is flat: nothing passes the ground.
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
      ends_(model.mechanicalSystem()),
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
  // Two points never touch; of the others the smallest of another system decides.
  std::sort(shapes.begin(), shapes.end(),
            [](const Sized& a, const Sized& b) { return a.size < b.size; });
  const std::vector<std::pair<int, int>>& asked = model.topology().requestedFrames();
  std::map<std::pair<int, int>, int> frames;
  for (std::size_t i = 0; i < asked.size(); ++i) frames.emplace(asked[i], static_cast<int>(i));
  for (const Sized& a : shapes) {
    const auto partner = std::find_if(shapes.begin(), shapes.end(), [&](const Sized& b) {
      const bool many = model.topology().system(b.system).blocks > 1;
      const bool another = b.system != a.system || (many && b.frame != a.frame);
      return another && a.size + b.size > 0.0;
    });
    const auto at = frames.find({a.system, a.frame});
    if (partner == shapes.end() || at == frames.end()) continue;
    const double size = a.size + partner->size;
    if (std::isfinite(size)) movers_.push_back({{at->second}, size});
  }
}

void RunWatch::start(const StepView& initial) {
  sample(initial);
  positions(initial.after);  // bodies may overlap as the model puts them
}

void RunWatch::step(const StepView& view) {
  // Steps that a scheme chooses resolve the motion by their own measure.
  if (!view.scheme.choosesSteps() && (view.index <= kFirst || view.index % kEvery < 3)) {
    travel(view);
    resolution(view);
  } else {
    smooth_ = -1;
  }
  if (view.after.t >= nextSample_) sample(view);
}

void RunWatch::sample(const StepView& view) {
  if (view.after.t == lastSample_) return;
  lastSample_ = view.after.t;
  nextSample_ = view.after.t + sampleEvery_;
  energy(view);
  // Overlaps are seen by every step; joints are held where the step does not see them.
  const std::vector<const SetValuedForceLaw*>& laws = view.system.slot(0).contacts.law;
  if (std::any_of(laws.begin(), laws.end(), [](const auto* law) { return !law->unilateral(); }))
    positions(view.after);
}

void RunWatch::positions(const State& x) {
  const ContactSet& c = ends_.evaluate(x).contacts;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    const int closed = c.closedIndex[i];
    const SetValuedForceLaw* law = closed >= 0 ? c.law[static_cast<std::size_t>(closed)] : nullptr;
    const bool joint = law != nullptr && !law->unilateral();
    if (joint && law->rowKind(0) != RowKind::joint) continue;  // friction and springs have no error
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
  // Without steps of given length: what rounding leaves of potential energies.
  if (view.scheme.choosesSteps())
    trust.stepEnergy = std::max(trust.stepEnergy, kPotential * std::abs(e.potentialEnd));
  const double rise = e.end() - e.start() - e.nonPotential - e.boundaries;
  if (rise > trust.energyRise) trust.energyRise = rise, trust.energyRiseTime = view.after.t;
}

void RunWatch::resolution(const StepView& view) {
  const Evaluation& e = view.system.slot(0);
  const double dt = view.report.dt;
  // Energy that the forces alone would give in one step: the floor of the energies at rest.
  before_ = view.after.u - view.before.u;
  e.mass.applyInverse(dynamy::view(e.h), dynamy::view(momentum_));
  const double force = dt * dt * e.h.dot(momentum_);
  report_.trust.stepEnergy = std::max(report_.trust.stepEnergy, 0.5 * force);
  if (momentum_.size() > 0)
    report_.trust.fall =
        std::max(report_.trust.fall, 0.5 * dt * dt * momentum_.cwiseAbs().maxCoeff());
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
  // Systems without frames tell by their contacts how fast they come.
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
  for (Worst* w : {&report_.residual, &report_.penetration, &report_.jointError})
    if (w->value > 0.0) w->name = contactName(last.model, w->contact);
  if (Worst& first = report_.stepping.first; first.contact.value != 0)
    first.name = contactName(last.model, first.contact);
  RunTrust& trust = report_.trust;
  trust.omegaDt = speed_ > 0.0 ? std::sqrt(std::sqrt(curvature_ / speed_)) : 0.0;
  report_.warnings = warningsOf(report_, model_.length());
}

void RunWatch::archive(Archive& a) {
  a.section("watch");
  a(nextSample_), a(lastSample_), a(switches_), a(impacts_), a(smooth_);
  a(sampled_), a(unexplained_), a(sampledImpacts_);
  a(curvature_), a(speed_), a(increment_);
  if (increment_.size() != model_.topology().nu())
    throw ModelError("the checkpoint belongs to another model: it has " +
                     std::to_string(increment_.size()) + " velocities");
}

}  // namespace dynamy
