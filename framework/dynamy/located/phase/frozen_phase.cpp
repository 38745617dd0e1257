#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/frozen_phase.hpp>
#include <dynamy/stages/one_step.hpp>
#include <utility>

namespace dynamy {
namespace {

constexpr double kClearMargin = 1e-3;  ///< of the largest force
constexpr double kOwnForce = 1e-3;     ///< of the largest force: least size of a contact's own
constexpr int kMostSlipTurns = 200;    ///< iterations for the directions of slips that start

}  // namespace

bool FrozenPhase::read(const Evaluation& e, const Eigen::VectorXd& u) {
  return rows_.read(held, e, u, fault_);
}

bool FrozenPhase::accelerate(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a) {
  fault_.why.clear();
  if (!read(e, u) || !rows_.readSets(held, e, fault_)) return false;
  forces_.solve(held, rows_, e, rows_.present());
  startDirections(e);
  a = forces_.a();
  finish(e, u);
  return true;
}

bool FrozenPhase::advance(const Evaluation& e, const Eigen::VectorXd& u, const ContactSet& next,
                          const Eigen::VectorXd& before, double tau, Eigen::VectorXd& a) {
  fault_.why.clear();
  if (!read(e, u) || !rows_.readSets(held, e, fault_) ||
      !rows_.readNext(held, next, before, tau, next_, fault_))
    return false;
  if (std::any_of(held.begin(), held.end(), [](const Held& h) { return h.starts; })) {
    forces_.solve(held, rows_, e, rows_.present());
    startDirections(e);
  }
  // Wᵀ(q_{k+1}) (u_{k−1} + τ a) + χ = 0.
  forces_.solve(held, rows_, e, next_);
  a = forces_.a();
  finish(e, u);
  return true;
}

bool FrozenPhase::margin(std::size_t i, double& value) const {
  const Eigen::VectorXd& lambda = forces_.lambda();
  std::size_t first = i;
  while (first > 0 && held[first].first > 0) --first;  // the part with the normal row
  return rows_.set(i).margin(
      held[i].slips, {lambda.data() + rows_.row0(i), static_cast<std::size_t>(rows_.dim(i))},
      lambda[rows_.row0(first)], rows_.gamma().data() + rows_.row0(i), value);
}

double FrozenPhase::leastMargin() const {
  double least = 1e300, value = 0.0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (margin(i, value)) least = std::min(least, value);
  return least;
}

bool FrozenPhase::share(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a,
                        bool same) {
  for (Held& h : held) h.implied = 0;
  if (!accelerate(e, u, a)) return false;
  if (!forces_.redundant()) return true;
  const std::vector<Held> decided = held;
  const auto take = [&](double part, bool weighted) {
    for (std::size_t i = 0; i < held.size(); ++i) {
      held[i].weight = weighted ? decided[i].weight : 1.0;
      for (std::size_t r = 0; r < held[i].lambda.size(); ++r)
        held[i].lambda[r] = part * decided[i].lambda[r];
    }
  };
  // Where slips differ, the motion depends on how redundant rows share. The smallest forces, if all
  // bounds permit them, are a choice that depends neither on rounding nor on a solver.
  double best = 1.0, least = leastMargin();
  bool bestWeighted = true;
  take(0.0, false);
  if (!accelerate(e, u, a)) return false;
  if (leastMargin() > kClearMargin * forceScale_) return true;
  for (const bool weighted : {true, false})
    for (const double part : {0.0, 0.25, 0.5, 0.75}) {
      take(part, weighted);
      if (!accelerate(e, u, a)) return false;
      if (const double margin = leastMargin(); margin > least)
        least = margin, best = part, bestWeighted = weighted;
    }
  take(best, bestWeighted);
  if (!accelerate(e, u, a)) return false;
  if (!same) return true;
  shared_.open(held, rows_, forces_.open());
  return !nearBound() || centre(e, u, a);
}

/// True: a force that depends on how rows share is near its bound, as a part of this force.
bool FrozenPhase::nearBound() const {
  const Eigen::VectorXd& lambda = forces_.lambda();
  double value = 0.0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (shared_.shares(i) && margin(i, value) &&
        !(value >
          kClearMargin * lambda.segment(rows_.row0(i), rows_.dim(i)).lpNorm<Eigen::Infinity>()))
      return true;
  return false;
}

/// Takes the centre of the forces that the statuses permit, if there is one.
bool FrozenPhase::centre(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a) {
  Eigen::VectorXd lambda = forces_.lambda();
  if (!shared_.centre(held, rows_, lambda)) return true;
  for (std::size_t i = 0; i < held.size(); ++i) {
    Held& h = held[i];
    const int first = rows_.row0(i), d = std::min(rows_.dim(i), kMostRows);
    for (int r = 0; r < d; ++r) h.lambda[static_cast<std::size_t>(r)] = lambda[first + r];
    const ForceSet::Form form = rows_.set(i).form;
    const bool pressed = form == ForceSet::Form::cone || form == ForceSet::Form::reservoir;
    if (shared_.shares(i) && pressed && lambda[first] > 0.0) h.weight = lambda[first];
  }
  return accelerate(e, u, a);
}

double FrozenPhase::contradiction() const {
  double worst = 0.0, unused = 0.0;
  for (std::size_t i = 0; i < held.size() && forces_.redundant(); ++i) {
    if (held[i].slips || !margin(i, unused)) continue;
    const auto own = forces_.lambda().segment(rows_.row0(i), rows_.dim(i));
    const double least = kOwnForce * forces_.lambda().lpNorm<Eigen::Infinity>();
    const double scale = std::max(own.lpNorm<Eigen::Infinity>(), least);
    for (int row = rows_.row0(i); row < rows_.row0(i) + rows_.dim(i); ++row) {
      double G = 0.0;
      for (const HeldRows::Moved& p : rows_.moved(row))
        G += rows_.W().col(row).segment(p.u0, p.nu).dot(rows_.MInvW().col(row).segment(p.u0, p.nu));
      if (G > 0.0 && scale > 0.0) worst = std::max(worst, std::abs(gammaDot_[row]) / (G * scale));
    }
  }
  return worst;
}

/// Finds the directions of slips that start: forces depend on them, and they on the forces.
void FrozenPhase::startDirections(const Evaluation& e) {
  slips_.begin();
  for (int turns = 0; turns < kMostSlipTurns; ++turns) {
    const bool turned = slips_.turn(held, rows_, forces_);
    if (!turned) return;
    forces_.solve(held, rows_, e, rows_.present());
  }
}

void FrozenPhase::finish(const Evaluation& e, const Eigen::VectorXd& u) {
  cubes += std::exchange(forces_.cubes, 0.0);
  const Eigen::VectorXd& lambda = forces_.lambda();
  gammaDot_ = rows_.present().r;
  for (int row = 0; row < rows_.size(); ++row) gammaDot_[row] += rows_.along(row, forces_.a());
  forceScale_ = lambda.size() > 0 ? lambda.lpNorm<Eigen::Infinity>() : 0.0;
  power_ = {e.hNonPotential.dot(u), 0.0, 0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < held.size(); ++i) {
    const ForceSet& set = rows_.set(i);
    const bool given = set.form == ForceSet::Form::given || set.form == ForceSet::Form::notch;
    if (given && std::isfinite(set.upper)) forceScale_ = std::max(forceScale_, set.upper);
    const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(rows_.contact(i))];
    for (int r = 0; r < rows_.dim(i); ++r) {
      const int row = rows_.row0(i) + r;
      bookWork(power_, law.rowKind(held[i].first + r), lambda[row], rows_.gamma()[row],
               rows_.chi()[row]);
    }
  }
}

}  // namespace dynamy
