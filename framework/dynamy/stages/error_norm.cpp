#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <dynamy/stages/error_norm.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

void unitScales(const Topology& topology, double length, Eigen::VectorXd& q, Eigen::VectorXd& u) {
  q.setOnes(topology.nq()), u.setOnes(topology.nu());
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
    const auto fill = [&](const auto& named, int first, int n, int block, Unit unit,
                          Eigen::VectorXd& out) {
      for (const auto& [name, k] : named)
        for (int at = k; unitOf(name) == unit && block > 0 && at < n; at += block)
          out[first + at] = length;
    };
    fill(d.coordinates, h.q0, h.nq, h.blockNq, Unit::length, q);
    fill(d.velocities, h.u0, h.nu, h.blockNu, Unit::velocity, u);
  }
}

void ErrorNorm::scales(const MechanicalSystem& s) {
  unitScales(*s.parts().topology, length_, q_, u_);
}

namespace {

/// For each system, one representative system of its island. Two-sided contacts couple the systems
/// of an island, directly or through other systems.
std::vector<std::size_t> islands(const Topology& topology, const ContactSet& c) {
  const std::size_t n = topology.systems().size();
  std::vector<std::size_t> systemOf(static_cast<std::size_t>(topology.nu()));
  for (std::size_t k = 0; k < n; ++k) {
    const SystemHandle& h = topology.system(static_cast<int>(k));
    std::fill_n(systemOf.begin() + h.u0, h.nu, k);
  }
  boost::disjoint_sets_with_storage<> sets(n);
  for (std::size_t i = 0; i < c.law.size(); ++i) {
    if (c.law[i]->unilateral()) continue;
    const auto system = [&](int k) {
      return systemOf[static_cast<std::size_t>(c.segment[static_cast<std::size_t>(k)].u0)];
    };
    for (int k = c.segment0[i] + 1; k < c.segment0[i + 1]; ++k)
      sets.union_set(system(c.segment0[i]), system(k));
  }
  std::vector<std::size_t> out(n);
  for (std::size_t k = 0; k < n; ++k) out[k] = sets.find_set(k);
  return out;
}

/// 1/T of a motion with `rate` [1/s] and `acceleration` [1/s²], both in units of s_i.
double inverseTime(double rate, double acceleration) { return rate + std::sqrt(acceleration); }

bool isTime(double inverse) { return inverse > 0.0 && std::isfinite(inverse); }

}  // namespace

void ErrorNorm::start(const MechanicalSystem& s, const State& x, int slot, double tolerance,
                      double length, const ContactSet& contacts) {
  tolerance_ = tolerance, length_ = length;
  scales(s);
  const Topology& topology = *s.parts().topology;
  const Evaluation& e = s.slot(slot);
  Eigen::VectorXd a(e.h.size());
  e.mass.applyInverse(view(e.h), view(a));
  const std::vector<std::size_t> island = islands(topology, contacts);
  std::vector<double> rate(island.size(), 0.0), acceleration(island.size(), 0.0);
  for (std::size_t k = 0; k < island.size(); ++k) {
    const SystemHandle& h = topology.system(static_cast<int>(k));
    double &most = rate[island[k]], &mostA = acceleration[island[k]];
    for (Eigen::Index i = h.u0; i < h.u0 + h.nu; ++i) {
      most = std::max(most, std::abs(x.u[i]) / u_[i]);
      mostA = std::max(mostA, std::abs(a[i]) / u_[i]);
    }
  }
  const auto largest = [](const std::vector<double>& v) {
    return v.empty() ? 0.0 : *std::max_element(v.begin(), v.end());
  };
  const double all = inverseTime(largest(rate), largest(acceleration));
  time_ = isTime(all) ? 1.0 / all : 1.0;
  times_.resize(static_cast<Eigen::Index>(island.size()));
  for (std::size_t k = 0; k < island.size(); ++k) {
    // An island that does not move yet will be moved by others: it gets their time.
    const double own = inverseTime(rate[island[k]], acceleration[island[k]]);
    times_[static_cast<Eigen::Index>(k)] = isTime(own) ? 1.0 / own : time_;
  }
  speeds(topology);
}

void ErrorNorm::resume(const MechanicalSystem& s, double tolerance, double length, double time,
                       ConstVec times) {
  tolerance_ = tolerance, length_ = length, time_ = time, times_ = times;
  scales(s);
  speeds(*s.parts().topology);
}

void ErrorNorm::speeds(const Topology& topology) {
  speed_ = u_;
  for (Eigen::Index k = 0; k < times_.size(); ++k) {
    const SystemHandle& h = topology.system(static_cast<int>(k));
    speed_.segment(h.u0, h.nu) /= times_[k];
  }
}

double ErrorNorm::position(Eigen::Index i, double error, double value) const {
  return std::abs(error) / (tolerance_ * std::max(q_[i], std::abs(value)));
}

double ErrorNorm::fastestTurn(const Eigen::VectorXd& u, Eigen::Index first, Eigen::Index n) const {
  double fastest = 0.0;
  for (Eigen::Index i = first; i < first + n; ++i)
    if (u_[i] == 1.0) fastest = std::max(fastest, std::abs(u[i]));
  return fastest;
}

double ErrorNorm::velocity(Eigen::Index i, double error, double value) const {
  return std::abs(error) / (tolerance_ * std::max(speed_[i], std::abs(value)));
}

}  // namespace dynamy
