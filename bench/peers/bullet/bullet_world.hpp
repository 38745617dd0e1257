/// A world of Bullet in double precision; friction and restitution of a pair are products.
#pragma once
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

namespace peer {

class BulletWorld {
 public:
  explicit BulletWorld(const btVector3& gravity, int iterations = 50, bool rebounds = false)
      : rebounds_(rebounds),
        dispatcher_(&configuration_),
        world(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world.setGravity(gravity);
    btContactSolverInfo& s = world.getSolverInfo();
    s.m_numIterations = iterations;
    if (rebounds) {  // errors of position stay out of the velocities
      s.m_splitImpulse = 1;
      s.m_splitImpulsePenetrationThreshold = 1e30;
      s.m_restitutionVelocityThreshold = 0.0;
    }
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;
  ~BulletWorld() {
    for (auto& c : constraints_) world.removeConstraint(c.get());
    if (tree) world.removeMultiBody(tree.get());
    for (auto& b : bodies_) world.removeRigidBody(b.get());
  }

  btRigidBody& body(double mass, std::unique_ptr<btCollisionShape> shape, btVector3 inertia,
                    const btVector3& at, double friction, double e) {
    states_.push_back(
        std::make_unique<btDefaultMotionState>(btTransform(btQuaternion::getIdentity(), at)));
    if (mass > 0 && inertia.isZero()) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, states_.back().get(), shape.get(), inertia);
    info.m_friction = friction, info.m_restitution = e;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    shapes_.push_back(std::move(shape));
    btRigidBody& b = *bodies_.back();
    b.setDamping(0.0, 0.0);
    b.setActivationState(DISABLE_DEACTIVATION);
    // A contact seen before it touches would take the speed of approach.
    if (rebounds_) b.setContactProcessingThreshold(0.0);
    world.addRigidBody(&b);
    return b;
  }
  void ground() {
    body(0.0, std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), 0.0), {0, 0, 0}, {0, 0, 0},
         1.0, 1.0);
  }
  btRigidBody& sphere(double mass, double r, double z, double mu, double e) {
    return body(mass, std::make_unique<btSphereShape>(r), {0, 0, 0}, {0, 0, z}, mu, e);
  }
  btRigidBody& box(double mass, const btVector3& size, double z, double mu) {
    return body(mass, std::make_unique<btBoxShape>(0.5 * size), {0, 0, 0}, {0, 0, z}, mu, 0.0);
  }
  btRigidBody& shapeless(double mass, const btVector3& inertia, const btVector3& at) {
    return body(mass, std::make_unique<btEmptyShape>(), inertia, at, 0, 0);
  }
  void add(std::unique_ptr<btTypedConstraint> c) {
    world.addConstraint(c.get(), true);
    constraints_.push_back(std::move(c));
  }
  /// A chain of links on hinges about y in reduced coordinates, hung up at the origin.
  struct Link {
    double mass, length, centre, inertia;  ///< along the link from its hinge; about y
  };
  void chain(const std::vector<Link>& links, bool rk4) {
    tree = std::make_unique<btMultiBody>(static_cast<int>(links.size()), 0.0, btVector3(0, 0, 0),
                                         true, false);
    double before = 0.0;  // from the centre of the link before to the hinge
    for (std::size_t i = 0; i < links.size(); ++i) {
      const Link& l = links[i];
      tree->setupRevolute(static_cast<int>(i), l.mass, {1e-3 * l.mass, l.inertia, l.inertia},
                          static_cast<int>(i) - 1, btQuaternion::getIdentity(), {0, 1, 0},
                          {before, 0, 0}, {l.centre, 0, 0}, true);
      before = l.length - l.centre;
    }
    tree->finalizeMultiDof();
    tree->setLinearDamping(0.0), tree->setAngularDamping(0.0);
    tree->setMaxCoordinateVelocity(1e9);
    tree->setMaxAppliedImpulse(1e30);
    tree->setCanSleep(false);
    tree->useRK4Integration(rk4);
    world.addMultiBody(tree.get());
  }
  void step(double h) { world.stepSimulation(h, 0); }

 private:
  bool rebounds_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btMotionState>> states_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints_;

 public:
  std::unique_ptr<btMultiBody> tree;
  btMultiBodyDynamicsWorld world;
};

}  // namespace peer
