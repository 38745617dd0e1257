#include <algorithm>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/recorder.hpp>
#include <set>
#include <utility>

namespace dynamy {
namespace {

/// Fraction of the step at which t lies; instants within 1e-9 of the step's end are its end.
double fraction(const StepView& v, double t) {
  const double dt = v.after.t - v.before.t;
  if (!(dt > 0.0) || t >= v.after.t - 1e-9 * dt) return 1.0;
  return std::clamp((t - v.before.t) / dt, 0.0, 1.0);
}

/// So many pictures of impacts more than of the film itself.
constexpr long kFewFrames = 50;

/// Is the instant t reached at the end of this step?
bool reached(const StepView& v, double t) {
  return t <= v.after.t + 1e-9 * (v.after.t - v.before.t);
}

}  // namespace

std::vector<DrawnFrame> drawnFrames(const Model& model) {
  std::vector<DrawnFrame> out;
  std::set<std::pair<int, int>> seen;
  const auto add = [&](int system, int id) {
    if (seen.insert({system, id}).second) out.push_back({system, id});
  };
  for (std::size_t i = 0; i < model.systems().size(); ++i)
    for (const PlacedShape& p : model.description(static_cast<int>(i)).shapes)
      add(static_cast<int>(i), p.frame);
  const auto& frames = model.topology().requestedFrames();
  for (const Description& d : model.descriptions())
    for (const PlacedLink& l : d.links)
      for (const int f : {l.frameA, l.frameB})
        add(frames[static_cast<std::size_t>(f)].first, frames[static_cast<std::size_t>(f)].second);
  return out;
}

Recorder::Recorder(const Model& model, RecordSink& sink)
    : sink_(sink),
      sampler_(model, chooseSignals(model, model.record.signals, model.record.places)),
      drawn_(model.topology().systems()),
      rows_(model.record, model.simulation.until),
      frames_(model.record.framesPerSecond > 0.0 ? 1.0 / model.record.framesPerSecond : 1.0 / 60) {
  for (const DrawnFrame& f : drawnFrames(model)) drawn_.frame(drawn_.system(f.system), f.id);
  if (model.record.framesPerSecond <= 0.0) drawn_ = Topology(model.topology().systems());
  kinematics_.resize(drawn_);
  values_.resize(sampler_.signals().size());
  poses_.resize(drawn_.requestedFrames().size());
}

void Recorder::start(const StepView& initial) {
  if (sampler_.readsForces())
    first_.resize(values_.size()), sampler_.sample(initial, 1.0, first_);
  else
    row(initial, initial.after.t, 1.0);
  frame(initial, initial.after.t, 1.0);
  rows_.startedAt(initial.after.t), nextFrame_ = 1;
}

/// Writes the row of the start, with the forces of the first step.
void Recorder::writeFirst(const StepView& view, bool forces) {
  if (first_.empty()) return;
  if (forces) sampler_.sampleForces(view, first_);
  values_.swap(first_);
  first_.clear();
  write(view.before.t);
}

void Recorder::step(const StepView& view) {
  writeFirst(view, true);
  for (double t = rows_.next(); reached(view, t) && fraction(view, t) < 1.0; t = rows_.next()) {
    row(view, t, fraction(view, t));
    rows_.pass();
  }
  // An impact whose instant is known has a row on each side of it.
  const bool jumps = view.report.uBeforeImpact != nullptr;
  if (jumps) {
    sampler_.sampleBeforeImpact(view, values_);
    write(view.after.t);
  }
  const bool due = reached(view, rows_.next());
  if (due || jumps) row(view, due ? rows_.next() : view.after.t, 1.0);
  if (due) rows_.pass();
  if (poses_.empty()) return;
  for (; reached(view, frames_.at(nextFrame_)); ++nextFrame_)
    frame(view, frames_.at(nextFrame_), fraction(view, frames_.at(nextFrame_)));
  if (jumps && impactFrames_ < nextFrame_ + kFewFrames && lastFrame_ < view.after.t)
    ++impactFrames_, frame(view, view.after.t, 1.0);
}

void Recorder::finish(const StepView& last) {
  writeFirst(last, false);
  if (!last.whole || last.report.dt <= 0.0) return;
  const double near = 1e-9 * last.report.dt;
  if (lastRow_ < last.after.t - near) row(last, last.after.t, 1.0);
  if (!poses_.empty() && lastFrame_ < last.after.t - near) frame(last, last.after.t, 1.0);
}

void Recorder::row(const StepView& view, double t, double theta) {
  sampler_.sample(view, theta, values_);
  write(t);
}

void Recorder::write(double t) {
  lastRow_ = t;
  sink_.row(t, values_);
}

void Recorder::frame(const StepView& view, double t, double theta) {
  if (poses_.empty()) return;
  if (theta >= 1.0)
    at_.t = view.after.t, at_.q = view.after.q, at_.u = view.after.u;
  else
    view.scheme.interpolate(view.system, view.before, view.after, theta, at_);
  at_.memory = theta >= 1.0 ? view.after.memory : view.before.memory;  // changed at ends alone
  kinematics_.evaluate(drawn_, at_.t, dynamy::view(std::as_const(at_.q)),
                       dynamy::view(std::as_const(at_.u)));
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const Frame& f = kinematics_.frame({static_cast<int>(i)});
    poses_[i] = {f.r_OS_I, f.A_IK, f.absent};
  }
  contacts(view, theta >= 1.0);
  lastFrame_ = t;
  sink_.frame({t, view.report.dt}, poses_, contacts_);
}

/// Contacts where they are at at_, with their forces then, and at the end of the step its impacts with
/// their percussions. All with the percussions of the step, if the scheme knows no others.
void Recorder::contacts(const StepView& view, bool atEnd) {
  contacts_.clear(), hit_.clear();
  for (const Resting& r : resting_) contacts_.push_back(r.record);
  if (view.report.dt <= 0.0) return;
  const auto placed = [](const ContactSet& c, int i) {
    return !c.places.normal[static_cast<std::size_t>(i)].isZero(0.0);
  };
  const bool known = view.scheme.contactsAt(view.system, at_, atEnd, instant_);
  const ContactSet& c = view.system.slot(0).contacts;
  if ((atEnd || !known) && view.Lambda.size() == c.rows()) {
    impacts_.look();
    for (int i = 0; i < c.size(); ++i) {
      if (!placed(c, i) || (known && !impacts_(view, i))) continue;
      contacts_.push_back(contactRecord(view, impacts_, i));
      if (known) hit_.push_back(c.key[static_cast<std::size_t>(i)]);
    }
  }
  if (!known) return;
  instant_.lambda *= view.report.dt;
  const ContactSet& now = *instant_.contacts;
  for (int i = 0; i < now.size(); ++i) {
    const ContactKey key = now.key[static_cast<std::size_t>(i)];
    if (placed(now, i) && std::find(hit_.begin(), hit_.end(), key) == hit_.end())
      contacts_.push_back(contactRecord(view, instant_, i));
  }
}

void Recorder::rest(const StepView& view, const std::vector<ContactKey>& contacts) {
  const ContactSet& c = view.system.slot(0).contacts;
  impacts_.look();
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (c.places.normal[at].isZero(0.0)) continue;
    if (!std::binary_search(contacts.begin(), contacts.end(), c.key[at])) continue;
    resting_.push_back({c.key[at], contactRecord(view, impacts_, i)});
    resting_.back().record.impact = false;
  }
}

void Recorder::wake(const std::vector<ContactKey>& contacts) {
  std::erase_if(resting_, [&](const Resting& r) {
    return std::binary_search(contacts.begin(), contacts.end(), r.key);
  });
}

void Recorder::Resting::archive(Archive& a) {
  a(key);
  for (Vec3* v : {&record.point, &record.normal, &record.force})
    for (double& x : *v) a(x);
  a(record.status), a(record.limit), a(record.spin);
  if (record.status > Status::locked)
    throw ModelError("the checkpoint holds a contact with a status that does not exist");
}

void Recorder::archive(Archive& a) {
  a.section("recorder 3");  // the number counts changes of the layout
  std::uint64_t columns = values_.size();
  a(columns);
  if (columns != values_.size()) throw ModelError("the checkpoint records other signals");
  long nextRow = rows_.row();
  a(nextRow), a(nextFrame_), a(impactFrames_), a(lastRow_), a(lastFrame_), a(resting_), a(first_);
  if (!first_.empty() && first_.size() != values_.size())
    throw ModelError("the checkpoint holds a first row of other signals");
  if (nextRow < 0 || nextFrame_ < 0 || impactFrames_ < 0)
    throw ModelError("the checkpoint counts its recorded rows from below zero");
  rows_.resume(nextRow, lastRow_);
  sink_.archive(a);
}

}  // namespace dynamy
