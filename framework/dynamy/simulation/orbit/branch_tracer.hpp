/// BranchTracer: follows an OrbitCurve from one of its points in one direction, by pseudo-arclength
/// continuation with steps that it controls (theory 54.5).
///
/// Around the last point, the base, the curve is y(s) = sτ + s²g(s) with the tangent τ; g comes from
/// the points before and predicts the next one. Points are found in the plane ⟨τ, y⟩ = s.
#pragma once
#include <dynamy/simulation/orbit/orbit_branch.hpp>
#include <functional>

namespace dynamy {

/// A point of the curve, seen from the base.
struct BranchNode {
  double s = 0.0;
  Eigen::VectorXd y;
};
/// The polynomial through these nodes.
Eigen::VectorXd through(const std::vector<BranchNode>& nodes, double s);

class BranchTracer {
 public:
  BranchTracer(OrbitCurve& curve, int points);
  /// Follows the curve from `start`, which is no part of the result; sign: of the change of p there.
  /// The last point is an end and says which.
  std::vector<BranchPoint> follow(const OrbitPoint& start, double sign);
  /// A derived point of the curve as a result.
  BranchPoint result(OrbitPoint& point);
  /// The orbit that the last follow() ended with.
  const OrbitPoint& last() const { return base_; }

 private:
  using Node = BranchNode;
  enum class Tried : std::uint8_t { good, changed, failed };
  using Off = std::function<double(const Eigen::VectorXcd&)>;
  Eigen::VectorXd predicted(double s) const;
  Tried attempt(const Eigen::VectorXd& guess, int derivatives, OrbitPoint& out);
  bool step(double& h);
  void take(const OrbitPoint& next, const Eigen::VectorXd& y, const Eigen::VectorXd& tangent);
  void findInstabilities(OrbitPoint& next, const Node& node);
  BranchPoint locate(const Node& next, const Off& off, double before, double after, double& s);
  bool change(double reached);
  bool cross(const OrbitPoint& lower, double s, OrbitPoint& out);
  void restart(OrbitPoint point, const Eigen::VectorXd& along);
  void end(const std::string& text);
  OrbitCurve& curve_;
  double longest_;    ///< step, in units of y
  std::size_t most_;  ///< points
  OrbitPoint base_;
  Eigen::VectorXcd multipliers_;  ///< of the base
  Eigen::VectorXd tangent_;       ///< at the base
  std::vector<Node> old_;         ///< points before the base
  bool atLimit_ = false;          ///< the last attempt was on a limit of p
  std::vector<BranchPoint> out_;
};

}  // namespace dynamy
