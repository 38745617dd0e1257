/// Differences along a motion with constant u: q moves by the systems' own move(), which is exact
/// for constant velocities. Then d/dt r = J u + ν, d/dt (J u + ν) = bias, d/dt g = γ, d/dt γ =
/// bias.
#pragma once
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <functional>
#include <random>

namespace dynamy::testing {

/// Step of the 4-point difference [s]. Truncation d⁴ f⁗ʹ/30 and rounding 1.5 · 1e-16 f/d: for
/// motions with rates up to 3 rad/s and lengths up to 3 m both stay below 1e-11.
inline constexpr double kStep = 1e-3;
/// Allows for factors of a few rates and lengths on top.
inline constexpr double kTolerance = 1e-9;

inline Eigen::VectorXd fourPoint(const std::function<Eigen::VectorXd(double)>& f) {
  const double d = kStep;
  return (f(-2 * d) - 8.0 * f(-d) + 8.0 * f(d) - f(2 * d)) / (12.0 * d);
}

/// A built model at a state, moved from there.
class Motion {
 public:
  explicit Motion(Model& model, double t = 0.3)
      : model_(&model), t_(t), start_(model.initialState()) {
    kinematics_.resize(model.topology());
  }
  /// Random velocities, and positions after a while with them: off all constraints.
  void scatter(unsigned seed, double size = 1.0) {
    std::mt19937 random(seed);
    std::normal_distribution<double> number(0.0, size);
    for (double& v : start_.u) v = number(random);
    start_ = moved(0.3);
    for (double& v : start_.u) v = number(random);
  }
  State moved(double s) const {
    State x = start_;
    for (std::size_t i = 0; i < model_->systems().size(); ++i) {
      const SystemHandle& h = model_->topology().system(static_cast<int>(i));
      if (h.nu == 0) continue;
      model_->systems()[i]->move(t_, slice(x.q, h.q0, h.nq),
                                 slice(static_cast<const Eigen::VectorXd&>(x.u), h.u0, h.nu), s);
    }
    return x;
  }
  /// Frames `s` seconds later. The state stays alive with this object.
  const Kinematics& at(double s) {
    x_ = moved(s);
    kinematics_.evaluate(model_->topology(), t_ + s, {x_.q.data(), x_.q.size()},
                         {x_.u.data(), x_.u.size()}, {x_.memory.data(), x_.memory.size()});
    return kinematics_;
  }
  /// All contacts of an element, open ones included, with bias.
  ContactSet contacts(const NonSmoothElement& element, double s) {
    ContactSet set;
    set.clear();
    ContactRequest request;
    request.gTol = 1e9;
    request.bias = true;
    ContactSink sink(set, request);
    element.contacts(at(s), sink);
    return set;
  }
  Eigen::VectorXd gamma(const NonSmoothElement& element, double s) {
    const ContactSet set = contacts(element, s);
    Eigen::VectorXd out(set.rows());
    set.gamma({start_.u.data(), start_.u.size()}, {out.data(), out.size()});
    return out;
  }
  Eigen::VectorXd bias(const NonSmoothElement& element) {
    const ContactSet set = contacts(element, 0.0);
    return Eigen::Map<const Eigen::VectorXd>(set.bias.data(),
                                             static_cast<Eigen::Index>(set.bias.size()));
  }
  State& start() { return start_; }

 private:
  Model* model_;
  double t_;
  State start_, x_;
  Kinematics kinematics_;
};

}  // namespace dynamy::testing
