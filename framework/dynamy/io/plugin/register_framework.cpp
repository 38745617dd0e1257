/// The types of the framework itself: schemes, solvers, impact laws. All other types come from
/// plug-ins, including the standard elements.

#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/located/event_driven.hpp>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/located/located_gragg.hpp>
#include <dynamy/schemes/anitescu_potra.hpp>
#include <dynamy/schemes/augmented_moreau.hpp>
#include <dynamy/schemes/constraint_index.hpp>
#include <dynamy/schemes/energy_momentum.hpp>
#include <dynamy/schemes/generalized_alpha.hpp>
#include <dynamy/schemes/ggl.hpp>
#include <dynamy/schemes/half_explicit_euler.hpp>
#include <dynamy/schemes/half_explicit_heun.hpp>
#include <dynamy/schemes/moreau_midpoint.hpp>
#include <dynamy/schemes/nonsmooth_rattle.hpp>
#include <dynamy/schemes/paoli_schatzman.hpp>
#include <dynamy/schemes/staggered_moreau.hpp>
#include <dynamy/schemes/stewart_trinkle.hpp>
#include <dynamy/schemes/theta_method.hpp>
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <dynamy/solver/impact/impact_law.hpp>
#include <dynamy/solver/impact/poisson_impact.hpp>
#include <dynamy/solver/impact/sequential_impact.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
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
