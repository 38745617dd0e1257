/// The types that the framework itself brings: schemes, solvers, impact laws. All others come from
/// plug-ins, the standard ones too.

#include <dynamy/integrator/energy_momentum.hpp>
#include <dynamy/integrator/half_explicit_euler.hpp>
#include <dynamy/integrator/moreau_midpoint.hpp>
#include <dynamy/integrator/staggered_moreau.hpp>
#include <dynamy/io/registry.hpp>
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/impact_law.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/prox_block_metric.hpp>
#include <dynamy/solver/prox_solvers.hpp>
#include <dynamy/solver/proximal_newton.hpp>
#include <dynamy/solver/semismooth_newton.hpp>
#include <dynamy/solver/successive_laws.hpp>

namespace dynamy {

void registerFramework(Registry& registry) {
  registry.library("dynamy");
  registry.add<MoreauMidpoint>("MoreauMidpoint");
  registry.add<HalfExplicitEuler>("HalfExplicitEuler");
  registry.add<EnergyMomentum>("EnergyMomentum");
  registry.add<StaggeredMoreau>("StaggeredMoreau");
  registry.add<Admm>("Admm");
  registry.add<Automatic>("Automatic");
  registry.add<ProxGaussSeidel>("ProxGaussSeidel");
  registry.add<ProxJacobi>("ProxJacobi");
  registry.add<ProximalNewton>("ProximalNewton");
  registry.add<SemismoothNewton>("SemismoothNewton");
  registry.add<LemkeSolver>("Lemke");
  registry.add<ProxBlockMetric>("ProxBlockMetric");
  registry.add<SuccessiveLaws>("SuccessiveLaws");
  registry.add<NewtonImpact>("NewtonImpact");
}

}  // namespace dynamy
