#include <algorithm>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/model/signal_binding.hpp>
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

/// The joints that can say what they leave free.
JointList jointsOf(const std::vector<std::unique_ptr<PartialMechanicalSystem>>& bodies,
                   const std::vector<std::unique_ptr<NonSmoothElement>>& contacts) {
  std::vector<const PartialMechanicalSystem*> systems;
  for (const auto& s : bodies) systems.push_back(s.get());
  Topology topology(systems);
  const auto nameOf = [&](int system) { return systems[static_cast<std::size_t>(system)]->name(); };
  JointList out;
  for (const auto& contact : contacts) {
    KnownJoint found{contact.get(), {}};
    try {
      if (!contact->jointMotion(topology, found.motion)) continue;
      const auto bodyA = nameOf(found.motion.systemA), bodyB = nameOf(found.motion.systemB);
      out.add(bodyA, bodyB, std::move(found));
    } catch (const ModelError&) {
      continue;  // connect() reports it with all other faults
    }
  }
  return out;
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
      choice_.name(as<OneStep>(std::move(element)));
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

void Model::solver(std::unique_ptr<InclusionSolver> solver) { solver_ = std::move(solver); }

std::vector<std::unique_ptr<PartialMechanicalSystem>> Model::takeSystems(
    const std::vector<int>& indices) {
  expects(topology_ == nullptr, "systems are taken before build() lays them out");
  std::vector<std::unique_ptr<PartialMechanicalSystem>> out;
  for (const int i : indices) out.push_back(std::move(systems_[static_cast<std::size_t>(i)]));
  systems_.erase(std::remove(systems_.begin(), systems_.end(), nullptr), systems_.end());
  return out;
}

const Element* Model::notMirrored(const MirrorPlane& plane) const {
  for (const auto& force : forces_)
    if (!force->isMirrored(plane)) return force.get();
  if (impactLaw_ != nullptr && !impactLaw_->isMirrored(plane)) return impactLaw_.get();
  return pairLaws_->notMirrored(plane);
}

void Model::addCompletion(Completion completion) { completions_.push_back(std::move(completion)); }

void Model::build() {
  expects(topology_ == nullptr, "build() is called once");
  composed.jointList = jointsOf(systems_, contacts_);
  for (const Completion& complete : completions_) complete(*this);
  for (const auto& f : forces_)
    if (auto states = f->ownSystem()) systems_.push_back(std::move(states));
  choice_.begin(simulation);
  if (!solver_) solver_ = makeDefault<Automatic>("Automatic");
  if (!impactLaw_) impactLaw_ = makeDefault<NewtonImpact>("NewtonImpact");
  std::vector<const PartialMechanicalSystem*> systems;
  for (const auto& s : systems_) systems.push_back(s.get());
  topology_ = std::make_unique<Topology>(systems, composed.jointList);
  connectAll();
  description_.describe(*this);
  bindSignals(*this);
}

void Model::connectAll() {
  Diagnostics faults;
  const auto guarded = [&](Element& e, auto&& connect) {
    topology_->noting().begin(&e);
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
  topology_->noting().begin(nullptr);
  faults.throwIfAny();
}

State Model::initialState() const {
  if (simulation.from) return *simulation.from;
  State x;
  x.q.setZero(topology_->nq());
  x.u.setZero(topology_->nu());
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    const SystemHandle& s = topology_->system(static_cast<int>(i));
    if (s.nq + s.nu > 0) systems_[i]->initialState(slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu));
  }
  const std::vector<double>& memory = topology_->memories().start();
  x.memory =
      Eigen::Map<const Eigen::VectorXd>(memory.data(), static_cast<Eigen::Index>(memory.size()));
  return x;
}

double gTolOf(const Model& model) {
  return model.simulation.gTol >= 0.0 ? model.simulation.gTol : 1e-12 * model.length();
}

MechanicalSystem Model::mechanicalSystem(const SystemSubset* some) {
  SystemParts parts;
  parts.topology = topology_.get();
  for (const auto& f : forces_) parts.forces.push_back(f.get());
  for (const auto& c : contacts_) parts.contacts.push_back(c.get());
  parts.impactLaw = impactLaw_.get();
  parts.subset = some;
  // Projections may need one slot more than the scheme.
  MechanicalSystem system(parts, std::max(2, scheme().evaluations()));
  system.gTol(gTolOf(*this));
  system.limits.length = length();
  return system;
}

}  // namespace dynamy
