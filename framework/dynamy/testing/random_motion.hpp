/// States of a model near its start, and the motion through them, for the checks of its elements.
#pragma once
#include <dynamy/testing/check_element.hpp>
#include <random>
#include <string>

namespace dynamy::testing {

inline std::string nameOf(const Element& e, const char* otherwise) {
  if (!e.name().empty()) return e.name();
  return e.type().empty() ? otherwise : e.type();
}

/// "ball.xml:12:5: floor": place and name, as faults begin. Elements made in C++ have no place.
inline std::string withPlace(const Place& place, const std::string& name) {
  const std::string where = place.format();
  return where.empty() ? name : where + ": " + name;
}
inline std::string labelOf(const Element& e, const char* otherwise) {
  return withPlace(e.place(), nameOf(e, otherwise));
}

/// Random states of a model and the motion through them.
class RandomMotion {
 public:
  RandomMotion(Model& model, const CheckOptions& options)
      : model_(model), options_(options), random_(options.seed), start_(model.initialState()) {
    kinematics_.resize(model.topology());
    x_ = start_;
  }
  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  /// Takes sample i: the start itself for i = 0, then random states near it.
  void sample(int i) {
    x_ = start_;
    if (i == 0) return;
    Eigen::VectorXd v(start_.u.size());
    for (double& x : v) x = options_.speed * uniform();
    move(x_, v, options_.reach * std::abs(uniform()));
    for (std::size_t s = 0; s < model_.systems().size(); ++s) {
      const SystemHandle& h = model_.topology().system(static_cast<int>(s));
      if (h.nq > 0) model_.systems()[s]->normalise(slice(x_.q, h.q0, h.nq));
    }
    for (double& x : x_.u) x += options_.speed * uniform();
    x_.t = options_.reach * std::abs(uniform());
  }
  State after(double s) const { return after(s, x_.u); }
  /// State after the time s with velocity u in place of that of the state.
  State after(double s, const Eigen::VectorXd& u) const {
    State x = x_;
    x.u = u;
    move(x, u, s);
    return x;
  }
  const State& x() const { return x_; }
  Kinematics& kinematics(const State& x) {
    kinematics_.evaluate(model_.topology(), x.t, view(x.q), view(x.u), view(x.memory));
    return kinematics_;
  }

 private:
  void move(State& x, const Eigen::VectorXd& v, double s) const {
    for (std::size_t i = 0; i < model_.systems().size(); ++i) {
      const SystemHandle& h = model_.topology().system(static_cast<int>(i));
      if (h.nq > 0) model_.systems()[i]->move(x.t, slice(x.q, h.q0, h.nq), slice(v, h.u0, h.nu), s);
    }
    x.t += s;
  }
  Model& model_;
  CheckOptions options_;
  std::mt19937 random_;
  State start_, x_;
  Kinematics kinematics_;
};

}  // namespace dynamy::testing
