// Gaps of pairs of shapes against those of FCL, which shares no code with us.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <unit/elements/contacts/faceted_bodies.hpp>
#include <unit/elements/contacts/shape_models.hpp>

namespace dynamy {
namespace {

using namespace testing;

constexpr double kR = 0.25, kLength = 0.5;
const Vec3 kAxes(0.3, 0.2, 0.15), kBox(0.5, 0.7, 0.3);

/// A shape of ours and the same of FCL, both about the middle of their length.
struct Same {
  std::string name;
  std::function<std::unique_ptr<Shape>(const Given& more)> ours;
  std::shared_ptr<fcl::CollisionGeometryd> theirs;
  double centre = 0.0;  ///< of mass, along z from the middle
};

template <class S>
Same same(const char* name, const Given& given, std::shared_ptr<fcl::CollisionGeometryd> theirs,
          double centre = 0.0) {
  const auto ours = [=](const Given& more) {
    Given all = given;
    all.insert(all.end(), more.begin(), more.end());
    return std::make_unique<S>(Parameters::of<S>(name, "", all));
  };
  return {name, ours, std::move(theirs), centre};
}

std::vector<Same> shapes() {
  return {
      same<Sphere>("Sphere", {{"radius", kR}}, std::make_shared<fcl::Sphered>(kR)),
      same<CapsuleShape>("Capsule", {{"radius", kR}, {"length", kLength}},
                         std::make_shared<fcl::Capsuled>(kR, kLength)),
      same<CylinderShape>("Cylinder", {{"radius", kR}, {"length", kLength}},
                          std::make_shared<fcl::Cylinderd>(kR, kLength)),
      same<ConeShape>(
          "Cone", {{"radius", kR}, {"length", kLength}, {"position", {0.0, 0.0, -0.5 * kLength}}},
          std::make_shared<fcl::Coned>(kR, kLength), -0.25 * kLength),
      same<EllipsoidShape>("Ellipsoid", {{"semiAxes", kAxes}},
                           std::make_shared<fcl::Ellipsoidd>(kAxes.x(), kAxes.y(), kAxes.z())),
      same<Box>("Box", {{"size", kBox}},
                std::make_shared<fcl::Boxd>(kBox.x(), kBox.y(), kBox.z()))};
}

/// Two bodies of one shape each, the second anywhere near the first.
class TwoShapes {
 public:
  TwoShapes(const Same& a, const Same& b) : a_(&a), b_(&b) {
    model_.add(std::make_unique<Ground>(
        Parameters::of<Ground>("Ground", "a", Given{}).with(a.ours({{"material", "steel"}}))));
    model_.add(
        std::make_unique<RigidBody>(Parameters::of<RigidBody>("RigidBody", "b", Given{})
                                        .with(b.ours({{"material", "wood"}, {"mass", 1.0}}))));
    addRule(model_, "steel wood");
    element_ = &built(model_);
    motion_ = std::make_unique<Motion>(model_, 0.0);
  }
  void place(std::mt19937& random) {
    std::normal_distribution<double> number;
    std::uniform_real_distribution<double> way(0.1, 0.75);
    Vec3 r(number(random), number(random), number(random));
    r *= way(random) / r.norm();
    Eigen::Vector4d p(number(random), number(random), number(random), number(random));
    p.normalize();
    const Mat3 A = Eigen::Quaterniond(p[0], p[1], p[2], p[3]).toRotationMatrix();
    // The state is that of the centre of mass.
    motion_->start().q.head<3>() = r + b_->centre * A.col(2);
    motion_->start().q.segment<4>(3) = p;
    pose_.setIdentity(), pose_.translation() = r, pose_.linear() = A;
    set_ = motion_->contacts(*element_, 0.0);
  }
  bool reported() const { return set_.size() > 0; }  ///< not when they are far from each other
  double gap() const { return *std::min_element(set_.g.begin(), set_.g.end()); }
  /// FCL's distance, 0 or less: they overlap.
  double distance() const {
    fcl::DistanceRequestd request(true);
    request.distance_tolerance = 1e-9;
    fcl::DistanceResultd result;
    return fcl::distance(a_->theirs.get(), fcl::Transform3d::Identity(), b_->theirs.get(), pose_,
                         request, result);
  }
  /// Of two boxes that are apart, against all pairs of corners, faces and edges. FCL's distance
  /// `theirs` is theirs. Our gap is, unless a corner is nearest that is beside a face: two bodies
  /// meet with a corner over a face or with edges that cross, and gaps are those of such pairs.
  void expectOfBoxes(double theirs) const {
    const std::vector<Vec3> A = boxTriangles(0.5 * kBox);
    std::vector<Vec3> B;
    for (const Vec3& p : A) B.push_back(pose_ * p);
    const Distance exact = testing::distance(A, B);
    constexpr double kRounding = 1e-14;  // of lengths of 1, over the angles of edges that cross
    EXPECT_NEAR(theirs, exact.value, kRounding);
    if (exact.isContact)
      EXPECT_NEAR(gap(), exact.value, kRounding);
    else
      EXPECT_GT(gap(), exact.value);
  }
  /// FCL's largest depth of a contact, 0: none.
  double depth() const {
    const fcl::CollisionRequestd request(100, true);
    fcl::CollisionResultd result;
    fcl::collide(a_->theirs.get(), fcl::Transform3d::Identity(), b_->theirs.get(), pose_, request,
                 result);
    double out = 0.0;
    for (std::size_t i = 0; i < result.numContacts(); ++i)
      out = std::max(out, std::abs(result.getContact(i).penetration_depth));
    return out;
  }

 private:
  const Same *a_, *b_;
  Model model_;
  const ShapeContacts* element_ = nullptr;
  std::unique_ptr<Motion> motion_;
  ContactSet set_;
  fcl::Transform3d pose_;
};

TEST(Fcl, HasTheSameDistancesOfShapesThatAreApart) {
  // FCL's iteration ends within 1e-6 of what is left.
  constexpr double kLeft = 1e-6;
  const std::vector<Same> all = shapes();
  for (const Same& a : all)
    for (const Same& b : all) {
      SCOPED_TRACE(a.name + " and " + b.name + ", seed 3");
      const bool boxes = a.name == "Box" && b.name == "Box";
      TwoShapes pair(a, b);
      std::mt19937 random(3);
      int apart = 0;
      for (int i = 0; i < 300; ++i) {
        pair.place(random);
        if (!pair.reported() || pair.gap() < 1e-3) continue;
        ++apart;
        const double d = pair.distance();
        // A third way says which is right for boxes.
        if (boxes)
          pair.expectOfBoxes(d);
        else
          EXPECT_NEAR(pair.gap(), d, kLeft) << "placement " << i;
      }
      EXPECT_GT(apart, 30);
    }
}

TEST(Fcl, FindsNoOverlapWhereAGapIsTold) {
  const std::vector<Same> all = shapes();
  for (const Same& a : all)
    for (const Same& b : all) {
      SCOPED_TRACE(a.name + " and " + b.name + ", seed 5");
      TwoShapes pair(a, b);
      std::mt19937 random(5);
      int deep = 0;
      for (int i = 0; i < 1000; ++i) {
        pair.place(random);
        const double d = pair.distance();  // 0 or less where they overlap, however deep
        deep += d <= 0.0;
        EXPECT_TRUE(d > 0.0 || (pair.reported() && pair.gap() < 1e-6)) << "placement " << i;
      }
      EXPECT_GT(deep, 200);
    }
}

TEST(Fcl, HasTheSameDepthsOfBalls) {
  const std::vector<Same> all = shapes();
  for (const char* other : {"Sphere", "Capsule", "Cylinder", "Box"}) {
    SCOPED_TRACE(std::string(other) + ", seed 4");
    const auto b =
        std::find_if(all.begin(), all.end(), [&](const Same& s) { return s.name == other; });
    TwoShapes pair(all.front(), *b);
    std::mt19937 random(4);
    int deep = 0;
    for (int i = 0; i < 300; ++i) {
      pair.place(random);
      if (!pair.reported() || pair.gap() > -1e-3) continue;
      ++deep;
      // Closed forms on both sides.
      EXPECT_NEAR(pair.depth(), -pair.gap(), 1e-12);
    }
    EXPECT_GT(deep, 100);
  }
}

}  // namespace
}  // namespace dynamy
