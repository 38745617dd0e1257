/// DART on the scenes of bench/work_precision: joints in reduced coordinates, semi-implicit Euler,
/// contacts as a boxed linear complementarity problem by Dantzig's method, its default.
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/dart.hpp>

#include "../peer.hpp"

namespace {
using namespace dart::dynamics;
using dart::simulation::WorldPtr;
using peer::Answer;
using peer::march;

WorldPtr makeWorld(double h, const Eigen::Vector3d& gravity) {
  WorldPtr w = dart::simulation::World::create();
  w->setTimeStep(h);
  w->setGravity(gravity);
  // Its default detector turns a ball into a polyhedron, which does not roll.
  w->getConstraintSolver()->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  return w;
}

void addShape(BodyNode* body, const ShapePtr& shape, double mu, double e) {
  auto* node = body->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape);
  node->getDynamicsAspect()->setFrictionCoeff(mu);
  node->getDynamicsAspect()->setRestitutionCoeff(e);
}

void ground(const WorldPtr& w) {
  SkeletonPtr s = Skeleton::create("ground");
  BodyNode* b = s->createJointAndBodyNodePair<WeldJoint>().second;
  addShape(b, std::make_shared<BoxShape>(Eigen::Vector3d(200, 200, 2)), 1e3, 1.0);
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  at.translation() = Eigen::Vector3d(0, 0, -1);
  b->getParentJoint()->setTransformFromParentBodyNode(at);
  w->addSkeleton(s);
}

/// A free body at height z.
BodyNode* freeBody(const WorldPtr& w, double mass, const Eigen::Vector3d& inertia, double z,
                   const Eigen::Vector6d& velocity, const ShapePtr& shape = nullptr, double mu = 0,
                   double e = 0) {
  static int count = 0;
  SkeletonPtr s = Skeleton::create("body" + std::to_string(count++));
  auto pair = s->createJointAndBodyNodePair<FreeJoint>();
  pair.second->setInertia(
      Inertia(mass, Eigen::Vector3d::Zero(), Eigen::Matrix3d(inertia.asDiagonal())));
  if (shape) addShape(pair.second, shape, mu, e);
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  at.translation() = Eigen::Vector3d(0, 0, z);
  pair.first->setPositions(FreeJoint::convertToPositions(at));
  pair.first->setVelocities(velocity);
  w->addSkeleton(s);
  return pair.second;
}

Eigen::Vector3d boxInertia(double m, const Eigen::Vector3d& s) {
  const Eigen::Vector3d q = s.cwiseProduct(s);
  return m / 12 * Eigen::Vector3d(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
}

Eigen::Vector6d speed(double wx, double wy, double wz, double vx) {
  Eigen::Vector6d v;
  v << wx, wy, wz, vx, 0, 0;
  return v;
}

void bouncingBall(double h, Answer& a) {
  WorldPtr w = makeWorld(h, {0, 0, -9.81});
  ground(w);
  BodyNode* ball = freeBody(w, 1, Eigen::Vector3d::Constant(0.004), 1.1, speed(0, 0, 0, 0),
                            std::make_shared<SphereShape>(0.1), 0.0, 0.5);
  a.start();
  march(
      h, 1.6, {0.6, 1.0, 1.2, 1.3, 1.6}, a, [&] { w->step(); },
      [&](std::size_t) { a.add(ball->getCOM().z()); });
  a.stop();
}

void freeTop(double h, Answer& a) {
  WorldPtr w = makeWorld(h, Eigen::Vector3d::Zero());
  BodyNode* top = freeBody(w, 1, {1, 2, 3}, 0, speed(0.01, 5, 0.01, 0));
  a.start();
  march(
      h, 20.0, {}, a, [&] { w->step(); }, [](std::size_t) {});
  a.stop();
  const Eigen::Quaterniond q(top->getTransform().linear());
  const double sign = q.w() > 0 ? -1 : 1;
  for (const double v : {q.w(), q.x(), q.y(), q.z()}) a.add(sign * v);
}

struct Link {
  double mass, length, centre, inertia;
};

/// A chain of links on hinges about y, hung up at the origin.
SkeletonPtr chain(const WorldPtr& w, const std::vector<Link>& links) {
  SkeletonPtr s = Skeleton::create("chain");
  BodyNode* before = nullptr;
  double at = 0.0;
  for (const Link& l : links) {
    RevoluteJoint::Properties p;
    p.mAxis = Eigen::Vector3d::UnitY();
    p.mT_ParentBodyToJoint.translation() = Eigen::Vector3d(at, 0, 0);
    const std::string number = std::to_string(s->getNumBodyNodes());
    p.mName = "hinge" + number;
    BodyNode* b = s->createJointAndBodyNodePair<RevoluteJoint>(
                       before, p, BodyNode::AspectProperties("link" + number))
                      .second;
    b->setInertia(
        Inertia(l.mass, Eigen::Vector3d(l.centre, 0, 0),
                Eigen::Matrix3d(
                    Eigen::Vector3d(1e-3 * l.inertia + 1e-12, l.inertia, l.inertia).asDiagonal())));
    before = b, at = l.length;
  }
  w->addSkeleton(s);
  return s;
}

void pendulum(double h, Answer& a, bool rods) {
  const double half = 0.5 * std::acos(-1.0), c = rods ? 0.5 : 1.0, i = rods ? 1.0 / 12 : 1e-12;
  WorldPtr w = makeWorld(h, {0, 0, -9.81});
  SkeletonPtr s = chain(w, {{1, 1, c, i}, {1, 1, c, i}});
  a.start();
  march(
      h, 10.0, rods ? std::vector<double>{0.5, 1.0, 1.5, 2.0} : std::vector<double>{10.0}, a,
      [&] { w->step(); },
      [&](std::size_t) {
        const double upper = half - s->getPosition(0);
        a.add(upper), a.add(upper - s->getPosition(1));
      });
  a.stop();
}

void slope(double h, Answer& a, bool stick) {
  const double angle = 20.0 * std::acos(-1.0) / 180.0, g = 9.81;
  WorldPtr w = makeWorld(h, {-g * std::sin(angle), 0, -g * std::cos(angle)});
  ground(w);
  const Eigen::Vector3d size(0.2, 0.1, 0.1);
  BodyNode* box = freeBody(w, 1, boxInertia(1, size), 0.05 - 1e-9, speed(0, 0, 0, stick ? 0 : 2),
                           std::make_shared<BoxShape>(size), stick ? 0.5 : 0.3);
  a.start();
  march(
      h, stick ? 10.0 : 2.0, stick ? std::vector<double>{10.0} : std::vector<double>{0.2, 1.0, 2.0},
      a, [&] { w->step(); }, [&](std::size_t) { a.add(peer::placeOnSlope(box->getCOM().x())); });
  a.stop();
}

void slideToRoll(double h, Answer& a) {
  WorldPtr w = makeWorld(h, {0, 0, -9.81});
  ground(w);
  BodyNode* ball = freeBody(w, 1, Eigen::Vector3d::Constant(0.004), 0.1 - 1e-9, speed(0, 0, 0, 3),
                            std::make_shared<SphereShape>(0.1), 0.3);
  a.start();
  march(
      h, 0.5, {0.2, 0.5}, a, [&] { w->step(); },
      [&](std::size_t) { a.add(ball->getCOM().x()), a.add(ball->getCOMLinearVelocity().x()); });
  a.stop();
}

void stack(double h, Answer& a, int count, double ratio, double until) {
  WorldPtr w = makeWorld(h, {0, 0, -9.81});
  ground(w);
  std::vector<BodyNode*> cubes;
  const Eigen::Vector3d size(1, 1, 1);
  double mass = 1.0;
  for (int i = 0; i < count; ++i, mass *= ratio)
    cubes.push_back(freeBody(w, mass, boxInertia(mass, size), i + 0.5 - 1e-9 * (i + 1),
                             speed(0, 0, 0, 0), std::make_shared<BoxShape>(size), 0.5));
  a.start();
  march(
      h, until, {}, a, [&] { w->step(); }, [](std::size_t) {});
  a.stop();
  for (BodyNode* b : {cubes.front(), cubes.back()}) a.add(b->getCOM().x()), a.add(b->getCOM().z());
}

void heavyChain(double h, Answer& a) {
  WorldPtr w = makeWorld(h, {0, 0, -9.81});
  std::vector<Link> links(20, {0.1, 0.1, 0.05, 8.333333333333333e-5});
  links.push_back({100, 0, 0, 0.4});
  SkeletonPtr s = chain(w, links);
  s->setPosition(0, 0.25 * std::acos(-1.0));
  a.start();
  march(
      h, 2.0, {1.0, 2.0}, a, [&] { w->step(); },
      [&](std::size_t) {
        const Eigen::Vector3d end = s->getBodyNode(20)->getTransform().translation();
        a.add(end.x()), a.add(end.z());
      });
  a.stop();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string lcp = "Dantzig, default", tree = "joint tree";
  return peer::serve(
      argc, argv, std::string("DART ") + DART_VERSION + ", of the distribution",
      {"hard contact, friction as a pyramid; semi-implicit Euler, first order"},
      {{"bouncing_ball", lcp, peer::kBallSteps, bouncingBall},
       {"free_top", "default", peer::kSmoothSteps, freeTop},
       {"double_pendulum", tree, peer::kSmoothSteps,
        [](double h, Answer& a) { pendulum(h, a, false); }},
       {"rod_pendulum", tree, peer::kSmoothSteps,
        [](double h, Answer& a) { pendulum(h, a, true); }},
       {"slope_slide", lcp, peer::kBallSteps, [](double h, Answer& a) { slope(h, a, false); }},
       {"slope_stick", lcp, peer::kRestSteps, [](double h, Answer& a) { slope(h, a, true); }},
       {"slide_to_roll", lcp, peer::kBallSteps, slideToRoll},
       {"ratio_stack", lcp, peer::kRestSteps, [](double h, Answer& a) { stack(h, a, 5, 10, 5); }},
       {"tower", lcp, peer::kRestSteps, [](double h, Answer& a) { stack(h, a, 10, 1, 10); }},
       {"heavy_chain",
        tree,
        {"1e-2", "5e-3", "2e-3", "1e-3*", "5e-4", "2e-4", "1e-4"},
        heavyChain}});
}
