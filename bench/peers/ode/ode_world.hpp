/// A world of the Open Dynamics Engine with one friction and one restitution for all pairs.
#pragma once
#include <ode/ode.h>

#include <array>
#include <vector>

namespace peer {

struct OdeSettings {
  bool direct = false;  ///< dWorldStep (pivoting), else dWorldQuickStep
  int iterations = 50;  ///< of dWorldQuickStep
  double mu = 0.0, e = 0.0, erp = 0.2;
  std::array<double, 3> gravity{0.0, 0.0, -9.81};
};

class OdeWorld {
 public:
  explicit OdeWorld(const OdeSettings& settings) : s_(settings) {
    world = dWorldCreate();
    space = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world, s_.gravity[0], s_.gravity[1], s_.gravity[2]);
    dWorldSetQuickStepNumIterations(world, s_.iterations);
    dWorldSetERP(world, s_.erp);
    dWorldSetCFM(world, 1e-12);
    dWorldSetAutoDisableFlag(world, 0);
    dWorldSetContactSurfaceLayer(world, 0.0);
  }
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;
  ~OdeWorld() {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space);
    dWorldDestroy(world);
  }

  void ground() { dCreatePlane(space, 0, 0, 1, 0); }
  dBodyID body(double mass, double ix, double iy, double iz, double x, double y, double z) {
    dBodyID b = dBodyCreate(world);
    dMass m;
    dMassSetParameters(&m, mass, 0, 0, 0, ix, iy, iz, 0, 0, 0);
    dBodySetMass(b, &m);
    dBodySetPosition(b, x, y, z);
    dBodySetLinearDamping(b, 0.0);
    dBodySetAngularDamping(b, 0.0);
    return b;
  }
  dBodyID sphere(double mass, double r, double z) {
    const double i = 0.4 * mass * r * r;
    dBodyID b = body(mass, i, i, i, 0, 0, z);
    dGeomSetBody(dCreateSphere(space, r), b);
    return b;
  }
  dBodyID box(double mass, double a, double b, double c, double z) {
    dBodyID body = this->body(mass, mass * (b * b + c * c) / 12, mass * (a * a + c * c) / 12,
                              mass * (a * a + b * b) / 12, 0, 0, z);
    dGeomSetBody(dCreateBox(space, a, b, c), body);
    return body;
  }
  void step(double h) {
    dSpaceCollide(space, this, [](void* self, dGeomID a, dGeomID b) {
      static_cast<OdeWorld*>(self)->touch(a, b);
    });
    if (s_.direct)
      dWorldStep(world, h);
    else
      dWorldQuickStep(world, h);
    dJointGroupEmpty(contacts_);
  }
  dWorldID world;
  dSpaceID space;

 private:
  void touch(dGeomID a, dGeomID b) {
    std::array<dContact, 16> c{};
    const int n = dCollide(a, b, 16, &c[0].geom, sizeof(dContact));
    for (int i = 0; i < n; ++i) {
      dSurfaceParameters& s = c[static_cast<std::size_t>(i)].surface;
      s.mode = dContactBounce | dContactApprox1;  // friction in proportion to the normal force
      s.mu = s_.mu;
      s.bounce = s_.e;
      s.bounce_vel = 0.0;
      dJointAttach(dJointCreateContact(world, contacts_, &c[static_cast<std::size_t>(i)]),
                   dGeomGetBody(a), dGeomGetBody(b));
    }
  }
  OdeSettings s_;
  dJointGroupID contacts_;
};

}  // namespace peer
