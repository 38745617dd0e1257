#include <algorithm>
#include <cmath>
#include <dynamy/solver/impact/energy_guard.hpp>

namespace dynamy {
namespace {

/// Fraction of the energy turned over in a group that counts as solver error: the default tolerance
/// of 1e-10 with a reserve of 100.
constexpr double kEnergyNoise = 1e-8;
/// Trials per impact. The gain is nearly a parabola of the factor, so three to five suffice; the
/// last one is the accepted end of the bracket.
constexpr int kEnergyTrials = 8;
/// Percussions that solve nothing are reduced if ½ ΛᵀGΛ exceeds |Λᵀγ_free| by this factor.
constexpr double kAddsEnergy = 2.0;

}  // namespace

void ContactGroups::find(InclusionProblem& problem) {
  const int n = problem.size();
  group_.assign(static_cast<std::size_t>(n), -1);
  size_ = 0;
  for (int seed = 0; seed < n; ++seed) {
    if (of(seed) >= 0) continue;
    queue_.assign(1, seed);
    group_[static_cast<std::size_t>(seed)] = size_;
    for (std::size_t at = 0; at < queue_.size(); ++at) {
      problem.G->neighbours(queue_[at], near_);
      for (const int j : near_) {
        if (of(j) >= 0) continue;
        group_[static_cast<std::size_t>(j)] = size_;
        queue_.push_back(j);
      }
    }
    ++size_;
  }
}

std::vector<double>& EnergyGuard::factor(const InclusionProblem& problem) {
  factor_.assign(static_cast<std::size_t>(problem.size()), 1.0);
  return factor_;
}

void EnergyGuard::gains(InclusionProblem& problem, ConstVec Lambda) {
  const auto groups = static_cast<std::size_t>(groups_.size());
  gammaE_.resize(static_cast<std::size_t>(problem.rows()));
  problem.G->apply(Lambda.data(), gammaE_.data());
  gainA_.assign(groups, 0.0), gainFree_.assign(groups, 0.0), scale_.assign(groups, 0.0);
  for (int i = 0; i < problem.size(); ++i) {
    const auto g = static_cast<std::size_t>(groups_.of(i));
    for (int r = 0; r < problem.dim(i); ++r) {
      // Joints do no work; their rows only show the rotation of W within the step.
      if (holds(problem.law(i).rowKind(r))) continue;
      const auto k = static_cast<std::size_t>(problem.row0(i) + r);
      const double L = Lambda[problem.row0(i) + r], free = problem.gammaFree[k];
      const double end = free + gammaE_[k], begin = problem.gammaA[k];
      gainA_[g] += 0.5 * L * (begin + end), gainFree_[g] += 0.5 * L * (free + end);
      scale_[g] += 0.5 * std::abs(L) * (std::abs(begin) + std::abs(end) + std::abs(free));
    }
  }
  for (std::size_t g = 0; g < groups; ++g)  // only what is beyond rounding counts as gain
    gainA_[g] = std::min(gainA_[g], gainFree_[g]) - kEnergyNoise * scale_[g];
}

void EnergyGuard::begin(InclusionProblem& problem, ConstVec Lambda) {
  groups_.find(problem);
  gains(problem, Lambda);
  gain_ = 0.0, gaining_ = 0, trials_ = 0;
  search_.assign(static_cast<std::size_t>(groups_.size()), {});
  for (std::size_t g = 0; g < search_.size(); ++g) {
    if (!(gainA_[g] > 0.0)) continue;
    search_[g].active = true, search_[g].gainHigh = gainA_[g];
    gain_ += gainA_[g];
    ++gaining_;
  }
}

bool EnergyGuard::bound(InclusionProblem& problem, Vec Lambda) {
  if (!Lambda.allFinite()) {
    Lambda.setZero();
    return true;
  }
  groups_.find(problem);
  const auto groups = static_cast<std::size_t>(groups_.size());
  std::vector<double>&free = gainFree_, &own = gainA_;
  free.assign(groups, 0.0), own.assign(groups, 0.0);
  gammaE_.resize(static_cast<std::size_t>(problem.rows()));
  problem.G->apply(Lambda.data(), gammaE_.data());
  for (int i = 0; i < problem.size(); ++i)
    for (int k = problem.row0(i); k < problem.row0(i) + problem.dim(i); ++k) {
      const auto g = static_cast<std::size_t>(groups_.of(i)), row = static_cast<std::size_t>(k);
      free[g] += Lambda[k] * problem.gammaFree[row], own[g] += 0.5 * Lambda[k] * gammaE_[row];
    }
  bool reduced = false;
  for (int i = 0; i < problem.size(); ++i) {
    const auto g = static_cast<std::size_t>(groups_.of(i));
    if (own[g] <= kAddsEnergy * std::abs(free[g])) continue;
    Lambda.segment(problem.row0(i), problem.dim(i)) *= std::max(0.0, -free[g] / own[g]);
    reduced = true;
  }
  return reduced;
}

bool EnergyGuard::next() {
  if (trials_ > kEnergyTrials) return false;
  for (Search& s : search_) {
    if (!s.active) continue;
    if (trials_ == 0 || trials_ == kEnergyTrials)
      s.trial = s.low;  // the safe end: tried first to know its gain, last to accept it
    else if (trials_ % 2 == 1 && s.gainHigh > s.gainLow)
      s.trial =
          s.low + (s.high - s.low) * std::clamp(-s.gainLow / (s.gainHigh - s.gainLow), 0.02, 0.98);
    else
      s.trial = 0.5 * (s.low + s.high);
  }
  for (std::size_t i = 0; i < factor_.size(); ++i) {
    const Search& s = search_[static_cast<std::size_t>(groups_.of(static_cast<int>(i)))];
    if (s.active) factor_[i] = s.trial;
  }
  ++trials_;
  return true;
}

void EnergyGuard::judge(InclusionProblem& problem, ConstVec Lambda) {
  gains(problem, Lambda);
  for (std::size_t g = 0; g < search_.size(); ++g) {
    Search& s = search_[g];
    if (!s.active || s.trial > s.high) continue;
    if (gainA_[g] > 0.0)
      s.high = s.trial, s.gainHigh = gainA_[g];
    else
      s.low = s.trial, s.gainLow = gainA_[g];
  }
}

}  // namespace dynamy
