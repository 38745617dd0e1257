// The standard elements, registered like any plug-in's.
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/law/material.hpp>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/blocks/formula_block.hpp>
#include <dynamy_elements/blocks/input.hpp>
#include <dynamy_elements/blocks/lookup_table.hpp>
#include <dynamy_elements/blocks/sampled_blocks.hpp>
#include <dynamy_elements/blocks/state_blocks.hpp>
#include <dynamy_elements/blocks/state_machine.hpp>
#include <dynamy_elements/bodies/grains.hpp>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>
#include <dynamy_elements/bodies/point_mass.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>
#include <dynamy_elements/contacts/shapes/contour_shape.hpp>
#include <dynamy_elements/contacts/shapes/faceted_shapes.hpp>
#include <dynamy_elements/contacts/shapes/round_shapes.hpp>
#include <dynamy_elements/contacts/shapes/shapes.hpp>
#include <dynamy_elements/coordinates/register_coordinates.hpp>
#include <dynamy_elements/forces/bushing.hpp>
#include <dynamy_elements/forces/drag.hpp>
#include <dynamy_elements/forces/elastic_rope.hpp>
#include <dynamy_elements/forces/force_input.hpp>
#include <dynamy_elements/forces/gravity.hpp>
#include <dynamy_elements/forces/springs.hpp>
#include <dynamy_elements/forces/tyre.hpp>
#include <dynamy_elements/joints/register_joints.hpp>
#include <dynamy_elements/joints/sheave_rope.hpp>
#include <dynamy_elements/laws/adhesion.hpp>
#include <dynamy_elements/laws/belt_friction.hpp>
#include <dynamy_elements/laws/drilling_friction.hpp>
#include <dynamy_elements/laws/force_limit.hpp>
#include <dynamy_elements/laws/orthotropic_friction.hpp>
#include <dynamy_elements/laws/preloaded_spring.hpp>
#include <dynamy_elements/laws/stribeck_friction.hpp>
#include <dynamy_elements/trees/compose_trees.hpp>
#include <dynamy_elements/trees/plane_choice.hpp>

#include <dynamy_elements/standard_elements.hpp>

namespace dynamy {
namespace {

void registerShapes(Registry& r) {
  r.add<Sphere>("Sphere");
  r.add<Box>("Box");
  r.add<HalfSpace>("HalfSpace");
  r.add<PointShape>("Point");
  r.add<LineShape>("Line");
  r.add<PolygonShape>("Polygon");
  r.add<CircleShape>("Circle");
  r.add<ContourShape>("Contour");
  r.add<BoreShape>("Bore");
  r.add<CylinderShape>("Cylinder");
  r.add<CapsuleShape>("Capsule");
  r.add<ConeShape>("Cone");
  r.add<TorusShape>("Torus");
  r.add<EllipsoidShape>("Ellipsoid");
  r.add<PolyhedronShape>("Polyhedron");
  r.add<MeshShape>("Mesh");
  r.add<HeightFieldShape>("HeightField");
}

void registerBlocks(Registry& r) {
  r.add<Input>("Input");
  r.add<Sample>("Sample");
  r.add<Delay>("Delay");
  r.add<Pid>("Pid");
  r.add<Integrator>("Integrator");
  r.add<Filter>("Filter");
  r.add<TransferFunction>("TransferFunction");
  r.add<ContinuousPid>("ContinuousPid");
  r.add<FormulaBlock>("Formula");
  r.add<Noise>("Noise");
  r.add<StateMachine>("StateMachine");
  r.add<Transition>("Transition");
  r.add<LookupTable>("Table");
}

void registerLaws(Registry& r) {
  r.add<Unilateral>("Unilateral");
  r.add<UnilateralCoulomb>("UnilateralCoulomb");
  r.add<Bilateral>("Bilateral");
  r.add<GivenFriction>("GivenFriction");
  r.add<ForceLimit>("ForceLimit");
  r.add<OneWayClutch>("OneWayClutch");
  r.add<PreloadedSpring>("PreloadedSpring");
  r.add<StribeckFriction>("StribeckFriction");
  r.add<UnilateralStribeck>("UnilateralStribeck");
  r.add<UnilateralAdhesion>("UnilateralAdhesion");
  r.add<BeltFriction>("BeltFriction");
  r.add<UnilateralOrthotropic>("UnilateralOrthotropic");
  r.add<UnilateralDrilling>("UnilateralDrilling");
  r.add<UnilateralRolling>("UnilateralRolling");
}

void registerElements(Registry& r) {
  r.add<Ground>("Ground");
  r.add<PointMass>("PointMass");
  r.add<PlanarBody>("PlanarBody");
  r.add<RigidBody>("RigidBody");
  r.add<Grains>("Grains");
  r.add<NamedFrame>("Frame");

  registerShapes(r);

  r.add<Gravity>("Gravity");
  r.add<SpringDamper>("SpringDamper");
  r.add<TorsionSpring>("TorsionSpring");
  r.add<ForceInput>("ForceInput");
  r.add<Bushing>("Bushing");
  r.add<Drag>("Drag");
  r.add<Tyre>("Tyre");
  r.add<ElasticRope>("ElasticRope");
  r.add<Sheave>("Sheave");

  registerBlocks(r);

  registerJoints(r);
  r.add<SheaveRope>("SheaveRope");

  registerLaws(r);
  r.add<ContactRule>("Contact");
  r.add<NoContactRule>("NoContact");
  r.add<Material>("Material");
  r.add<MixingRule>("Contacts");
  registerCoordinates(r);
  r.addCompletion(flattenBodies);
  r.addCompletion(composeTrees);
  r.addCompletion(addShapeContacts);
}

}  // namespace

void completeStandardElements(Model& model) {
  model.addCompletion(flattenBodies);
  model.addCompletion(composeTrees);
  model.addCompletion(addShapeContacts);
}

}  // namespace dynamy

DYNAMY_PLUGIN("dynamy_elements", dynamy::kVersionText, dynamy::registerElements)
