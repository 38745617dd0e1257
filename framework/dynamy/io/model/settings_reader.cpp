#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/declared/two_names.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/settings_reader.hpp>
#include <dynamy/io/run_files/model_scene.hpp>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/run_watch.hpp>

namespace dynamy {
namespace {

/// What to record for an acceleration, which no element has; "" if the name is of no acceleration.
std::string accelerationHint(const std::string& signal, const std::vector<std::string>& known) {
  const std::size_t dot = signal.rfind('.') + 1;
  const std::string last = signal.substr(dot);
  constexpr std::string_view kWords =
      " a ax ay az acc accel acceleration accx accy accz acc_x acc_y acc_z a_x a_y a_z alpha vdot ";
  if (dot == 0 || kWords.find(' ' + last + ' ') == std::string_view::npos) return {};
  const bool one = last.size() > 1 && last.back() >= 'x' && last.back() <= 'z';
  const std::string velocity = signal.substr(0, dot) + 'v' + (one ? last.back() : 'z');
  if (std::find(known.begin(), known.end(), velocity) == known.end()) return {};
  return "accelerations are no signals, since impacts change velocities at once; a mean over 1 ms "
         "is "
         "the signal a.out of <TransferFunction name=\"a\" of=\"" +
         velocity + "\" numerator=\"1 0\" denominator=\"1e-3 1\"/> in <forces>";
}

constexpr double kTimeRounding = 1e-9;  ///< relative rounding of formulas for two equal times

}  // namespace

void SettingsReader::read(const ModelItem& item) {
  const XmlNode& node = *item.node;
  const Scope& scope = *item.scope;
  const Word& word = *source_->vocabulary().find(node.tag);
  if (!isOnly(node, scope)) return;
  if (node.tag == "simulation") readMethods(node, scope);
  if (node.tag != "simulation")
    for (const XmlNode& child : node.children)
      if (child.tag != "doc")
        faults_->add(scope, child.place, node, "unknown element <" + child.tag + '>',
                     "known here: \"doc\"");
  Parameters x;
  x.type = node.tag;
  if (!attributes_.read(node, scope, word.attributes, {}, x)) return;
  if (node.tag == "simulation") readSimulation(node, scope, x);
  if (node.tag == "record") readRecord(node, scope, x);
  if (node.tag == "check") readCheck(node, scope, x);
  if (node.tag == "orbit") readOrbit(node, scope, x);
}

/// A model has one section of a kind, checks apart. Rejected: to merge them, which hides a section that
/// was left over, and its values.
bool SettingsReader::isOnly(const XmlNode& node, const Scope& scope) {
  if (node.tag == "check") return true;
  const auto [first, isNew] = sections_.emplace(node.tag, node.place);
  if (isNew) return true;
  Diagnostic d = scope.document->diagnostic(
      node.place, node, "a model has one section <" + node.tag + ">, this is the second");
  d.hint = "write its attributes into the first, or remove one of them";
  d.notes.push_back({.place = first->second, .text = "the first stands here"});
  faults_->add(std::move(d));
  return false;
}

void SettingsReader::readSimulation(const XmlNode& node, const Scope& scope, const Parameters& x) {
  if (x["step"].given && x["tolerance"].given)
    faults_->add(scope, x["tolerance"].place, node, "step and tolerance exclude each other",
                 "a step fixes the length of all steps, a tolerance lets the program choose it");
  SimulationSettings& s = model_->simulation;
  if (x["until"].given) s.until = x["until"];
  if (x["step"].given) s.step = x["step"];
  if (x["tolerance"].given) s.tolerance = x["tolerance"];
  if (x["gTol"].given) s.gTol = x["gTol"];
  if (x["sleep"].given) s.sleep = x["sleep"];
  if (x["onNonConvergence"].given) {
    const std::string& word = x["onNonConvergence"].text;
    s.onNonConvergence = word == "stop"   ? NonConvergence::stop
                         : word == "warn" ? NonConvergence::warn
                                          : NonConvergence::retry;
  }
  if (x["project"].given) {
    const std::string& word = x["project"].text;
    s.project = word == "none"        ? Project::none
                : word == "positions" ? Project::positions
                                      : Project::both;
  }
  if (x["coordinates"].given) {
    const std::string& word = x["coordinates"].text;
    s.coordinates = word == "minimal"    ? JointCoordinates::minimal
                    : word == "absolute" ? JointCoordinates::absolute
                                         : JointCoordinates::automatic;
    s.coordinatesPlace = x["coordinates"].place;
  }
  if (x["start"].given) s.start = x["start"].text == "given" ? Start::given : Start::equilibrium;
  for (const XmlWord& word : xmlWords(x["keep"].text)) {
    s.keep.emplace_back(word.text);
    s.keepPlaces.push_back(x["keep"].locate ? x["keep"].locate(word.offset, word.text.size())
                                            : x["keep"].place);
  }
  s.place = node.place;
}

/// Reads scheme, solver and impact law, at most one of each.
void SettingsReader::readMethods(const XmlNode& node, const Scope& scope) {
  const Word& word = *source_->vocabulary().find("simulation");
  for (const XmlNode& child : node.children) {
    if (child.tag == "doc") continue;
    const RegisteredType* type = elements_->typeIn(word, child, scope, node);
    if (type == nullptr) continue;
    const auto [first, isNew] = methods_.emplace(type->kind, child.place);
    if (!isNew) {
      Diagnostic d = scope.document->diagnostic(
          child.place, node, "takes at most 1 " + std::string(kindText(type->kind)));
      d.notes.push_back({.place = first->second, .text = "the first stands here"});
      faults_->add(std::move(d));
      continue;
    }
    if (auto element = elements_->read(child, scope, *type, {}))
      model_->add(type->kind, std::move(element));
  }
}

void SettingsReader::readRecord(const XmlNode& node, const Scope& scope, const Parameters& x) {
  RecordSettings& r = model_->record;
  r.place = node.place;
  for (const XmlWord& word : xmlWords(x["signals"].text)) {
    if (r.signals.size() == kMostSignalNames) {
      faults_->add(scope, x["signals"].place, node,
                   "more than " + std::to_string(kMostSignalNames) + " signals are listed",
                   "a name that ends with .* stands for all signals of an element");
      return;
    }
    r.signals.emplace_back(word.text);
    r.places.push_back(x["signals"].locate(word.offset, word.text.size()));
  }
  if (x["every"].given) r.every = x["every"];
  if (x["at"].given) {
    r.at = x["at"].numbers, recordTimes_ = x["at"].place;
    if (std::any_of(r.at.begin(), r.at.end(), [](double t) { return t < 0.0; }))
      faults_->add(scope, x["at"].place, node, "an instant is before the start of the run");
  }
  if (x["format"].given) r.packed = x["format"].text == "hdf5";
  if (x["frames"].given) r.framesPerSecond = x["frames"];
  if (x["follow"].given) r.follow = x["follow"].text, r.followPlace = x["follow"].place;
  if (x["view"].given) model_->view = x["view"].text == "auto" ? "" : x["view"].text;
}

bool SettingsReader::checkIsSound(const XmlNode& node, const Scope& scope,
                                  const Parameters& x) const {
  const std::size_t before = faults_->size();
  const auto fault = [&](const Place& place, std::string text) {
    faults_->add(scope, place, node, std::move(text));
  };
  const bool value = x["value"].given, tolerance = x["tolerance"].given;
  if (x["between"].given) {
    if (value || tolerance)
      fault(x["between"].place, "takes either value and tolerance, or between");
    else if (x["between"].numbers[0] > x["between"].numbers[1])
      fault(x["between"].place, "between expects the lower bound first");
  } else if (!value || !tolerance) {
    fault(node.place, !value && !tolerance ? "needs value and tolerance, or between"
                      : value              ? "needs a tolerance beside the value"
                                           : "needs a value beside the tolerance");
  }
  const bool single = x["measure"].text == "value";
  if (x["at"].given && !single)
    fault(x["at"].place, "at goes with the measure \"value\"; use over");
  if (x["over"].given && single)
    fault(x["over"].place, "over goes with a measure such as \"max\"; use at");
  if (x["over"].given && !(x["over"].numbers[0] < x["over"].numbers[1]))
    fault(x["over"].place, "over expects the earlier time first");
  if (runFigure(x["signal"].text) != nullptr && (x["measure"].given || x["at"].given))
    fault(x["signal"].place, "a figure of the whole run has neither measure nor time");
  return faults_->size() == before;
}

void SettingsReader::readCheck(const XmlNode& node, const Scope& scope, const Parameters& x) {
  if (!checkIsSound(node, scope, x)) return;
  using Measure = CheckSettings::Measure;
  CheckSettings c;
  c.signal = x["signal"].text;
  c.place = node.place;
  const std::string& measure = x["measure"].text;
  c.measure = measure == "mean"     ? Measure::mean
              : measure == "min"    ? Measure::min
              : measure == "max"    ? Measure::max
              : measure == "period" ? Measure::period
              : measure == "count"  ? Measure::count
                                    : Measure::value;
  if (x["at"].given) c.at = x["at"];
  if (x["over"].given) c.from = x["over"].numbers[0], c.to = x["over"].numbers[1];
  if (x["between"].given) {
    c.low = x["between"].numbers[0], c.high = x["between"].numbers[1];
    c.text = numberText(c.low) + " … " + numberText(c.high);
  } else {
    const double value = x["value"], tolerance = x["tolerance"];
    c.low = value - tolerance, c.high = value + tolerance;
    c.text = numberText(value) + " ± " + numberText(tolerance);
  }
  model_->checks.push_back(std::move(c));
  checkSignals_.push_back(x["signal"].place);
  checkTimes_.push_back(x[x["at"].given ? "at" : "over"].place);
}

void SettingsReader::readOrbit(const XmlNode& node, const Scope& scope, const Parameters& x) {
  OrbitSection s;
  s.signal = x["signal"].text, s.value = x["value"];
  s.falling = x["direction"].text == "falling",
  s.returns = static_cast<int>(x["returns"].integer());
  if (x["period"].given) s.period = x["period"];
  s.mirror = x["mirror"].words();
  orbitSignal_ = {s.signal, s.signal.empty() ? node.place : x["signal"].place};
  if (s.given() == (!s.signal.empty() && s.period > 0.0))
    faults_->add(scope, node.place, node, "takes either a signal or a period",
                 "a period is that of a forcing; motions without forcing are cut where a signal "
                 "passes a value");
  if (orbit_ != nullptr) *orbit_ = s;
}

/// Reports a check at a time after the end of the run, because it could not pass.
void SettingsReader::verifyTime(const CheckSettings& check, const Place& place) const {
  const double until = longest();
  const double last = check.measure == CheckSettings::Measure::value ? check.at : check.to;
  if (!std::isfinite(last) || !(until > 0.0) || last <= until * (1.0 + kTimeRounding)) return;
  faults_->add({.place = place,
                .element = "check",
                .text = "looks for \"" + check.signal + "\" at " + numberText(last) +
                        " s, but the run ends at " + numberText(until) + " s",
                .hint = "take a later until, or an earlier time"});
}

/// Reports an instant of a row after the end of the run, which would not be written.
void SettingsReader::verifyInstants() const {
  const std::vector<double>& at = model_->record.at;
  const double until = longest();
  if (at.empty() || !(until > 0.0)) return;
  const double last = *std::max_element(at.begin(), at.end());
  if (last <= until * (1.0 + kTimeRounding)) return;
  faults_->add({.place = recordTimes_,
                .element = "record",
                .text = "wants a row at " + numberText(last) + " s, but the run ends at " +
                        numberText(until) + " s",
                .hint = "take a later until, or leave the instant out"});
}

void SettingsReader::verify(const std::unordered_set<std::string_view>& signals,
                            const std::string& signal, const Place& place,
                            const std::string& element) const {
  if (signals.contains(signal)) return;
  if (element == "check" && runFigure(signal) != nullptr) return;
  std::vector<std::string> known;
  for (const NamedSignal& s : model_->signals()) known.push_back(s.name);
  if (element == "check")
    for (const RunFigure& f : runFigures()) known.push_back(std::string("run.") + f.name);
  const bool all = signal.ends_with('*');
  if (all) {
    const std::string prefix = signal.substr(0, signal.size() - 1);
    for (std::string& name : known) {
      if (name.starts_with(prefix)) return;
      name = name.substr(0, name.rfind('.')) + ".*";
    }
    known.erase(std::unique(known.begin(), known.end()), known.end());
  }
  const std::string owner = signal.substr(0, signal.rfind('.') + 1);
  const bool owned = !owner.empty() && std::any_of(known.begin(), known.end(), [&](const auto& k) {
    return k.starts_with(owner);
  });
  std::string hint;
  if (const std::string slope = accelerationHint(signal, known); !slope.empty())
    hint = slope;
  else if (signal == "all")
    hint = "all signals are signals=\"*\"";
  else if (const std::string several = partedNames(signal); !several.empty())
    hint = "names stand between blanks: \"" + several + '"';
  else if (const std::string own = signal.substr(signal.rfind('.') + 1);
           !owner.empty() && std::find(known.begin(), known.end(), own) != known.end())
    hint = "an element without a name has signals without a dot: write \"" + own +
           "\", or give it name=\"" + owner.substr(0, owner.size() - 1) + '"';
  else if (hint = owned ? unknownNameHint(signal, known) : didYouMean(nearest(signal, known));
           !hint.starts_with("did you mean"))
    hint.clear();  // lists stand behind what is known better
  if (const std::string meant = signalOfOthers(signal, known); !meant.empty())
    hint = didYouMean(meant);
  if (hint.empty() && owner.empty())
    for (const std::string& name : known)
      if (hint.empty() && name.ends_with('.' + signal)) hint = didYouMean(name);
  if (hint.empty() && model_->composed.coordinates > 0)
    for (const auto& joint : model_->contacts())
      if (!owner.empty() && owner == joint->name() + ".")
        hint = "in minimal coordinates \"" + joint->name() +
               "\" may be a coordinate, which has no percussions";
  for (const auto& system : model_->systems())
    if (hint.empty() && !owned && owner == system->name() + ".")
      hint = '"' + system->name() + "\" has no signals in this model; ";
  if (hint.empty() || hint.ends_with("; ")) hint += unknownNameHint(signal, known);
  faults_->add({.place = place,
                .element = element,
                .text = (all ? "no signals \"" : "no signal \"") + signal + '"',
                .hint = std::move(hint)});
}

/// Reports a name that is neither a system that carries shapes nor one of its frames.
void SettingsReader::verifyFollow(const std::string& name, const Place& place) const {
  std::vector<std::string> known;
  for (const SceneFrame& frame : modelScene(*model_).frames) {
    known.push_back(frame.name);
    if (frame.name == name || frame.name.starts_with(name + ".")) return;
  }
  faults_->add({.place = place,
                .element = "record",
                .text = "nothing is drawn on \"" + name + '"',
                .hint = unknownNameHint(name, known)});
}

/// Reports names of what the start keeps that are neither systems nor velocities of them.
void SettingsReader::verifyKept() const {
  const SimulationSettings& s = model_->simulation;
  for (std::size_t i = 0; i < s.keep.size(); ++i)
    if (velocitiesNamed(*model_, s.keep[i]).empty())
      faults_->add({.place = s.keepPlaces[i],
                    .element = "simulation",
                    .text = "no system and no velocity \"" + s.keep[i] + '"',
                    .hint = unknownNameHint(s.keep[i], keptNames(*model_))});
}

void SettingsReader::verifySignals() const {
  verifyKept();
  const RecordSettings& r = model_->record;
  if (!r.follow.empty()) verifyFollow(r.follow, r.followPlace);
  verifyInstants();
  std::unordered_set<std::string_view> signals;
  for (const NamedSignal& s : model_->signals()) signals.insert(s.name);
  for (std::size_t i = 0; i < r.signals.size(); ++i)
    verify(signals, r.signals[i], r.places[i], "record");
  if (!orbitSignal_.name.empty()) verify(signals, orbitSignal_.name, orbitSignal_.place, "orbit");
  for (std::size_t i = 0; i < model_->checks.size(); ++i) {
    verify(signals, model_->checks[i].signal, checkSignals_[i], "check");
    verifyTime(model_->checks[i], checkTimes_[i]);
  }
}

}  // namespace dynamy
