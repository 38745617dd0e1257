// MechanicalSystem: contacts alone, and the bias of elements that report none.
#include <algorithm>
#include <cmath>
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {
namespace {

/// Length of the difference over the time in which x passes through its scales: truncation 3e-14,
/// rounding 1e-13 of the rate of γ.
constexpr double kBesideState = 1e-3;
/// Number of shorter differences where contacts come or go within the difference, and the factor of
/// each: the last one has a rounding of 3e-11.
constexpr int kShorterLooks = 2;
constexpr double kShorten = 1.0 / 16.0;

/// Rate at which x passes through `scales`, at least 1/time [1/s].
double goesThrough(const State& x, const Eigen::VectorXd* scales, double time) {
  double rate = 1.0 / time;
  for (Eigen::Index i = 0; scales && i < x.u.size(); ++i)
    rate = std::max(rate, std::abs(x.u[i]) / (*scales)[i]);
  return rate;
}

}  // namespace

const ContactSet& MechanicalSystem::look(const State& x) {
  ContactSet& c = look_.contacts;
  look_.kinematics.evaluate(*parts_.topology, x.t, view(x.q), view(x.u), view(x.memory));
  c.clear();
  ContactRequest request = request_;
  request.bias = false;
  ContactSink sink(c, request);
  reportContacts(parts_, look_.kinematics, sink);
  return c;
}

bool MechanicalSystem::differenceBias(const State& x, Eigen::VectorXd& out, double aside) {
  const double d = kBesideState / goesThrough(x, differenceScales_, differenceTime_);
  const double weight[4] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0},
               at[4] = {-2.0, -1.0, 1.0, 2.0};
  for (int p = 0; p < 4; ++p) {
    lookState_.t = x.t, lookState_.q = x.q, lookState_.u = x.u, lookState_.memory = x.memory;
    move(lookState_, x.u, (at[p] + aside) * d);
    const ContactSet& c = look(lookState_);
    if (p == 0) out.setZero(c.rows());
    if (out.size() != c.rows()) return false;
    gammaLook_.resize(c.rows());
    c.gamma(view(x.u), view(gammaLook_));
    out += weight[p] / d * gammaLook_;
  }
  return true;
}

void MechanicalSystem::tellDifferences(const State& x, Evaluation& e) {
  ContactSet& c = e.contacts;
  const auto differenced = [&](int i) {
    return std::binary_search(differenced_.begin(), differenced_.end(),
                              c.element[static_cast<std::size_t>(i)]);
  };
  bool any = false;
  for (int i = 0; i < c.size() && !any; ++i) any = differenced(i);
  if (!any) return;
  const auto tell = [&] { return differenceBias(x, biasLook_) && biasLook_.size() == c.rows(); };
  const double time = differenceTime_;
  bool told = tell();
  for (int i = 0; i < kShorterLooks && !told; ++i) {
    differenceTime_ = kShorten / goesThrough(x, differenceScales_, differenceTime_);
    told = tell();
  }
  differenceTime_ = time;
  if (!told) return;
  for (int i = 0; i < c.size(); ++i)
    for (int r = 0; differenced(i) && r < c.dim(i); ++r) {
      const auto row = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)] + r);
      c.bias[row] = biasLook_[static_cast<Eigen::Index>(row)];
    }
}

}  // namespace dynamy
