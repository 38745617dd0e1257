/// ODE's quick step of 50 iterations on a scene of many bodies (bench/peers/scene.hpp): balls,
/// boxes, capsules and cylinders without joints.
#include "../scene.hpp"

#include "ode_world.hpp"

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const peer::Scene s = peer::readScene(argv[1]);
  if (!s.joints.empty()) return std::printf("note joints are left out\n"), 1;
  dInitODE();
  {
    peer::OdeSettings settings;
    settings.mu = s.mu, settings.e = s.e, settings.gravity = {0, 0, -s.g};
    peer::OdeWorld w(settings);
    for (const auto& p : s.planes)
      dCreatePlane(w.space, p[3], p[4], p[5], p[0] * p[3] + p[1] * p[4] + p[2] * p[5]);
    for (const auto& b : s.slabs) {
      dGeomID box = dCreateBox(w.space, b[0], b[1], b[2]);
      dGeomSetPosition(box, b[3], b[4], b[5]);
      dGeomSetQuaternion(box, &b[6]);
    }
    std::vector<dBodyID> bodies;
    for (const peer::SceneBody& b : s.bodies) {
      dGeomID g = nullptr;
      if (b.kind == "Sphere") g = dCreateSphere(w.space, b.size[0]);
      if (b.kind == "Box") g = dCreateBox(w.space, b.size[0], b.size[1], b.size[2]);
      if (b.kind == "Capsule") g = dCreateCapsule(w.space, b.size[0], b.size[1]);
      if (b.kind == "Cylinder") g = dCreateCylinder(w.space, b.size[0], b.size[1]);
      if (g == nullptr) return std::printf("note no shape %s\n", b.kind.c_str()), 1;
      dBodyID r =
          w.body(b.mass, b.inertia[0], b.inertia[1], b.inertia[2], b.at[0], b.at[1], b.at[2]);
      dGeomSetBody(g, r);
      dBodySetQuaternion(r, b.turn.data());
      dBodySetLinearVel(r, b.v[0], b.v[1], b.v[2]);
      dVector3 o;
      dBodyVectorToWorld(r, b.w[0], b.w[1], b.w[2], o);
      dBodySetAngularVel(r, o[0], o[1], o[2]);
      bodies.push_back(r);
    }
    peer::runScene(
        s, [&] { w.step(s.h); },
        [&](std::size_t i) {
          const dReal *r = dBodyGetPosition(bodies[i]), *q = dBodyGetQuaternion(bodies[i]);
          const dReal *v = dBodyGetLinearVel(bodies[i]), *a = dBodyGetAngularVel(bodies[i]);
          dVector3 o;
          dBodyVectorFromWorld(bodies[i], a[0], a[1], a[2], o);
          return std::array<double, 13>{r[0], r[1], r[2], q[0], q[1], q[2], q[3],
                                        v[0], v[1], v[2], o[0], o[1], o[2]};
        });
  }
  dCloseODE();
  return 0;
}
