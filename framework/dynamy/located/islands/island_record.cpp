#include <algorithm>
#include <dynamy/located/islands/island_record.hpp>

namespace dynamy {
namespace {

template <class F>
void eachWork(F&& f) {
  f(&StepWorks::nonPotential), f(&StepWorks::friction), f(&StepWorks::normal);
  f(&StepWorks::joints), f(&StepWorks::boundaries);
}

}  // namespace

void IslandRecord::begin() {
  if (!reported_) return;
  reported_ = endedByMotion_ = false;
  counts_ = {}, works_ = {}, solved_ = {}, impacts_.clear();
}

void IslandRecord::effort(const StepEffort& e) {
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
  impacts_.insert(impacts_.end(), r.impacts.begin(), r.impacts.end());
  endedByMotion_ = endedByMotion_ || c.motion().motion().parts().endedByMotion;
  const int iterations = solved_.iterations + r.solved.iterations;
  if (!r.solved.ok() || r.solved.residuals.largest() > solved_.residuals.largest())
    solved_ = r.solved, solved_.residuals.worst = -1;
  solved_.iterations = iterations;
}

void IslandRecord::pass(IslandClock& c, double t) {
  if (c.counted || !(c.now().to.t > c.now().from.t)) return;
  // An impact at the end of the step has its works there.
  const double share = (t - c.now().from.t) / (c.now().to.t - c.now().from.t);
  const std::array<double, 5>& smooth = c.motion().motion().parts().motion.step.last().works();
  std::size_t k = 0;
  eachWork([&](double StepWorks::*w) {
    const double upTo = share * smooth[k++];
    works_.*w += upTo - c.booked.*w, c.booked.*w = upTo;
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
