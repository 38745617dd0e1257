/// Model: owner of all elements of a scene, made from XML (io/model/model_loader) or in C++:
///
///   Model m;
///   m.add<RigidBody>("ball", {{"position", {0, 0, 1}}},
///                    child<Sphere>({{"radius", 0.1}, {"density", 1000.0}}));
///   m.simulation.until = 5, m.simulation.tolerance = 1e-6;
///   m.build();
///
/// (a whole program: doc/cpp_models.md)
///
/// build() runs the completions, lays out q and u, connects the elements and asks each of them to
/// describe itself. After that the model is immutable.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/simulation/model/composition.hpp>
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/model/scene_description.hpp>
#include <dynamy/simulation/model/scheme_choice.hpp>
#include <dynamy/system/external_force.hpp>
#include <functional>
#include <map>
#include <memory>

namespace dynamy {

class PairLaws;

/// The file that a model was made from.
struct ModelFile {
  std::string name;  ///< empty: none
  std::string text;  ///< as in the file
};

/// Makes a T that belongs to another element, e.g. a shape of a body or the law of a contact, from
/// its declared attributes. Throws ModelError.
template <class T>
std::unique_ptr<T> child(const std::vector<GivenValue>& given = {}) {
  return std::make_unique<T>(Parameters::of<T>({}, {}, given));
}

class Model {
 public:
  using Completion = std::function<void(Model&)>;
  Model();
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  /// Adds an element to the list of its kind. Names must be unique among systems, contacts, forces
  /// and observers.
  void add(Kind kind, std::unique_ptr<Element> element);
  template <class T>
  T& add(std::unique_ptr<T> element) {
    T& out = *element;
    add(T::kKind, std::move(element));
    return out;
  }
  /// Makes a T from its declared attributes and its children. Throws ModelError.
  template <class T, class... Children>
  T& add(const std::string& name, const std::vector<GivenValue>& given,
         std::unique_ptr<Children>... children) {
    Parameters x = Parameters::of<T>({}, name, given);
    (x.children.push_back({Children::kKind, std::move(children)}), ...);
    return add(std::make_unique<T>(x));
  }
  /// For completions: removes systems from the model and returns them, e.g. to combine them into
  /// one; `indices` are ascending.
  std::vector<std::unique_ptr<PartialMechanicalSystem>> takeSystems(
      const std::vector<int>& indices);
  /// For completions: puts what `make` makes of system i in its place.
  template <class Make>
  void replaceSystem(int i, const Make& make) {
    std::unique_ptr<PartialMechanicalSystem>& system = systems_[static_cast<std::size_t>(i)];
    system = make(std::move(system));
  }
  /// Adds a function that build() calls first. It adds the elements that follow from others, e.g.
  /// contact geometry from shapes.
  void addCompletion(Completion completion);
  /// Runs the completions, lays out q and u, connects and describes the elements. Throws ModelError
  /// with all faults found.
  void build();

  // Before build().
  SimulationSettings simulation;
  RecordSettings record;
  std::vector<CheckSettings> checks;
  ModelFile file;
  std::string title, doc;
  Composition composed;  ///< its joints, and what completions made of them
  std::string view;      ///< of the replay: "xy" "xz" "yz" "iso" or empty (chosen)

  // After build().
  Topology& topology() { return *topology_; }
  const Topology& topology() const { return *topology_; }
  const std::vector<std::unique_ptr<PartialMechanicalSystem>>& systems() const { return systems_; }
  const std::vector<std::unique_ptr<NonSmoothElement>>& contacts() const { return contacts_; }
  const std::vector<std::unique_ptr<ExternalForce>>& forces() const { return forces_; }
  /// The rules that give each pair of materials its law.
  PairLaws& pairLaws() { return *pairLaws_; }
  const PairLaws& pairLaws() const { return *pairLaws_; }
  const std::vector<std::unique_ptr<Observer>>& observers() const { return observers_; }
  /// Descriptions of the systems, then of the contact elements, then of the forces. Their signals
  /// are moved to signals().
  const std::vector<Description>& descriptions() const { return description_.elements(); }
  const Description& description(int system) const {
    return description_.elements()[static_cast<std::size_t>(system)];
  }
  const std::vector<NamedSignal>& signals() const { return description_.signals(); }
  const NamedSignal* signal(std::string_view name) const { return description_.signal(name); }
  OneStep& scheme() { return choice_.scheme(); }
  const OneStep& scheme() const { return choice_.scheme(); }
  const InclusionSolver& solver() const { return *solver_; }
  InclusionSolver& solver() { return *solver_; }
  void scheme(std::unique_ptr<OneStep> scheme) { choice_.name(std::move(scheme)); }
  /// Asks for steps of length dt [s] in place of a tolerance. An explicitly named scheme that
  /// chooses its steps keeps its tolerance and takes dt as its longest step.
  void askStep(double dt) { choice_.askStep(dt, simulation); }
  /// Asks for a tolerance in place of a step: LocatedDormandPrince replaces a scheme of fixed
  /// steps.
  void askTolerance(double tolerance) { choice_.askTolerance(tolerance, simulation); }
  /// True: the program chooses the steps. Known before build(), too.
  bool runsToTolerance() const { return choice_.runsToTolerance(simulation); }
  /// True: the model names no scheme, so that the program chose it.
  bool schemeIsDefault() const { return choice_.isDefault(); }
  /// Called at the start of a run. If no scheme was named, chooses one by whether `simulation` has
  /// a tolerance or a step. Passes the accuracy to a scheme that works to a tolerance.
  void readyScheme() { choice_.ready(length(), simulation); }
  void solver(std::unique_ptr<InclusionSolver> solver);
  const ImpactLaw& impactLaw() const { return *impactLaw_; }
  /// The first of forces, rules of materials and the impact law that is not its own mirror image
  /// (Element::isMirrored); null: all are. Before build().
  const Element* notMirrored(const MirrorPlane& plane) const;
  /// Of the systems, or `simulation.from`.
  State initialState() const;
  /// Length of the scene [m]: extent of initial frame positions and shapes, at least 1e-6; 1 if
  /// there is nothing to measure.
  double length() const { return description_.length(); }
  /// The stages of a step of this model, or of a view on some of its systems, which is borrowed.
  MechanicalSystem mechanicalSystem(const SystemSubset* some = nullptr);

 private:
  void connectAll();
  std::vector<std::unique_ptr<PartialMechanicalSystem>> systems_;
  std::vector<std::unique_ptr<NonSmoothElement>> contacts_;
  std::vector<std::unique_ptr<ExternalForce>> forces_;
  std::unique_ptr<PairLaws> pairLaws_;
  std::vector<std::unique_ptr<Observer>> observers_;
  std::vector<std::unique_ptr<Element>> others_;
  SchemeChoice choice_;
  std::unique_ptr<InclusionSolver> solver_;
  std::unique_ptr<ImpactLaw> impactLaw_;
  std::unique_ptr<Topology> topology_;
  SceneDescription description_;
  std::vector<Completion> completions_;
};

/// Gap up to which a contact of the model is closed [m]: that of its settings, else 1e-12 lengths.
double gTolOf(const Model& model);

}  // namespace dynamy
