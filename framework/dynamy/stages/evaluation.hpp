/// Evaluation: everything evaluated at one (t, q, u). EvaluationRequest: what an evaluation is to
/// contain, beside M and h.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/solver/impact/impact_law.hpp>
#include <dynamy/stages/stiff_part.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/state.hpp>
#include <optional>

namespace dynamy {

class BiasDifferences;

/// One slot: frames, M, h and contacts at one (t, q, u).
struct Evaluation {
  double t = 0.0;
  Kinematics kinematics;
  MassMatrix mass;
  Eigen::VectorXd h, hNonPotential;
  ContactSet contacts;
  std::uint64_t subset = 0;  ///< stamp of the subset outside of which h is zero; 0: none
};

/// The parts of a model in the order of their indices; borrowed. A view on some systems has the same
/// parts and a subset: what it evaluates outside of the subset is zero, and frames are absent or rest.
/// Where the subset omits others, the topology is one of its systems alone.
/// Schemes that take forces at the end of a step need the whole system, or a view beside which all
/// others rest (std::logic_error).
struct SystemParts {
  Topology* topology = nullptr;
  std::vector<const ExternalForce*> forces;
  std::vector<const NonSmoothElement*> contacts;
  const ImpactLaw* impactLaw = nullptr;
  const SystemSubset* subset = nullptr;  ///< null: all systems. Its owner may change it.

  /// Number in the topology of a frame that an element requested; −1: there is no room for it.
  int numberOf(FrameHandle f) const {
    const OwnNumbers* own = subset != nullptr ? subset->own() : nullptr;
    return own != nullptr ? own->of(f) : f.index;
  }
  /// Calls f(i) for the index of each system, force or contact element that takes part.
  template <class F>
  void forSystems(F&& f) const {
    const bool some = subset != nullptr && subset->own() == nullptr;
    each(some ? &subset->systems() : nullptr, topology->systems().size(), f);
  }
  template <class F>
  void forForces(F&& f) const {
    each(subset ? &subset->forces() : nullptr, forces.size(), f);
  }
  template <class F>
  void forContacts(F&& f) const {
    each(subset ? &subset->contacts() : nullptr, contacts.size(), f);
  }

 private:
  template <class F>
  static void each(const std::vector<int>* some, std::size_t all, F&& f) {
    if (some)
      for (const int i : *some) f(static_cast<std::size_t>(i));
    else
      for (std::size_t i = 0; i < all; ++i) f(i);
  }
};

/// Contacts that are requested by key: exactly these count as closed, whatever their gap.
struct HeldContacts {
  std::span<const ContactKey> keys{};  ///< ascending; borrowed
  bool follow = false;                 ///< with pairs of features one by one (ContactRequest)
  bool alone = false;                  ///< the others need not be reported
  const NearContacts* near = nullptr;  ///< with follow: as ContactRequest::near; borrowed
};

/// What one evaluation requests. The default: M, h and the closed contacts, g ≤ g_tol, in slot 0.
struct EvaluationRequest {
  int slot = 0;
  double reach = 0.0;  ///< contacts with g ≤ g_tol + reach count as closed [m]
  /// Above 0: contacts that may close within this time count as closed [s]. The reach is twice the
  /// way that the fastest block goes with |u| + Δt|M⁻¹h|, angles as lengths.
  double ahead = 0.0;
  std::optional<HeldContacts> held{};
  bool bias = false;                       ///< fill γ̇ − Wᵀu̇ of the closed contacts
  BiasDifferences* differences = nullptr;  ///< with bias: of elements that report none
  std::span<const char> elements{};  ///< only contacts of elements with a 1, by index; empty: all
  std::span<const char> withheld{};  ///< forces with a 1, by index, are left out of h; empty: none
  /// With `ahead`, in slot 0: forces with derivatives that the step does not resolve
  /// (UnresolvedForces) are taken at the end of the step by the implicit Euler rule, in the reach
  /// and in the next impactProblem. Oscillations faster than steps can resolve then come to rest
  /// instead of growing. If there are such forces, declared stiff ones get these weights.
  const ImplicitWeights* damped = nullptr;
  /// With `ahead`, in slot 0: gyroscopic terms in h are those at the mean velocity of the step, see
  /// PartialMechanicalSystem::gyroscopicAtMean.
  bool gyroscopicAtMean = false;
};

/// What elements are asked for by such a request.
ContactRequest contactRequest(const EvaluationRequest& request, double gTol);

/// Reports the contacts of all elements that take part.
/// `only`: restricts this to the elements with a 1, by their index; empty: all elements.
void reportContacts(const SystemParts& parts, const Kinematics& k, ContactSink& sink,
                    std::span<const char> only = {});

}  // namespace dynamy
