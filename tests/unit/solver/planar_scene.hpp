// Planar bodies and their contacts by geometry, for inclusion problems whose answer is known.
#pragma once
#include <array>

#include "inclusion_fixture.hpp"

namespace dynamy::fixture {

/// Mass m, moment of inertia J, centre of mass.
struct PlanarBody {
  double m = 1.0, J = 1.0;
  Eigen::Vector2d centre{0.0, 0.0};
};

class PlanarScene {
 public:
  explicit PlanarScene(std::vector<PlanarBody> bodies)
      : bodies_(std::move(bodies)),
        inclusion_(std::make_unique<Inclusion>(masses(bodies_))),
        bilateral_(std::make_unique<Bilateral>()) {}

  /// Body `on` touches body `by` (−1: the ground) at `point`; the normal points to `on`.
  void contact(const SetValuedForceLaw& law, int on, int by, Eigen::Vector2d point,
               Eigen::Vector2d normal) {
    normal.normalize();
    rows(law, on, by, point, {normal, Eigen::Vector2d(normal.y(), -normal.x())});
  }
  /// Revolute joint.
  void joint(int on, int by, Eigen::Vector2d point) {
    rows(*bilateral_, on, by, point, {Eigen::Vector2d::UnitX(), Eigen::Vector2d::UnitY()});
  }
  /// c = Wᵀ u for velocities (vx, vy, ω) of all bodies.
  InclusionProblem& move(const Eigen::VectorXd& u) { return inclusion_->pose(Wt_ * u); }
  InclusionProblem& pose(const Eigen::VectorXd& c) { return inclusion_->pose(c); }
  /// A step of gravity (gx, gy) from rest.
  InclusionProblem& fall(double gx, double gy) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(Wt_.cols());
    for (Eigen::Index b = 0; b < u.size(); b += 3) u[b] = gx, u[b + 1] = gy;
    return move(u);
  }
  int rowCount() const { return static_cast<int>(Wt_.rows()); }

 private:
  static std::vector<Eigen::MatrixXd> masses(const std::vector<PlanarBody>& bodies) {
    std::vector<Eigen::MatrixXd> out;
    for (const PlanarBody& b : bodies)
      out.push_back(Eigen::Vector3d(b.m, b.m, b.J).asDiagonal().toDenseMatrix());
    return out;
  }
  void rows(const SetValuedForceLaw& law, int on, int by, const Eigen::Vector2d& point,
            const std::array<Eigen::Vector2d, 2>& directions) {
    const int dim = law.dim(2);
    Eigen::MatrixXd Wt = Eigen::MatrixXd::Zero(dim, 3 * static_cast<Eigen::Index>(bodies_.size()));
    for (const auto& [body, sign] : {std::pair{on, 1.0}, std::pair{by, -1.0}}) {
      if (body < 0) continue;
      const Eigen::Vector2d a = point - bodies_[static_cast<std::size_t>(body)].centre;
      for (int r = 0; r < dim; ++r) {
        const Eigen::Vector2d& d = directions[static_cast<std::size_t>(r)];
        Wt.row(r).segment<3>(3 * body) =
            sign * Eigen::RowVector3d(d.x(), d.y(), a.x() * d.y() - a.y() * d.x());
      }
    }
    inclusion_->contact(law, Wt);
    Wt_.conservativeResize(Wt_.rows() + dim, Wt.cols());
    Wt_.bottomRows(dim) = Wt;
  }

  std::vector<PlanarBody> bodies_;
  std::unique_ptr<Inclusion> inclusion_;
  std::unique_ptr<Bilateral> bilateral_;
  Eigen::MatrixXd Wt_;
};

}  // namespace dynamy::fixture
