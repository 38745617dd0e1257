#include <dynamy_elements/joints/coordinate_forces.hpp>
#include <dynamy_elements/joints/coordinate_laws.hpp>
#include <dynamy_elements/joints/joints.hpp>
#include <dynamy_elements/joints/presliding.hpp>
#include <dynamy_elements/joints/register_joints.hpp>
#include <dynamy_elements/joints/spatial_joints.hpp>
#include <dynamy_elements/joints/transmissions.hpp>

namespace dynamy {

void registerJoints(Registry& r) {
  r.add<Revolute>("Revolute");
  r.add<Spherical>("Spherical");
  r.add<Prismatic>("Prismatic");
  r.add<Fixed>("Fixed");
  r.add<Distance>("Distance");
  r.add<Universal>("Universal");
  r.add<Cylindrical>("Cylindrical");
  r.add<Screw>("Screw");
  r.add<PlanarJoint>("PlanarJoint");

  r.add<JointStop>("JointStop");
  r.add<JointDrive>("JointDrive");
  r.add<JointMotor>("JointMotor");
  r.add<JointFriction>("JointFriction");
  r.add<JointSpring>("JointSpring");
  r.add<JointForce>("JointForce");
  r.add<PdController>("PdController");
  r.add<DahlFriction>("DahlFriction");
  r.add<LuGreFriction>("LuGreFriction");

  r.add<Gear>("Gear");
  r.add<RackAndPinion>("RackAndPinion");
  r.add<Rope>("Rope");
}

}  // namespace dynamy
