#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/blocks/block_states.hpp>
#include <dynamy_elements/blocks/state_blocks.hpp>

namespace dynamy {
namespace {

void optionalLimit(Attributes& a, const char* name, const char* text) {
  Attribute& x = a.add(AttributeType::number, name, std::nullopt, text);
  x.unit = Unit::any;
  x.mayBeAbsent();
}

}  // namespace

// ---- StateBlock --------------------------------------------------------------------------------

void StateBlock::declareStiff(Attributes& a) {
  a.add(AttributeType::flag, "stiff", "false",
        "true: fixed steps take the state linearly implicitly, for rates of change that are faster "
        "than the steps");
}

void StateBlock::declareState(Attributes& a) {
  a.optional("initial", Unit::any, 0.0, "state at the start");
  declareStiff(a);
}

StateBlock::StateBlock(const Parameters& x, std::vector<double> initial)
    : ExternalForce(x), initial_(std::move(initial)), stiff_(x["stiff"].flag()) {
  if (x.name.empty())
    throw ModelError("the block has no name", "formulas read it as NAME.out: add name=\"…\"");
}

std::unique_ptr<PartialMechanicalSystem> StateBlock::ownSystem() const {
  Parameters x;
  x.type = type(), x.name = name(), x.place = place();
  return std::make_unique<BlockStates>(x, initial_, stateNames());
}

void StateBlock::connect(Topology& topology) {
  system_ = topology.system(name(), *this);
  for (SignalFormulas* f : formulas()) f->connect(topology, *this);
  rate_.resize(initial_.size()), byState_.resize(initial_.size() * initial_.size());
}

void StateBlock::addTo(const Kinematics& k, ForceSink& sink) const {
  rates(k, states(k), rate_.data(), nullptr);
  for (std::size_t i = 0; i < rate_.size(); ++i)
    sink.generalised(system_, static_cast<int>(i), BlockStates::kMass * rate_[i]);
}

void StateBlock::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  rates(k, states(k), rate_.data(), byState_.data());
  const int n = static_cast<int>(rate_.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (const double by = byState_[static_cast<std::size_t>(i * n + j)]; by != 0.0)
        sink.entry(system_, i, j, 0.0, BlockStates::kMass * by);
}

void StateBlock::describe(Description& d) const { SignalFormulas::announce(d, {&of_}); }

// ---- Integrator, Filter ------------------------------------------------------------------------

void Integrator::declare(Attributes& a) {
  a.about(
      "State x with the rate f: integrals, filters and controllers of any order from several of "
      "them. Under the error control of the scheme. Signals: out (x), integral.");
  a.add(AttributeType::expression, "rate", std::nullopt,
        "x' as a formula of t, of the state x itself and of signals");
  declareState(a);
  a.example("<Integrator name=\"i\" rate=\"0.5 - cart.x\"/>");
}

void Integrator::rates(const Kinematics& k, const double* x, double* rate, double* byState) const {
  rate[0] = of_.value(k, x);
  if (byState) byState[0] = of_.partial(0);
}

void Filter::declare(Attributes& a) {
  a.about("Low pass of first order: x' = (f - x)/T. Signals: out (x), integral.");
  a.add(AttributeType::expression, "of", std::nullopt, "f as a formula of t and signals");
  a.required("time", Unit::time, "time constant T [s]").positive();
  declareState(a);
  a.example("<Filter name=\"smooth\" of=\"cart.vx\" time=\"20ms\"/>");
}

void Filter::rates(const Kinematics& k, const double* x, double* rate, double* byState) const {
  rate[0] = (of_.value(k) - x[0]) / time_;
  if (byState) byState[0] = -1.0 / time_;
}

// ---- TransferFunction --------------------------------------------------------------------------

namespace {

/// Order of the denominator.
std::size_t orderOf(const Parameters& x) {
  const std::vector<double>& n = x["denominator"].numbers;
  return n.empty() ? 0 : n.size() - 1;
}

}  // namespace

void TransferFunction::declare(Attributes& a) {
  a.about(
      "Linear block out = b(s)/a(s) f, with the coefficients of both polynomials from the highest "
      "power of s to the constant one; all states are zero at the start. Signals: out, x1, x2, …, "
      "the states of the controllable canonical form.");
  a.add(AttributeType::expression, "of", std::nullopt, "f as a formula of t and signals");
  for (const auto& [name, text] :
       {std::pair{"numerator", "coefficients of b, highest power first"},
        std::pair{"denominator", "coefficients of a, highest power first"}}) {
    Attribute& x = a.add(AttributeType::vector, name, std::nullopt, text);
    x.unit = Unit::any, x.size = 0;
  }
  declareStiff(a);
  a.example(
      "<TransferFunction name=\"lead\" of=\"1 - cart.x\" numerator=\"0.2 1\" "
      "denominator=\"0.01 0.15 1\"/>");
}

TransferFunction::TransferFunction(const Parameters& x)
    : StateBlock(x, std::vector<double>(orderOf(x), 0.0)) {
  of_ = {x, "of", 1};
  const ParameterValue &over = x["numerator"], &under = x["denominator"];
  std::vector<double> b = over.numbers, a = under.numbers;
  std::reverse(b.begin(), b.end()), std::reverse(a.begin(), a.end());
  if (a.size() < 2)
    throw under.fault("the denominator has no power of s", "a gain alone is a Formula", 0,
                      under.text.size());
  if (a.back() == 0.0)
    throw under.fault("the first coefficient is zero", "it belongs to the highest power of s", 0,
                      under.text.size());
  if (b.empty() || b.size() > a.size())
    throw over.fault("the numerator has a higher power of s than the denominator",
                     "the output would contain derivatives of the input", 0, over.text.size());
  b.resize(a.size(), 0.0);
  const double most = a.back();
  for (double& v : a) v /= most;
  d_ = b.back() / most;
  // b(s)/a(s) = d + c(s)/a(s)
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
    a_.push_back(a[i]), c_.push_back(b[i] / most - d_ * a[i]);
}

std::vector<std::string> TransferFunction::stateNames() const {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= a_.size(); ++i) names.push_back("x" + std::to_string(i));
  return names;
}

void TransferFunction::rates(const Kinematics& k, const double* x, double* rate,
                             double* byState) const {
  const std::size_t n = a_.size();
  double last = of_.value(k);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) rate[i - 1] = x[i];
    last -= a_[i] * x[i];
  }
  rate[n - 1] = last;
  if (!byState) return;
  std::fill_n(byState, n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) byState[(i - 1) * n + i] = 1.0;
    byState[(n - 1) * n + i] -= a_[i];
  }
}

double TransferFunction::out(const Kinematics& k) const {
  // Without a direct path the input is not read, so that a loop through the block is no loop.
  const double* x = states(k);
  double y = d_ != 0.0 ? d_ * of_.value(k) : 0.0;
  for (std::size_t i = 0; i < c_.size(); ++i) y += c_[i] * x[i];
  return y;
}

void TransferFunction::describe(Description& d) const {
  StateBlock::describe(d);
  d.signal("out", Unit::any, "output of the block",
           [this](const SignalView& v) { return out(*v.kinematics); });
}

// ---- ContinuousPid -----------------------------------------------------------------------------

void ContinuousPid::declare(Attributes& a) {
  a.about(
      "PID controller with continuous states: out = clamp(kp e + I + D + f), I' = ki e, "
      "D = kd (e - w)/Tf with w' = (e - w)/Tf, or D = kd times a given rate. Signals: out, error, "
      "derivative, integral (I), filtered (w).");
  a.add(AttributeType::expression, "error", std::nullopt,
        "error e as a formula of t and signals, e.g. 1 - cart.x");
  a.optional("kp", Unit::any, 0.0, "gain of the error");
  a.optional("ki", Unit::any, 0.0, "gain of its integral [1/s]");
  a.optional("kd", Unit::any, 0.0, "gain of its rate [s]");
  a.optional("filter", Unit::time, 0.0, "time constant Tf of the rate [s]").nonNegative();
  a.add(AttributeType::expression, "rate", std::nullopt,
        "rate of the error as a formula of t and signals: D = kd rate, without a filter")
      .mayBeAbsent();
  a.add(AttributeType::expression, "feedforward", "0", "f as a formula of t and signals");
  optionalLimit(a, "lower", "least output; default: none");
  optionalLimit(a, "upper", "largest output; default: none");
  a.choice("antiWindup", {"clamp", "back", "none"}, "clamp",
           "what keeps I from growing at a limit: clamp: I stays while it would drive the output "
           "further out; back: I also follows (out - output without limits)/tracking");
  a.optional("tracking", Unit::time, 1.0, "time constant of antiWindup=\"back\" [s]").positive();
  declareStiff(a);
  a.example(
      "<ContinuousPid name=\"pid\" error=\"0.5 - cart.x\" rate=\"-cart.vx\" kp=\"40\" ki=\"10\" "
      "kd=\"8\" lower=\"-20\" upper=\"20\"/>");
}

ContinuousPid::ContinuousPid(const Parameters& x)
    : StateBlock(x, {0.0, 0.0}),
      error_(x, "error", 1),
      rate_(x, "rate", 1),
      feedforward_(x, "feedforward", 1),
      kp_(x["kp"]),
      ki_(x["ki"]),
      kd_(x["kd"]),
      filter_(x["filter"]),
      lower_(x.has("lower") ? double(x["lower"]) : -kInfinity),
      upper_(x.has("upper") ? double(x["upper"]) : kInfinity),
      tracking_(x["tracking"]),
      antiWindup_(x["antiWindup"].text == "clamp"  ? AntiWindup::clamp
                  : x["antiWindup"].text == "back" ? AntiWindup::back
                                                   : AntiWindup::none) {
  if (!(lower_ <= upper_))
    throw ModelError("the lower limit lies above the upper one", "exchange lower and upper");
  if (kd_ != 0.0 && rate_.empty() && filter_ == 0.0)
    throw ModelError("kd needs the rate of the error",
                     "give rate=\"…\", e.g. -cart.vx, or the time constant filter=\"…\"");
}

double ContinuousPid::wanted(const Kinematics& k, const double* x, double e) const {
  double D = 0.0;
  if (kd_ != 0.0) D = kd_ * (rate_.empty() ? (e - x[1]) / filter_ : rate_.value(k));
  return kp_ * e + x[0] + D + feedforward_.value(k);
}

void ContinuousPid::rates(const Kinematics& k, const double* x, double* rate,
                          double* byState) const {
  const double e = error_.value(k), F = wanted(k, x, e), step = ki_ * e;
  const bool further = (F > upper_ && step > 0.0) || (F < lower_ && step < 0.0);
  rate[0] = antiWindup_ == AntiWindup::clamp && further ? 0.0 : step;
  const bool back = antiWindup_ == AntiWindup::back;
  if (back) rate[0] += (std::clamp(F, lower_, upper_) - F) / tracking_;
  const double pace = filter_ > 0.0 ? 1.0 / filter_ : 0.0;
  rate[1] = pace * (e - x[1]);
  if (!byState) return;
  const bool cut = back && !(F >= lower_ && F <= upper_);
  byState[0] = cut ? -1.0 / tracking_ : 0.0;
  byState[1] = cut && rate_.empty() && kd_ != 0.0 ? kd_ * pace / tracking_ : 0.0;
  byState[2] = 0.0, byState[3] = -pace;
}

void ContinuousPid::describe(Description& d) const {
  SignalFormulas::announce(d, {&error_, &rate_, &feedforward_});
  d.signal("out", Unit::any, "output", [this](const SignalView& v) {
    const double e = error_.value(*v.kinematics);
    return std::clamp(wanted(*v.kinematics, states(*v.kinematics), e), lower_, upper_);
  });
  d.signal("error", Unit::any, "error",
           [this](const SignalView& v) { return error_.value(*v.kinematics); });
  d.signal("derivative", Unit::any, "derivative part D of the output", [this](const SignalView& v) {
    const Kinematics& k = *v.kinematics;
    if (kd_ == 0.0) return 0.0;
    return kd_ * (rate_.empty() ? (error_.value(k) - states(k)[1]) / filter_ : rate_.value(k));
  });
}

}  // namespace dynamy
