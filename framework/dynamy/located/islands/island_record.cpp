#include <algorithm>
#include <cmath>
#include <dynamy/located/islands/island_record.hpp>

namespace dynamy {
namespace {

template <class F>
void eachWork(F&& f) {
  f(&StepWorks::nonPotential), f(&StepWorks::friction), f(&StepWorks::normal);
  f(&StepWorks::joints), f(&StepWorks::boundaries);
}

}  // namespace

void IslandRecord::begin(RunPatience* patience) {
  patience_ = patience;
  if (!reported_) return;
  reported_ = endedByMotion_ = false;
  counts_ = {}, works_ = {}, solved_ = {}, impacts_.clear(), percussions_.clear();
}

void IslandRecord::effort(IslandClock& c) {
  const StepEffort& e = c.now().report.counts.effort;
  if (patience_ != nullptr) patience_->spend(c.motion().spent());
  StepEffort& sum = counts_.effort;
  sum.smooth += e.smooth, sum.rejected += e.rejected;
  sum.switches += e.switches, sum.events += e.events;
  sum.looks += e.looks, sum.gaps += e.gaps;
}

void IslandRecord::end(IslandClock& c) {
  if (c.counted) return;
  c.counted = true;
  const StepReport& r = c.now().report;
  counts_.rejected += r.counts.rejected, counts_.switches += r.counts.switches;
  counts_.impacts += r.counts.impacts, counts_.accumulations += r.counts.accumulations;
  counts_.undecided += r.counts.undecided;
  if (r.counts.accumulations > 0) counts_.accumulationEnd = r.counts.accumulationEnd;
  counts_.unseen = std::max(counts_.unseen, r.counts.unseen);
  eachWork([&](double StepWorks::*w) { works_.*w += r.works.*w - c.booked.*w; });
  addPercussions(c.system().problem());
  impacts_.insert(impacts_.end(), r.impacts.begin(), r.impacts.end());
  endedByMotion_ = endedByMotion_ || c.motion().motion().parts().endedByMotion;
  const int iterations = solved_.iterations + r.solved.iterations;
  if (!r.solved.ok() || r.solved.residuals.largest() > solved_.residuals.largest())
    solved_ = r.solved, solved_.residuals.worst = -1;
  solved_.iterations = iterations;
}

void IslandRecord::addPercussions(const ImpactProblem& p) {
  const ContactSet& c = *p.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const int first = c.row0[static_cast<std::size_t>(i)], dim = c.dim(i);
    if (p.Lambda().segment(first, dim).isZero(0.0)) continue;
    Percussion& q = percussions_.emplace_back();
    q.key = c.key[static_cast<std::size_t>(i)], q.dim = dim;
    for (int r = 0; r < dim; ++r) {
      const auto k = static_cast<std::size_t>(r);
      q.Lambda[k] = p.Lambda()[first + r];
      q.gammaMinus[k] = p.gammaA[static_cast<std::size_t>(first + r)];
    }
  }
}

/// Works are known at the end of the step. Up to t they are taken in proportion to time, but for the
/// largest: it makes up for what T + V has changed by until then.
void IslandRecord::pass(MechanicalSystem& s, IslandClock& c, double t) {
  const IslandStep& now = c.now();
  if (c.counted || !(now.to.t > now.from.t)) return;
  // An impact at the end of the step has its works there.
  const double share = (t - now.from.t) / (now.to.t - now.from.t);
  const std::array<double, 5>& smooth = c.motion().motion().parts().motion.step.last().works();
  std::array<double, 5> upTo{};
  std::size_t largest = 0;
  double sum = 0.0;
  for (std::size_t k = 0; k < smooth.size(); ++k) {
    sum += upTo[k] = share * smooth[k];
    if (std::abs(smooth[k]) > std::abs(smooth[largest])) largest = k;
  }
  if (smooth[largest] != 0.0) upTo[largest] += c.gained(s, t) - sum;
  std::size_t k = 0;
  eachWork([&](double StepWorks::*w) {
    works_.*w += upTo[k] - c.booked.*w, c.booked.*w = upTo[k];
    ++k;
  });
}

void IslandRecord::report(StepReport& report) {
  const StepCounts& c = counts_;
  report.counts.effort = c.effort;
  report.counts.rejected += c.rejected, report.counts.switches += c.switches;
  report.counts.impacts += c.impacts, report.counts.accumulations += c.accumulations;
  report.counts.undecided += c.undecided, report.counts.accumulationEnd = c.accumulationEnd;
  report.counts.unseen = std::max(report.counts.unseen, c.unseen);
  report.works = works_;
  reported_ = true;
}

const std::vector<LocatedImpact>& IslandRecord::impacts() {
  std::stable_sort(impacts_.begin(), impacts_.end(),
                   [](const LocatedImpact& a, const LocatedImpact& b) { return a.t < b.t; });
  return impacts_;
}

}  // namespace dynamy
