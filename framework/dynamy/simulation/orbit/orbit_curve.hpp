/// OrbitCurve: the orbits of a model with one parameter p, as a curve in y = (x, p) (theory 54.5):
///
///   P(x, p) ⊖ x = 0,   ⟨n, y⟩ = s
///
/// Here y is the distance from a point of the curve in units of the ranges of the state and of p, so
/// that (n, s) is any plane across the curve. At a fold of the curve DP − 1 is singular, the
/// Jacobian of both equations is not.
#pragma once
#include <dynamy/simulation/orbit/orbit.hpp>
#include <dynamy/simulation/orbit/orbit_events.hpp>
#include <functional>
#include <memory>

namespace dynamy {

/// Makes the model with a value of the parameter, and says its section.
using OrbitMaker = std::function<Model(double value, OrbitSection& section)>;

/// A point of the curve, and derivatives there, over the ranges.
struct OrbitPoint {
  double p = 0.0;
  Return orbit;
  std::vector<OrbitEvent> events;
  double residual = 0.0;
  Eigen::MatrixXd P;            ///< DP without ignorable coordinates; empty: not derived
  Eigen::VectorXd byParameter;  ///< ∂P/∂p
};

class OrbitCurve {
 public:
  /// `low`, `high`: of the parameter; models are made in between only.
  OrbitCurve(OrbitMaker make, double low, double high, double tolerance, double residual);
  ~OrbitCurve();
  /// The first point of the curve. Throws ModelError.
  OrbitPoint start(double p, const State& x);
  /// y of b, seen from a; the last number is the parameter.
  Eigen::VectorXd between(const OrbitPoint& b, const OrbitPoint& a);
  /// How a point of the curve is sought.
  struct Effort {
    double reach = 1.0;   ///< largest distance from the guess
    bool fresh = false;   ///< the derivatives of the point it comes from do not hold here
    int derivatives = 3;  ///< that may be taken on the way
  };
  /// Finds the point of the curve in the plane across n through `guess`. False: there is none, see
  /// why().
  bool solve(const OrbitPoint& from, const Eigen::VectorXd& guess, const Eigen::VectorXd& n,
             const Effort& effort, OrbitPoint& out);
  /// The return from this guess, which need not be an orbit. False: it does not return.
  bool probe(const OrbitPoint& from, const Eigen::VectorXd& guess, OrbitPoint& out);
  /// Adds derivatives to a point. Throws ModelError if there are none.
  void derive(OrbitPoint& point);
  /// Multipliers of a derived point; `fine`: by differences of fourth order, derived anew. Those say
  /// how many are not zero, until the next fine ones.
  Eigen::VectorXcd multipliers(OrbitPoint& point, bool fine);
  /// Multipliers of a derived point that are exactly zero, if it has `others`.
  int zeros(const OrbitPoint& point, Eigen::Index others);
  /// Unit tangent of the curve at a derived point, in the direction of `along`.
  Eigen::VectorXd tangent(const OrbitPoint& point, const Eigen::VectorXd& along) const;
  const Model& model(double p);
  const std::string& why() const { return why_; }
  double unit() const { return high_ - low_; }  ///< of p
  double low() const { return low_; }
  double high() const { return high_; }
  long cycles() const;  ///< runs over one period so far

 private:
  struct Entry;
  ReturnMap& at(double p);
  bool evaluate(const OrbitPoint& from, const Eigen::VectorXd& y, const Return* like,
                OrbitPoint& out);
  Eigen::VectorXd miss(const OrbitPoint& point);
  /// The Jacobian of both equations.
  Eigen::MatrixXd jacobian(const OrbitPoint& point, const Eigen::VectorXd& n) const;
  OrbitMaker make_;
  double low_, high_, tolerance_, residual_;
  std::vector<std::unique_ptr<Entry>> maps_;  ///< the last few
  std::vector<Eigen::Index> active_;
  Eigen::VectorXd range_;     ///< of the first orbit
  int held_ = 0;              ///< by joints
  Eigen::Index nonzero_ = 0;  ///< multipliers
  long cycles_ = 0;           ///< of maps that are gone
  std::string why_;
};

}  // namespace dynamy
