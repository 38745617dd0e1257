/// The types that the framework itself brings: laws, rules between materials, schemes, solvers,
/// impact laws. Systems, forces, joints and shapes come from plug-ins, the standard ones too.

#include <dynamy/contact/contact_rule.hpp>
#include <dynamy/contact/standard_laws.hpp>
#include <dynamy/integrator/half_explicit_euler.hpp>
#include <dynamy/integrator/moreau_midpoint.hpp>
#include <dynamy/io/registry.hpp>
#include <dynamy/solver/impact_law.hpp>
#include <dynamy/solver/prox_solvers.hpp>
#include <dynamy/solver/proximal_newton.hpp>

namespace dynamy {

void registerFramework(Registry& registry) {
  registry.library("dynamy");
  registry.add<Bilateral>("Bilateral");
  registry.add<Unilateral>("Unilateral");
  registry.add<UnilateralCoulomb>("UnilateralCoulomb");
  registry.add<GivenFriction>("GivenFriction");
  registry.add<ContactRule>("Contact");
  registry.add<NoContactRule>("NoContact");
  registry.add<MoreauMidpoint>("MoreauMidpoint");
  registry.add<HalfExplicitEuler>("HalfExplicitEuler");
  registry.add<ProxGaussSeidel>("ProxGaussSeidel");
  registry.add<ProxJacobi>("ProxJacobi");
  registry.add<ProximalNewton>("ProximalNewton");
  registry.add<NewtonImpact>("NewtonImpact");
}

}  // namespace dynamy
