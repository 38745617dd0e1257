#include <algorithm>
#include <dynamy/simulation/gradient/motion_sequence.hpp>

namespace dynamy {
namespace {

using Step = MotionSequence::Step;

/// The first contact whose status or impact is in one of two steps only; none: they are the same,
/// or differ by their end alone.
ContactKey differing(const Step& a, const Step& b) {
  const auto first = [](const auto& x, const auto& y, const auto& same) {
    const std::size_t n = std::min(x.size(), y.size());
    std::size_t i = 0;
    while (i < n && same(x[i], y[i])) ++i;
    return std::pair(i, i == x.size() && i == y.size());
  };
  const auto [i, sameImpacts] = first(a.impacts, b.impacts, std::equal_to<>());
  if (!sameImpacts) return i < a.impacts.size() ? a.impacts[i] : b.impacts[i];
  const auto [k, sameStatuses] = first(a.statuses, b.statuses, [](const auto& x, const auto& y) {
    return x.key == y.key && x.status == y.status;
  });
  if (!sameStatuses) return k < a.statuses.size() ? a.statuses[k].key : b.statuses[k].key;
  return kNoContact;
}

}  // namespace

void MotionSequence::add(const StepView& view, PlannedStep::End end) {
  Step& s = steps.emplace_back();
  s.step = {view.report.dt, end};
  s.t = view.after.t, s.switches = view.report.counts.switches;
  s.inTime = view.report.counts.stepped;
  if (end == PlannedStep::End::ofMotion)
    s.statuses.assign(view.report.statuses.begin(), view.report.statuses.end());
  for (const LocatedImpact& i : view.report.impacts) s.impacts.push_back(i.key);
}

std::vector<PlannedStep> MotionSequence::plan() const {
  std::vector<PlannedStep> out;
  for (const Step& s : steps) out.push_back(s.step);
  return out;
}

MotionSequence::Difference MotionSequence::from(const MotionSequence& other) const {
  const std::size_t n = std::min(steps.size(), other.steps.size());
  for (std::size_t i = 0; i < n; ++i) {
    const Step &a = steps[i], &b = other.steps[i];
    const ContactKey contact = differing(a, b);
    if (contact != kNoContact || a.step.end != b.step.end || a.inTime != b.inTime)
      return {true, std::min(a.t, b.t), contact};
  }
  if (steps.size() == other.steps.size()) return {};
  return {true, n > 0 ? steps[n - 1].t : 0.0, kNoContact};
}

}  // namespace dynamy
