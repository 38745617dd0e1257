#include <algorithm>
#include <cmath>
#include <dynamy/integrator/error_norm.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

void ErrorNorm::scales(const MechanicalSystem& s) {
  const Topology& topology = *s.parts().topology;
  q_.setOnes(topology.nq()), u_.setOnes(topology.nu());
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& h = topology.system(static_cast<int>(i));
    Description d;
    topology.systems()[i]->describe(d);
    const auto unitOf = [&](const std::string& name) {
      for (const Signal& signal : d.signals)
        if (signal.name == name) return signal.unit;
      return Unit::none;
    };
    // Populations name the coordinates of one block at most.
    const auto fill = [&](const auto& named, int first, int n, int block, Unit length,
                          Eigen::VectorXd& out) {
      for (const auto& [name, k] : named)
        for (int at = k; unitOf(name) == length && block > 0 && at < n; at += block)
          out[first + at] = length_;
    };
    fill(d.coordinates, h.q0, h.nq, h.blockNq, Unit::length, q_);
    fill(d.velocities, h.u0, h.nu, h.blockNu, Unit::velocity, u_);
  }
}

void ErrorNorm::start(const MechanicalSystem& s, const State& x, int slot, double tolerance,
                      double length) {
  resume(s, tolerance, length, 1.0);
  const Evaluation& e = s.slot(slot);
  Eigen::VectorXd a(e.h.size());
  e.mass.applyInverse(view(e.h), view(a));
  double rate = 0.0, acceleration = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    rate = std::max(rate, std::abs(x.u[i]) / u_[i]);
    acceleration = std::max(acceleration, std::abs(a[i]) / u_[i]);
  }
  const double inverse = rate + std::sqrt(acceleration);
  time_ = inverse > 0.0 && std::isfinite(inverse) ? 1.0 / inverse : 1.0;
}

void ErrorNorm::resume(const MechanicalSystem& s, double tolerance, double length, double time) {
  tolerance_ = tolerance, length_ = length, time_ = time;
  scales(s);
}

double ErrorNorm::position(Eigen::Index i, double error, double value) const {
  return std::abs(error) / (tolerance_ * std::max(q_[i], std::abs(value)));
}

double ErrorNorm::fastestTurn(const Eigen::VectorXd& u) const {
  double fastest = 0.0;
  for (Eigen::Index i = 0; i < u.size(); ++i)
    if (u_[i] == 1.0) fastest = std::max(fastest, std::abs(u[i]));
  return fastest;
}

double ErrorNorm::velocity(Eigen::Index i, double error, double value) const {
  return std::abs(error) / (tolerance_ * std::max(u_[i] / time_, std::abs(value)));
}

}  // namespace dynamy
