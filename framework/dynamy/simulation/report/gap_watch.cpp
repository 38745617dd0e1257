#include <algorithm>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/gap_watch.hpp>

namespace dynamy {
namespace {

/// Gaps at the end of a step are evaluated if the extrapolated depth exceeds all before by the
/// factor kDeeper. This is done kFirstLooks times, then once in kStepsPerLook steps on average.
/// Each evaluation costs up to a step, so that a run of 1000 steps takes 1.6 % longer. Beyond that
/// the depth is extrapolated by γ^E alone, with an error of (ω Δt/2)²/2 of a body's size.
constexpr double kDeeper = 1.01;
constexpr long kFirstLooks = 8, kStepsPerLook = 128;
/// Rows of a step that are looked at.
constexpr int kMostRowsSeen = 50;
constexpr double kOverlapNoise = 1e-12;  ///< of the scene's length
constexpr double kOverlapSeen = 1e-6;    ///< the same: bodies were inside each other

}  // namespace

GapWatch::GapWatch(Model& model, RunReport& report)
    : model_(model), report_(report), rows_(model.record, model.simulation.until) {}

void GapWatch::start(const StepView& initial) {
  const std::vector<const SetValuedForceLaw*>& laws = initial.system.slot(0).contacts.law;
  rows_ = RowInstants(model_.record, model_.simulation.until);  // settings at the start of the run
  joints_ = std::any_of(laws.begin(), laws.end(),
                        [](const SetValuedForceLaw* law) { return holds(law->rowKind(0)); });
  positions(initial.after);
  report_.gaps.atStart = report_.gaps.penetration;
}

void GapWatch::rows(const StepView& view) {
  const double from = view.before.t, to = view.after.t;
  rows_.after(from);
  for (int i = 0; i < kMostRowsSeen && rows_.next() <= to; ++i, rows_.pass()) {
    const double theta = (rows_.next() - from) / (to - from);
    view.scheme.interpolate(view.system, view.before, view.after, theta, at_);
    at_.memory = view.before.memory;
    overlaps(at_);
  }
}

void GapWatch::step(const StepView& view) {
  if (view.scheme.choosesSteps()) {
    const bool overlapped = report_.gaps.penetration.value > kOverlapSeen * model_.length();
    if (view.report.counts.stepped || overlapped) rows(view);
    return;
  }
  // Bodies that pass others unseen, and those that damped forces move away from the path that the
  // step looked at, end in overlaps that the step itself has not evaluated.
  if (report_.passing.left > 0 || report_.trust.damped > 0) return overlaps(view.after);
  const ContactSet& c = view.system.slot(0).contacts;
  const double rest = view.after.t - view.system.slot(0).t;
  const double known = kDeeper * report_.gaps.penetration.value + kOverlapNoise * model_.length();
  if (!(rest > 0.0) || view.gammaE.size() != c.rows()) return;
  // With joints the positions may follow the mean velocity.
  const std::vector<double>& gammaA = view.system.problem().gammaA;
  const bool mean = joints_ && gammaA.size() == static_cast<std::size_t>(c.rows());
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!c.law[at]->unilateral()) continue;
    const int row = c.row0[at];
    double rate = view.gammaE[row];
    if (mean) rate = std::min(rate, 0.5 * (rate + gammaA[static_cast<std::size_t>(row)]));
    const double deep = -c.position[static_cast<std::size_t>(row)] - rest * rate;
    if (!(deep > known)) continue;
    if (looks_ <= kFirstLooks + view.index / kStepsPerLook) {
      ++looks_;
      overlaps(view.after);
      return;
    }
    Worst& worst = report_.gaps.penetration;
    if (!mean && deep > worst.value)
      worst.value = deep, worst.t = view.after.t, worst.contact = c.key[at];
  }
}

void GapWatch::sample(const StepView& view) {
  // Joints are held at ends of steps, where steps do not evaluate them; every step, and step(),
  // examines overlaps.
  const std::vector<const SetValuedForceLaw*>& laws = view.system.slot(0).contacts.law;
  if (std::any_of(laws.begin(), laws.end(), [](const auto* law) { return !law->unilateral(); }))
    positions(view.after);
}

MechanicalSystem& GapWatch::ends() {
  if (!ends_) ends_ = std::make_unique<MechanicalSystem>(model_.mechanicalSystem());
  return *ends_;
}

void GapWatch::overlaps(const State& x) {
  const ContactSet& c = look_.at(ends(), x);
  Worst& worst = report_.gaps.penetration;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    const int closed = c.closedIndex[i];
    if (closed >= 0 && !c.law[static_cast<std::size_t>(closed)]->unilateral()) continue;
    if (-c.g[i] > worst.value)
      worst.value = -c.g[i], worst.t = x.t, worst.contact = c.candidateKey[i];
  }
}

void GapWatch::positions(const State& x) {
  const ContactSet& c = ends().evaluate(x).contacts;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    const int closed = c.closedIndex[i];
    const SetValuedForceLaw* law = closed >= 0 ? c.law[static_cast<std::size_t>(closed)] : nullptr;
    const bool joint = law != nullptr && !law->unilateral();
    if (joint && law->rowKind(0) != RowKind::joint) continue;  // others have no position error
    Worst& worst = joint ? report_.gaps.jointError : report_.gaps.penetration;
    const double value = joint ? c.g[i] : -c.g[i];
    if (value > worst.value) worst.value = value, worst.t = x.t, worst.contact = c.candidateKey[i];
  }
}

}  // namespace dynamy
