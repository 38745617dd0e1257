/// The types that the framework itself brings: schemes, solvers, impact laws. All others come from
/// plug-ins, the standard ones too.

#include <dynamy/integrator/anitescu_potra.hpp>
#include <dynamy/integrator/augmented_moreau.hpp>
#include <dynamy/integrator/constraint_index.hpp>
#include <dynamy/integrator/energy_momentum.hpp>
#include <dynamy/integrator/event_driven.hpp>
#include <dynamy/integrator/generalized_alpha.hpp>
#include <dynamy/integrator/ggl.hpp>
#include <dynamy/integrator/half_explicit_euler.hpp>
#include <dynamy/integrator/half_explicit_heun.hpp>
#include <dynamy/integrator/located_dormand_prince.hpp>
#include <dynamy/integrator/located_gragg.hpp>
#include <dynamy/integrator/moreau_midpoint.hpp>
#include <dynamy/integrator/nonsmooth_rattle.hpp>
#include <dynamy/integrator/paoli_schatzman.hpp>
#include <dynamy/integrator/staggered_moreau.hpp>
#include <dynamy/integrator/stewart_trinkle.hpp>
#include <dynamy/integrator/theta_method.hpp>
#include <dynamy/io/registry.hpp>
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <dynamy/solver/impact_law.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
#include <dynamy/solver/poisson_impact.hpp>
#include <dynamy/solver/prox_block_metric.hpp>
#include <dynamy/solver/prox_solvers.hpp>
#include <dynamy/solver/proximal_newton.hpp>
#include <dynamy/solver/semismooth_newton.hpp>
#include <dynamy/solver/sequential_impact.hpp>
#include <dynamy/solver/successive_laws.hpp>

namespace dynamy {

void registerFramework(Registry& registry) {
  registry.library("dynamy");
  registry.add<MoreauMidpoint>("MoreauMidpoint");
  registry.add<HalfExplicitEuler>("HalfExplicitEuler");
  registry.add<EnergyMomentum>("EnergyMomentum");
  registry.add<StaggeredMoreau>("StaggeredMoreau");
  registry.add<AugmentedMoreau>("AugmentedMoreau");
  registry.add<StewartTrinkle>("StewartTrinkle");
  registry.add<AnitescuPotra>("AnitescuPotra");
  registry.add<PaoliSchatzman>("PaoliSchatzman");
  registry.add<ThetaMethod>("ThetaMethod");
  registry.add<NonsmoothRattle>("NonsmoothRattle");
  registry.add<GeneralizedAlpha>("GeneralizedAlpha");
  registry.add<HalfExplicitHeun>("HalfExplicitHeun");
  registry.add<LocatedDormandPrince>("LocatedDormandPrince");
  registry.add<LocatedGragg>("LocatedGragg");
  registry.add<EventDriven>("EventDriven");
  registry.add<ConstraintIndex>("ConstraintIndex");
  registry.add<Ggl>("Ggl");
  registry.add<Admm>("Admm");
  registry.add<Automatic>("Automatic");
  registry.add<BlockGaussSeidel>("BlockGaussSeidel");
  registry.add<ProxGaussSeidel>("ProxGaussSeidel");
  registry.add<ProxJacobi>("ProxJacobi");
  registry.add<PackedGaussSeidel>("PackedGaussSeidel");
  registry.add<ProximalNewton>("ProximalNewton");
  registry.add<SemismoothNewton>("SemismoothNewton");
  registry.add<LemkeSolver>("Lemke");
  registry.add<ProxBlockMetric>("ProxBlockMetric");
  registry.add<SuccessiveLaws>("SuccessiveLaws");
  registry.add<NewtonImpact>("NewtonImpact");
  registry.add<PoissonImpact>("PoissonImpact");
  registry.add<EnergeticImpact>("EnergeticImpact");
  registry.add<SequentialImpact>("SequentialImpact");
}

}  // namespace dynamy
