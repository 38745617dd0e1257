/// Bullet on a scene of many bodies (bench/peers/scene.hpp): 50 iterations, two friction
/// directions, no sleeping, no damping; collision margins of its own default, but at most a
/// fiftieth of a hull's or cylinder's size.
#include "../scene.hpp"

#include "bullet_world.hpp"

namespace {

using Shape = std::unique_ptr<btCollisionShape>;

btQuaternion turn(const double* q) { return {q[1], q[2], q[3], q[0]}; }

Shape shapeOf(const peer::SceneBody& b) {
  const std::vector<double>& d = b.size;
  Shape s;
  if (b.kind == "Sphere") return std::make_unique<btSphereShape>(d[0]);
  if (b.kind == "Box") s = std::make_unique<btBoxShape>(btVector3(d[0], d[1], d[2]) * 0.5);
  if (b.kind == "Capsule") return std::make_unique<btCapsuleShapeZ>(d[0], d[1]);
  if (b.kind == "Cylinder")
    s = std::make_unique<btCylinderShapeZ>(btVector3(d[0], d[0], 0.5 * d[1]));
  if (b.kind == "Cone") s = std::make_unique<btConeShapeZ>(d[0], d[1]);
  if (b.kind == "Polyhedron") {
    auto hull = std::make_unique<btConvexHullShape>();
    for (std::size_t k = 0; k + 2 < d.size(); k += 3)
      hull->addPoint({d[k], d[k + 1], d[k + 2]}, false);
    hull->recalcLocalAabb();
    s = std::move(hull);
  }
  if (s == nullptr) return s;
  btVector3 low, high;
  s->getAabb(btTransform::getIdentity(), low, high);
  const btVector3 reach = high - low;
  const double margin = std::min(0.04, 0.02 * reach[reach.minAxis()]);
  s->setMargin(margin);
  return s;
}

std::unique_ptr<btTypedConstraint> jointOf(const peer::SceneJoint& j, btRigidBody& a,
                                           btRigidBody& b) {
  btTransform world = btTransform::getIdentity();
  world.setOrigin({j.at[0], j.at[1], j.at[2]});
  const btVector3 axis(j.axis[0], j.axis[1], j.axis[2]);
  const btTransform toA = a.getWorldTransform().inverse(), toB = b.getWorldTransform().inverse();
  if (j.kind == "Spherical")
    return std::make_unique<btPoint2PointConstraint>(a, b, toA * world.getOrigin(),
                                                     toB * world.getOrigin());
  if (j.kind == "Revolute")
    return std::make_unique<btHingeConstraint>(a, b, toA * world.getOrigin(),
                                               toB * world.getOrigin(), toA.getBasis() * axis,
                                               toB.getBasis() * axis);
  if (j.kind == "Fixed") return std::make_unique<btFixedConstraint>(a, b, toA * world, toB * world);
  world.setRotation(shortestArcQuat(btVector3(1, 0, 0), axis));
  auto slider = std::make_unique<btSliderConstraint>(a, b, toA * world, toB * world, true);
  slider->setLowerLinLimit(1.0), slider->setUpperLinLimit(-1.0);  // free along
  slider->setLowerAngLimit(0.0), slider->setUpperAngLimit(0.0);
  return slider;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const peer::Scene s = peer::readScene(argv[1]);
  peer::BulletWorld w({0, 0, -s.g}, 50, s.e > 0.0);
  const double mu = std::sqrt(s.mu), e = std::sqrt(s.e);
  for (const auto& p : s.planes) {
    const btVector3 n(p[3], p[4], p[5]);
    w.body(0, std::make_unique<btStaticPlaneShape>(n, n.dot({p[0], p[1], p[2]})), {0, 0, 0},
           {0, 0, 0}, mu, e);
  }
  const auto place = [](btRigidBody& b, const btTransform& t) {
    b.setWorldTransform(t), b.setInterpolationWorldTransform(t);
    b.getMotionState()->setWorldTransform(t);
  };
  for (const auto& b : s.slabs) {
    const btVector3 at(b[3], b[4], b[5]);
    place(w.body(0, std::make_unique<btBoxShape>(btVector3(b[0], b[1], b[2]) * 0.5), {0, 0, 0}, at,
                 mu, e),
          btTransform(turn(&b[6]), at));
  }
  std::vector<btRigidBody*> bodies;
  for (const peer::SceneBody& b : s.bodies) {
    Shape shape = shapeOf(b);
    if (shape == nullptr) return std::printf("note no shape %s\n", b.kind.c_str()), 1;
    const btVector3 at(b.at[0], b.at[1], b.at[2]);
    const btTransform t(turn(b.turn.data()), at);
    btRigidBody& r =
        w.body(b.mass, std::move(shape), {b.inertia[0], b.inertia[1], b.inertia[2]}, at, mu, e);
    place(r, t);
    r.updateInertiaTensor();
    r.setLinearVelocity({b.v[0], b.v[1], b.v[2]});
    r.setAngularVelocity(t.getBasis() * btVector3(b.w[0], b.w[1], b.w[2]));
    bodies.push_back(&r);
  }
  for (const peer::SceneJoint& j : s.joints) w.add(jointOf(j, *bodies[j.a], *bodies[j.b]));
  peer::runScene(
      s, [&] { w.step(s.h); },
      [&](std::size_t i) {
        const btTransform& t = bodies[i]->getWorldTransform();
        const btQuaternion q = t.getRotation();
        const btVector3& r = t.getOrigin();
        const btVector3& v = bodies[i]->getLinearVelocity();
        const btVector3 o = bodies[i]->getAngularVelocity() * t.getBasis();
        return std::array<double, 13>{r[0], r[1], r[2], q[3], q[0], q[1], q[2],
                                      v[0], v[1], v[2], o[0], o[1], o[2]};
      });
  return 0;
}
