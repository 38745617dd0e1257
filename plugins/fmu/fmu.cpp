#include "fmu.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <stdexcept>

namespace dynamy {
namespace {

/// Bytes of a state in one number, which a double keeps exactly.
constexpr std::size_t kBytes = 6;

/// States that may be kept; an FMU with a larger one follows its inputs again instead [bytes].
constexpr std::size_t kMostState = std::size_t{1} << 20u;

/// Times of clocks are the same up to this part of the period.
constexpr double kSameTime = 1e-9;

/// Sums over inputs have 48 bits, to be exact in a double, too.
constexpr std::uint64_t kSumBits = (std::uint64_t{1} << 48u) - 1;

std::uint64_t sumWith(std::uint64_t sum, double x) {  // FNV-1a over the bytes of x
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof x);
  for (int i = 0; i < 8; ++i) sum = (sum ^ ((bits >> (8 * i)) & 255u)) * 0x100000001b3U;
  return sum & kSumBits;
}

std::shared_ptr<const FmuFile> opened(const Parameters& x) {
  const ParameterValue& file = x["file"];
  const std::filesystem::path path = file.existingFile();
  try {
    return FmuFile::open(path);
  } catch (const std::exception& e) {
    throw file.fault("the FMU cannot be used: " + std::string(e.what()), "", 0, file.text.size());
  }
}

/// Period and offset that hold if the model states none: those of the only clock, else the step of
/// the default experiment.
SampleClock clockOf(const Parameters& x, const FmuFile& file) {
  double period = file.stepSize, shift = 0.0;
  for (const FmuClock& c : file.clocks)
    if (c.interval > 0.0) period = c.interval, shift = c.shift;
  if (x.has("period")) period = x["period"];
  if (x.has("offset")) shift = x["offset"];
  if (!(period > 0.0))
    throw x["file"].fault("the FMU states no step of its own", "add period=\"10ms\"", 0,
                          x["file"].text.size());
  const bool asked = x.has("period") || x.has("offset");
  for (const FmuClock& c : file.clocks)
    if (c.interval > 0.0 && (std::abs(c.interval - period) > kSameTime * period ||
                             std::abs(c.shift - shift) > kSameTime * period))
      throw x["file"].fault(
          "a clock of the FMU ticks every " + numberText(c.interval) + " s from " +
              numberText(c.shift) + " s on",
          asked ? "leave out period and offset" : "its clocks differ, which is not served", 0,
          x["file"].text.size());
  return {period, shift};
}

}  // namespace

void Fmu::declare(Attributes& a) {
  a.about(
      "A controller that another program exported as an FMU for co-simulation (FMI 2.0 or 3.0): a "
      "sampled block. At each of the instants offset + k period it has made a step of one period, "
      "gets its inputs, and its outputs hold until the next one. Signals: its outputs by their "
      "names; out, the first of them. Numbers are in the units of the FMU.");
  a.add(AttributeType::text, "file", std::nullopt, "the FMU, its path counted from this file")
      .runsCode();
  a.add(AttributeType::names, "inputs", "", "inputs of the FMU that are set");
  a.add(AttributeType::expressions, "values", "",
        "their values, formulas of t and signals, separated by ';'");
  a.add(AttributeType::text, "parameters", "", "parameters of the FMU, as in kp=40 ki=10");
  Attribute& period = a.add(AttributeType::number, "period", std::nullopt,
                            "time T from sample to sample; default: what the FMU states [s]");
  period.unit = Unit::time;
  period.mayBeAbsent().positive();
  Attribute& offset = a.add(AttributeType::number, "offset", std::nullopt,
                            "instant of the first sample; default: what the FMU states, or 0 [s]");
  offset.unit = Unit::time;
  offset.mayBeAbsent().nonNegative();
  a.example(
      "<Fmu name=\"pid\" file=\"pid.fmu\" inputs=\"e\" values=\"0.5 - cart.x\" "
      "parameters=\"kp=40\" period=\"10ms\"/>");
}

Fmu::Fmu(const Parameters& x) : Fmu(x, opened(x)) {}

Fmu::Fmu(const Parameters& x, std::shared_ptr<const FmuFile> file)
    : SampledBlock(x, clockOf(x, *file), 0.0), file_(std::move(file)), who_(x["file"].text) {
  readNames(x);
  try {
    make();
    instance_->start(clock().first(), parameters_, {});
    for (const FmuVariable* v : outputs_) initial_.push_back(instance_->get(*v));
    if (file_->serializes) {
      // States may grow: some hold no step at first, or texts of numbers.
      instance_->advance(clock().first(), clock().period());
      instance_->exchange({}, true);
      const std::size_t size = instance_->state().size();
      constexpr std::size_t kRoom = 256;
      if (size <= kMostState) stateBytes_ = 2 * size + kRoom;
    }
    instance_.reset();
  } catch (const std::exception& e) {
    throw x["file"].fault("the FMU cannot be used: " + std::string(e.what()), "", 0,
                          x["file"].text.size());
  }
}

void Fmu::readNames(const Parameters& x) {
  const ParameterValue& inputs = x["inputs"];
  const auto need = [&](const ParameterValue& value, const std::string& name, const char* causality,
                        std::size_t at) {
    if (const FmuVariable* v = file_->find(name, causality)) return v;
    const bool left = std::find(file_->left.begin(), file_->left.end(), name) != file_->left.end();
    throw value.fault("the FMU has no " + std::string(causality) + " \"" + name + '"' +
                          (left ? " that is a single number" : ""),
                      unknownNameHint(name, file_->names(causality)), at, name.size());
  };
  std::size_t from = 0;
  for (const std::string& name : inputs.words()) {
    from = inputs.text.find(name, from);
    inputs_.push_back(need(inputs, name, "input", from));
    from += name.size();
  }
  values_ = {x, "values", static_cast<int>(inputs_.size())};
  const ParameterValue& set = x["parameters"];
  from = 0;
  for (const std::string& word : set.words()) {
    from = set.text.find(word, from);
    const std::size_t equals = word.find('=');
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const bool good = equals != std::string::npos &&
                      std::from_chars(word.data() + equals + 1, end, value).ptr == end &&
                      equals + 1 < word.size();
    if (!good)
      throw set.fault("\"" + word + "\" sets no parameter", "as in kp=40 ki=10, without blanks",
                      from, word.size());
    parameters_.emplace_back(need(set, word.substr(0, equals), "parameter", from), value);
    from += word.size();
  }
  for (const FmuVariable& v : file_->variables)
    if (v.causality == "output") outputs_.push_back(&v);
  if (outputs_.empty())
    throw x["file"].fault("the FMU has no output that is a single number", "", 0,
                          x["file"].text.size());
}

void Fmu::make() const {
  instance_.reset();  // first, since an FMU may allow one in a program
  instance_ = FmuInstance::make(file_, name());
  at_ = {}, history_.clear();
}

void Fmu::describe(Description& d) const {
  bool hasOut = false;
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const auto value = [i](const SignalView& v) { return v.memory[1 + static_cast<int>(i)]; };
    d.signal(outputs_[i]->name, Unit::any, "output of the FMU, held from sample to sample", value);
    hasOut = hasOut || outputs_[i]->name == "out";
  }
  if (!hasOut)
    d.signal("out", Unit::any, "first output of the FMU",
             [](const SignalView& v) { return v.memory[1]; });
  announceSamples(d, [this](double t) { return clock().next(t); });
}

long Fmu::stateNumbers() const { return static_cast<long>((stateBytes_ + kBytes - 1) / kBytes); }

/// Outputs; number of samples taken, sum over their inputs, instant of the last one; then size and
/// bytes of the state.
std::vector<double> Fmu::held() const {
  std::vector<double> out = initial_;
  out.resize(out.size() + 3 + (stateBytes_ > 0 ? 1 + static_cast<std::size_t>(stateNumbers()) : 0));
  return out;
}

FmuInstance::Values Fmu::with(const std::vector<double>& inputs) const {
  FmuInstance::Values out;
  for (std::size_t i = 0; i < inputs_.size(); ++i) out.emplace_back(inputs_[i], inputs[i]);
  return out;
}

/// The next sample of the instance, at t.
void Fmu::step(double t, const std::vector<double>& inputs) const {
  if (at_.taken == 0) {
    instance_->start(t, parameters_, with(inputs));
  } else {
    instance_->advance(at_.t, t - at_.t);
    instance_->exchange(with(inputs), true);
  }
  at_.sum = sumWith(at_.sum, t);
  for (const double u : inputs) at_.sum = sumWith(at_.sum, u);
  at_.t = t, ++at_.taken;
  if (stateBytes_ == 0) history_.push_back({at_, inputs});
}

/// Makes the instance anew, and lets it take the first samples once more.
void Fmu::follow(long taken) const {
  const std::vector<Sample> before(history_.begin(), history_.begin() + taken);
  make();
  for (const Sample& sample : before) step(sample.at.t, sample.inputs);
}

/// Brings the instance to where it was after the samples `wanted`; `state`: its size and bytes.
void Fmu::setBack(const At& wanted, const double* state) const {
  if (wanted.taken == 0) return make();
  if (instance_ && at_ == wanted) return;
  if (stateBytes_ == 0) {
    const auto last = static_cast<std::size_t>(wanted.taken - 1);
    if (last >= history_.size() || !(history_[last].at == wanted))
      throw std::runtime_error(
          "its state cannot be set back, since the FMU does not write it (canSerializeFMUState)");
    return follow(wanted.taken);
  }
  FmuInstance::Bytes bytes(static_cast<std::size_t>(state[0]));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto group = static_cast<std::uint64_t>(state[1 + i / kBytes]);
    bytes[i] = static_cast<std::uint8_t>(group >> (8 * (i % kBytes)));
  }
  if (!instance_) make();
  instance_->setBack(bytes);
  at_ = wanted;
}

void Fmu::keep(double* state) const {
  const FmuInstance::Bytes bytes = instance_->state();
  if (bytes.size() > stateBytes_)
    throw std::runtime_error("its state has grown to more than twice its size at the start");
  state[0] = static_cast<double>(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += kBytes) {
    std::uint64_t group = 0;
    for (std::size_t j = std::min(kBytes, bytes.size() - i); j-- > 0;)
      group = group << 8u | bytes[i + j];
    state[1 + i / kBytes] = static_cast<double>(group);
  }
}

void Fmu::sample(const Kinematics& k, double* held) const {
  double* const at = held + outputs_.size();
  std::vector<double> inputs(inputs_.size());
  values_.eval(k, inputs.data());
  try {
    setBack({static_cast<long>(at[0]), static_cast<std::uint64_t>(at[1]), at[2]}, at + 3);
    step(k.t(), inputs);
    for (std::size_t i = 0; i < outputs_.size(); ++i) held[i] = instance_->get(*outputs_[i]);
    at[0] = static_cast<double>(at_.taken), at[1] = static_cast<double>(at_.sum), at[2] = at_.t;
    if (stateBytes_ > 0) keep(at + 3);
  } catch (const std::exception& e) {
    instance_.reset();  // nobody knows how far it came
    throw std::runtime_error("the FMU " + who_ + ": " + e.what());
  }
}

std::string Fmu::memoryFault(ConstVec memory) const {
  const auto isCount = [](double x, double most) {
    return x >= 0.0 && x <= most && x == std::floor(x);
  };
  constexpr double kExact = 9007199254740992.0;  // 2⁵³
  const double* at = memory.data() + 1 + outputs_.size();
  if (!isCount(at[0], kExact) || !isCount(at[1], static_cast<double>(kSumBits)) ||
      !std::isfinite(at[2]))
    return "its samples are not counted";
  if (stateBytes_ == 0) return {};
  if (!isCount(at[3], static_cast<double>(stateBytes_))) return "its state has another size";
  for (long i = 0; i < stateNumbers(); ++i)
    if (!isCount(at[4 + i], static_cast<double>(kSumBits))) return "its state holds no bytes";
  return {};
}

}  // namespace dynamy

static void registerFmu(dynamy::Registry& r) { r.add<dynamy::Fmu>("Fmu"); }
DYNAMY_PLUGIN("fmu", "1.0.0", registerFmu)
