#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/blocks/block_states.hpp>
#include <dynamy_elements/blocks/state_blocks.hpp>

namespace dynamy {

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
  PidSettings::declare(
      a, "rate of the error as a formula of t and signals: D = kd rate, without a filter");
  declareStiff(a);
  a.example(
      "<ContinuousPid name=\"pid\" error=\"0.5 - cart.x\" rate=\"-cart.vx\" kp=\"40\" ki=\"10\" "
      "kd=\"8\" lower=\"-20\" upper=\"20\"/>");
}

ContinuousPid::ContinuousPid(const Parameters& x) : StateBlock(x, {0.0, 0.0}), pid_(x) {
  if (pid_.kd != 0.0 && pid_.rate.empty() && pid_.filter == 0.0)
    throw ModelError("kd needs the rate of the error",
                     "give rate=\"…\", e.g. -cart.vx, or the time constant filter=\"…\"");
}

double ContinuousPid::derivative(const Kinematics& k, const double* x, double e) const {
  if (pid_.kd == 0.0) return 0.0;
  return pid_.kd * (pid_.rate.empty() ? (e - x[1]) / pid_.filter : pid_.rate.value(k));
}

double ContinuousPid::wanted(const Kinematics& k, const double* x, double e) const {
  return pid_.kp * e + x[0] + derivative(k, x, e) + pid_.feedforward.value(k);
}

void ContinuousPid::rates(const Kinematics& k, const double* x, double* rate,
                          double* byState) const {
  const double e = pid_.error.value(k), F = wanted(k, x, e), step = pid_.ki * e;
  const bool back = pid_.antiWindup == PidSettings::AntiWindup::back;
  rate[0] = pid_.staysAt(F, step) ? 0.0 : step;
  if (back) rate[0] += (pid_.limited(F) - F) / pid_.tracking;
  const double pace = pid_.filter > 0.0 ? 1.0 / pid_.filter : 0.0;
  rate[1] = pace * (e - x[1]);
  if (!byState) return;
  const bool cut = back && !(F >= pid_.lower && F <= pid_.upper);
  byState[0] = cut ? -1.0 / pid_.tracking : 0.0;
  byState[1] = cut && pid_.rate.empty() && pid_.kd != 0.0 ? pid_.kd * pace / pid_.tracking : 0.0;
  byState[2] = 0.0, byState[3] = -pace;
}

void ContinuousPid::describe(Description& d) const {
  SignalFormulas::announce(d, {&pid_.error, &pid_.rate, &pid_.feedforward});
  d.signal("out", Unit::any, "output", [this](const SignalView& v) {
    const double e = pid_.error.value(*v.kinematics);
    return pid_.limited(wanted(*v.kinematics, states(*v.kinematics), e));
  });
  d.signal("error", Unit::any, "error",
           [this](const SignalView& v) { return pid_.error.value(*v.kinematics); });
  d.signal("derivative", Unit::any, "derivative part D of the output", [this](const SignalView& v) {
    const Kinematics& k = *v.kinematics;
    return derivative(k, states(k), pid_.error.value(k));
  });
}

}  // namespace dynamy
