#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/schemes/energy_momentum.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/solver/automatic.hpp>

namespace dynamy {
namespace {

template <class T>
std::unique_ptr<T> as(std::unique_ptr<Element> element) {
  return std::unique_ptr<T>(static_cast<T*>(element.release()));  // the kind fixes the base class
}

/// Makes a T with its declared defaults, and with a type name that reports can show.
template <class T>
std::unique_ptr<T> makeDefault(const char* type) {
  return std::make_unique<T>(Parameters::of<T>(type, "", {}));
}

/// True if the scheme works to a tolerance. AugmentedMoreau does not: it locates switches within
/// steps of given length.
bool takesTolerance(const OneStep& scheme) { return scheme.choosesSteps() && !scheme.needsStep(); }

/// Throws ModelError if steps are so short that t + Δt rounds to t: such a run never ends. A step
/// that is halved six times, because it is not solved, must still change t.
void refuseStepsWithoutWay(const SimulationSettings& s) {
  const double least = 64.0 * kEpsilon * s.until;
  if (!(s.step > 0.0) || s.step >= least) return;
  throw ModelError(Diagnostic{
      .place = s.place,
      .element = std::string(s.place.line == 0 ? "" : "simulation"),
      .text = fmt::format("a step of {} s does not move t near {} s, where the run ends", s.step,
                          s.until),
      .hint = fmt::format(
          "take a step of {:.1g} s or more; with a tolerance the program chooses the steps",
          2.0 * least)});
}

}  // namespace

Model::Model() : pairLaws_(std::make_unique<PairLaws>()) {}
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

void Model::add(Kind kind, std::unique_ptr<Element> element) {
  expects(topology_ == nullptr, "elements are added before build()");
  switch (kind) {
    case Kind::system:
      systems_.push_back(as<PartialMechanicalSystem>(std::move(element)));
      break;
    case Kind::contact:
      contacts_.push_back(as<NonSmoothElement>(std::move(element)));
      break;
    case Kind::force:
      forces_.push_back(as<ExternalForce>(std::move(element)));
      break;
    case Kind::rule:
      pairLaws_->add(as<MaterialRule>(std::move(element)));
      break;
    case Kind::observer:
      observers_.push_back(as<Observer>(std::move(element)));
      break;
    case Kind::scheme:
      scheme_ = as<OneStep>(std::move(element));
      break;
    case Kind::solver:
      solver_ = as<InclusionSolver>(std::move(element));
      break;
    case Kind::impact:
      impactLaw_ = as<ImpactLaw>(std::move(element));
      break;
    default:
      others_.push_back(std::move(element));
  }
}

void Model::scheme(std::unique_ptr<OneStep> scheme) {
  scheme_ = std::move(scheme), schemeIsDefault_ = false;
}
void Model::solver(std::unique_ptr<InclusionSolver> solver) { solver_ = std::move(solver); }

std::vector<std::unique_ptr<PartialMechanicalSystem>> Model::takeSystems(
    const std::vector<int>& indices) {
  expects(topology_ == nullptr, "systems are taken before build() lays them out");
  std::vector<std::unique_ptr<PartialMechanicalSystem>> out;
  for (const int i : indices) out.push_back(std::move(systems_[static_cast<std::size_t>(i)]));
  systems_.erase(std::remove(systems_.begin(), systems_.end(), nullptr), systems_.end());
  return out;
}

void Model::addCompletion(Completion completion) { completions_.push_back(std::move(completion)); }

void Model::chooseScheme() {
  if (!schemeIsDefault_) return;
  const bool own = simulation.tolerance > 0.0;
  if (scheme_ && takesTolerance(*scheme_) == own) return;
  if (own)
    scheme_ = makeDefault<LocatedDormandPrince>("LocatedDormandPrince");
  else
    scheme_ = makeDefault<EnergyMomentum>("EnergyMomentum");
}

void Model::askStep(double dt) {
  const bool longest = scheme_ && scheme_->choosesSteps() && !schemeIsDefault_;
  simulation.step = dt;
  if (!longest) simulation.tolerance = 0.0;
  chooseScheme();
}

void Model::askTolerance(double tolerance) {
  simulation.tolerance = tolerance, simulation.step = 0.0;
  if (scheme_ && !takesTolerance(*scheme_)) schemeIsDefault_ = true;
  chooseScheme();
}

void Model::readyScheme() {
  refuseStepsWithoutWay(simulation);
  chooseScheme();
  if (!takesTolerance(*scheme_)) return;
  if (!(simulation.tolerance > 0.0)) simulation.tolerance = Accuracy{}.tolerance;
  scheme_->aim({simulation.tolerance, length_});
}

void Model::build() {
  expects(topology_ == nullptr, "build() is called once");
  for (const Completion& complete : completions_) complete(*this);
  schemeIsDefault_ = !scheme_;
  chooseScheme();
  if (!solver_) solver_ = makeDefault<Automatic>("Automatic");
  if (!impactLaw_) impactLaw_ = makeDefault<NewtonImpact>("NewtonImpact");
  std::vector<const PartialMechanicalSystem*> systems;
  for (const auto& s : systems_) systems.push_back(s.get());
  topology_ = std::make_unique<Topology>(systems);
  connectAll();
  describeAll();
  measure();
}

void Model::connectAll() {
  Diagnostics faults;
  const auto guarded = [&](Element& e, auto&& connect) {
    topology_->connecting(&e);
    try {
      connect();
    } catch (const ModelError& error) {
      for (Diagnostic d : error.diagnostics()) {
        if (d.place.line == 0) d.place = e.place();
        if (d.element.empty())
          d.element = e.type() + (e.name().empty() ? "" : " name=\"" + e.name() + "\"");
        faults.add(d);
      }
    }
  };
  for (const auto& f : forces_) guarded(*f, [&] { f->connect(*topology_); });
  for (const auto& c : contacts_) guarded(*c, [&] { c->connect(*topology_); });
  topology_->connecting(nullptr);
  faults.throwIfAny();
}

void Model::describeAll() {
  const auto take = [&](const Element& e, int system, int contact) {
    Description d;
    e.describe(d);
    for (Signal& s : d.signals) {
      NamedSignal named;
      named.name = e.name().empty() ? s.name : e.name() + "." + s.name;
      named.signal = std::move(s);
      named.system = system, named.contact = contact;
      const MemoryHandle memory = topology_->memoryOf(e);
      named.memory0 = memory.first, named.memory = memory.size;
      signals_.push_back(std::move(named));
    }
    d.signals.clear(), d.signals.shrink_to_fit();  // one copy is enough for 10⁵ bodies
    descriptions_.push_back(std::move(d));
  };
  for (std::size_t i = 0; i < systems_.size(); ++i) take(*systems_[i], static_cast<int>(i), -1);
  for (std::size_t i = 0; i < contacts_.size(); ++i) take(*contacts_[i], -1, static_cast<int>(i));
  for (const auto& f : forces_) take(*f, -1, -1);
}

void Model::measure() {
  // Extent of all frames at the start plus the sizes of the shapes on them.
  Topology all(topology_->systems());
  for (std::size_t i = 0; i < systems_.size(); ++i)
    for (int f = 0; f < systems_[i]->frames(); ++f) all.frame(all.system(static_cast<int>(i)), f);
  Kinematics k;
  k.resize(all);
  const State x = initialState();
  k.evaluate(all, x.t, {x.q.data(), x.q.size()}, {x.u.data(), x.u.size()});
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  double largest = 0.0;
  for (std::size_t i = 0; i < all.requestedFrames().size(); ++i) {
    low = low.cwiseMin(k.frame({static_cast<int>(i)}).r_OS_I);
    high = high.cwiseMax(k.frame({static_cast<int>(i)}).r_OS_I);
  }
  for (std::size_t i = 0; i < systems_.size(); ++i)
    for (const PlacedShape& p : descriptions_[i].shapes) {
      const ShapeGeometry g = p.shape->geometry();
      if (g.type == "HalfSpace") continue;
      for (const double size : g.size) largest = std::max(largest, std::abs(size));
      for (const Vec3& point : g.points) largest = std::max(largest, point.norm());
    }
  if (!all.requestedFrames().empty()) largest = std::max(largest, (high - low).maxCoeff());
  length_ = largest > 0.0 && std::isfinite(largest) ? std::max(largest, 1e-6) : 1.0;
}

const NamedSignal* Model::signal(std::string_view name) const {
  for (const NamedSignal& s : signals_)
    if (s.name == name) return &s;
  return nullptr;
}

State Model::initialState() const {
  State x;
  x.q.setZero(topology_->nq());
  x.u.setZero(topology_->nu());
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    const SystemHandle& s = topology_->system(static_cast<int>(i));
    if (s.nq + s.nu > 0) systems_[i]->initialState(slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu));
  }
  const std::vector<double>& memory = topology_->memoryStart();
  x.memory =
      Eigen::Map<const Eigen::VectorXd>(memory.data(), static_cast<Eigen::Index>(memory.size()));
  return x;
}

MechanicalSystem Model::mechanicalSystem() {
  SystemParts parts;
  parts.topology = topology_.get();
  for (const auto& f : forces_) parts.forces.push_back(f.get());
  for (const auto& c : contacts_) parts.contacts.push_back(c.get());
  parts.impactLaw = impactLaw_.get();
  // Projections may need one slot more than the scheme.
  MechanicalSystem system(parts, std::max(2, scheme_->evaluations()));
  system.gTol(simulation.gTol >= 0.0 ? simulation.gTol : 1e-12 * length_);
  return system;
}

}  // namespace dynamy
