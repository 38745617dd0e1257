#include <algorithm>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/coordinates/coordinates.hpp>
#include <limits>

namespace dynamy {
namespace {

Unit rate(Unit unit) {
  if (unit == Unit::length) return Unit::velocity;
  return unit == Unit::angle ? Unit::angularVelocity : Unit::none;
}

bool isName(const std::string& word) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80) != 0;
  };
  return !word.empty() && letter(word[0]) && std::all_of(word.begin(), word.end(), [&](char c) {
    return letter(c) || (c >= '0' && c <= '9');
  });
}

Eigen::VectorXd stateVector(const Parameters& x, const char* attribute, int n) {
  Eigen::VectorXd out = x[attribute].vector();
  if (!x[attribute].given) return Eigen::VectorXd::Zero(n);
  if (out.size() != n)
    throw x[attribute].fault(std::string(attribute) + " has " + std::to_string(out.size()) +
                                 " numbers for " + std::to_string(n) + " coordinates",
                             {}, 0, x[attribute].text.size());
  return out;
}

}  // namespace

Coordinates::Coordinates(const Parameters& x)
    : PartialMechanicalSystem(x), frames_(x.take<CoordinateFrame>()) {
  Diagnostics faults;
  names_.parameters = x.symbols;
  stiff_ = x["stiff"].flag();
  readNames(x, faults);
  faults.throwIfAny();
  readState(x);
  compile(x, faults);
  faults.throwIfAny();
  names_.parameters.clear(), names_.parameters.shrink_to_fit();  // formulas hold their values
}

Coordinates::~Coordinates() = default;

void Coordinates::readNames(const Parameters& x, Diagnostics& faults) {
  const ParameterValue& list = x["q"];
  const auto bad = [&](std::string text) {
    faults.add(list.fault(std::move(text), {}, 0, list.text.size()));
  };
  const SymbolTable before = names_.symbols();  // t and the parameters
  for (const std::string& word : list.words()) {
    if (!isName(word))
      bad("\"" + word + "\" is no name: letters, digits and _, a letter first");
    else if (word == "t")
      bad("\"t\" is the time and cannot be a coordinate");
    else if (before.find(word) != nullptr)
      bad("coordinate \"" + word + "\" has the name of a parameter");
    names_.q.push_back(word);
    names_.u.push_back(word + "_dot");
  }
  if (names_.q.empty()) bad("expects at least one coordinate");
  std::vector<std::string> all = names_.q;
  all.insert(all.end(), names_.u.begin(), names_.u.end());
  std::sort(all.begin(), all.end());
  if (const auto twice = std::adjacent_find(all.begin(), all.end()); twice != all.end())
    bad("\"" + *twice + "\" stands for two things");

  // Units for signals and plots.
  units_.assign(names_.q.size(), Unit::none);
  const std::vector<std::string> words = x["units"].words();
  if (!words.empty() && words.size() != units_.size())
    faults.add(x["units"].fault("expects one unit per coordinate, has " +
                                    std::to_string(words.size()) + " for " +
                                    std::to_string(units_.size()),
                                {}, 0, x["units"].text.size()));
  for (std::size_t i = 0; i < std::min(words.size(), units_.size()); ++i) {
    if (words[i] == "m")
      units_[i] = Unit::length;
    else if (words[i] == "rad")
      units_[i] = Unit::angle;
    else if (words[i] != "-")
      faults.add(x["units"].fault("unit of a coordinate is m, rad or -, is \"" + words[i] + '"', {},
                                  0, x["units"].text.size()));
  }
}

void Coordinates::readState(const Parameters& x) {
  q0_ = stateVector(x, "q0", n());
  u0_ = stateVector(x, "u0", n());
  q_ = names_.qSlots(), u_ = names_.uSlots();
  x_.assign(static_cast<std::size_t>(names_.inputs()), 0.0);
  w_ = unit_ = x_;
  w_[FormulaNames::kTime] = 1.0;
}

void Coordinates::compile(const Parameters& x, Diagnostics& faults) {
  const SymbolTable symbols = names_.symbols();
  const std::size_t before = faults.size();
  compileInertia(x, faults);

  // Formulas for forces: one per coordinate, or none.
  const FormulaText force(x, "h");
  if (!force.empty() && force.size() != n())
    faults.add(force.fault(-1, "h has " + std::to_string(force.size()) + " formulas for " +
                                   std::to_string(n()) + " coordinates"));
  ExpressionCompiler forces(symbols);
  force.compileAll(forces, faults);

  // Potential: one formula of t and q.
  const FormulaText energy(x, "potential");
  if (energy.size() > 1) faults.add(energy.fault(-1, "expects one formula"));
  ExpressionCompiler energies(symbols);
  energy.compileAll(energies, faults);

  for (auto& f : frames_) f->compile(names_, faults);
  if (faults.size() > before) return;
  if (!force.empty()) force_ = std::make_unique<Tape>(forces.finish(), names_);
  if (!energy.empty()) potential_ = std::make_unique<Tape>(energies.finish(), names_);
  if (potential_ && potential_->dependsOn(u_))
    faults.add(energy.fault(0, "a potential depends on t and positions only"));
}

void Coordinates::compileInertia(const Parameters& x, Diagnostics& faults) {
  const bool byEnergy = !x["kineticEnergy"].text.empty();
  const bool byM = !x["M"].text.empty();
  if (byEnergy == byM) {
    faults.add({.place = x.place,
                .element = x.name.empty() ? x.type : x.type + " name=\"" + x.name + '"',
                .text = byM ? "M and kineticEnergy are both given" : "the inertia is missing",
                .hint = "give either M or kineticEnergy"});
    return;
  }
  const FormulaText text(x, byM ? "M" : "kineticEnergy");
  const int full = n() * n(), upper = n() * (n() + 1) / 2;
  inertia_ = byEnergy ? Inertia::energy : text.size() == full ? Inertia::full : Inertia::upper;
  if (byEnergy ? text.size() != 1 : text.size() != full && text.size() != upper) {
    faults.add(text.fault(-1, byEnergy
                                  ? "expects one formula"
                                  : "M has " + std::to_string(text.size()) + " entries, expects " +
                                        std::to_string(full) + " (rows) or " +
                                        std::to_string(upper) + " (rows of the upper triangle)"));
    return;
  }
  const std::size_t before = faults.size();
  ExpressionCompiler compiler(names_.symbols());
  text.compileAll(compiler, faults);
  if (faults.size() > before) return;
  mass_ = std::make_unique<Tape>(compiler.finish(), names_);

  std::vector<int> configuration = q_;
  configuration.push_back(FormulaNames::kTime);
  constantMass_ = !mass_->dependsOn(configuration);
  if (byM)
    for (int k = 0; k < text.size(); ++k)
      for (const int s : u_)
        if (mass_->set().dependsOn(k, s)) {
          faults.add(text.fault(k, "M depends on t and positions only"));
          return;
        }
  checkInertia(text);
}

/// Checks in two states that M is symmetric and T quadratic in u;
/// formulas themselves do not show it.
void Coordinates::checkInertia(const FormulaText& text) const {
  constexpr double kRounding = 1e-9;  // relative; far above rounding, far below a wrong formula
  for (const double shift : {0.0, 0.3}) {
    const Eigen::VectorXd q = q0_.array() + shift;
    const double* x = arguments(shift, view(q), u0_.data());
    for (int i = 0; i < n(); ++i) {
      for (int j = 0; j < i; ++j) {
        if (inertia_ != Inertia::full) break;
        const double* m = mass_->eval(x);
        const double a = m[i * n() + j], b = m[j * n() + i];
        const double size = std::abs(m[i * n() + i]) + std::abs(m[j * n() + j]);
        if (std::abs(a - b) > kRounding * size)
          throw ModelError(
              text.fault(i * n() + j, "M is not symmetric: entry (" + std::to_string(i + 1) + ", " +
                                          std::to_string(j + 1) + ") is " + numberText(a) +
                                          ", its partner " + numberText(b)));
      }
      if (inertia_ != Inertia::energy) continue;
      const double a = mass_->secondPartial(x, u_[static_cast<std::size_t>(i)],
                                            u_[static_cast<std::size_t>(i)])[0];
      for (const int s : u_) x_[static_cast<std::size_t>(s)] += 1.0;
      const double b = mass_->secondPartial(x, u_[static_cast<std::size_t>(i)],
                                            u_[static_cast<std::size_t>(i)])[0];
      for (const int s : u_) x_[static_cast<std::size_t>(s)] -= 1.0;
      if (std::abs(a - b) > kRounding * (std::abs(a) + std::abs(b)))
        throw ModelError(text.fault(
            0, "the kinetic energy is not quadratic in " + names_.u[static_cast<std::size_t>(i)]));
    }
  }
}

const double* Coordinates::arguments(double t, ConstVec q, const double* u) const {
  x_[FormulaNames::kTime] = t;
  std::copy_n(q.data(), n(), x_.begin() + 1);
  std::copy_n(u, n(), x_.begin() + 1 + n());
  std::copy_n(u, n(), w_.begin() + 1);
  return x_.data();
}

Blocks Coordinates::blocks() const { return {n(), n(), 1, constantMass_}; }

void Coordinates::initialState(Vec q, Vec u) const { q = q0_, u = u0_; }

double Coordinates::massEntry(const double* m, int i, int j) const {
  if (inertia_ == Inertia::full) return m[i * n() + j];
  if (i > j) std::swap(i, j);
  return m[i * n() - i * (i - 1) / 2 + j - i];
}

void Coordinates::M(double t, ConstVec q, MassBlocks M) const {
  std::fill(x_.begin() + 1 + n(), x_.end(), 0.0);
  x_[FormulaNames::kTime] = t;
  std::copy_n(q.data(), n(), x_.begin() + 1);
  Block out = M[0];
  if (inertia_ != Inertia::energy) {
    const double* m = mass_->eval(x_.data());
    for (int i = 0; i < n(); ++i)
      for (int j = 0; j < n(); ++j) out(i, j) = massEntry(m, std::min(i, j), std::max(i, j));
    return;
  }
  for (int i = 0; i < n(); ++i)
    for (int j = i; j < n(); ++j)
      out(i, j) = out(j, i) = mass_->secondPartial(x_.data(), u_[static_cast<std::size_t>(i)],
                                                   u_[static_cast<std::size_t>(j)])[0];
}

void Coordinates::h(double t, ConstVec q, ConstVec u, Vec h) const {
  const double* x = arguments(t, q, u.data());
  h.setZero();
  if (force_) h = ConstVec(force_->eval(x), n());
  if (potential_) h -= ConstVec(potential_->gradient(x, q_), n());
  if (inertia_ == Inertia::energy) addGyroscopic(1.0, h);
}

/// h += factor · (∂T/∂q − (∂t + u·∂q) ∂T/∂u) at x_.
void Coordinates::addGyroscopic(double factor, Vec h) const {
  const double* gradient = mass_->gradient(x_.data(), q_);
  for (int i = 0; i < n(); ++i) h[i] += factor * gradient[i];
  for (int i = 0; i < n(); ++i) {
    const auto slot = static_cast<std::size_t>(u_[static_cast<std::size_t>(i)]);
    unit_[slot] = 1.0;
    h[i] -= factor * mass_->second(x_.data(), unit_.data(), w_.data())[0];
    unit_[slot] = 0.0;
  }
}

/// h += factor · (∂T/∂q − (∂t + u·∂q) ∂T/∂u) for given M, with T = ½ uᵀMu.
void Coordinates::addGyroscopicOfM(double factor, Vec h) const {
  const double* u = x_.data() + 1 + n();
  const double* rate = mass_->derivative(x_.data(), w_.data());
  for (int i = 0; i < n(); ++i)
    for (int j = 0; j < n(); ++j)
      h[i] -= factor * massEntry(rate, std::min(i, j), std::max(i, j)) * u[j];
  for (int i = 0; i < n(); ++i) {
    const double* slope = mass_->partial(x_.data(), q_[static_cast<std::size_t>(i)]);
    double sum = 0.0;
    for (int j = 0; j < n(); ++j)
      for (int k = 0; k < n(); ++k)
        sum += massEntry(slope, std::min(j, k), std::max(j, k)) * u[j] * u[k];
    h[i] += 0.5 * factor * sum;
  }
}

double Coordinates::potentialEnergy(double t, ConstVec q) const {
  return potential_ ? potential_->eval(arguments(t, q, u0_.data()))[0] : 0.0;
}

void Coordinates::nonPotentialForce(double t, ConstVec q, ConstVec u, Vec h) const {
  const double* x = arguments(t, q, u.data());
  h.setZero();
  if (force_) h = ConstVec(force_->eval(x), n());
  // If M is given, the user's h includes the gyroscopic terms.
  if (inertia_ != Inertia::energy && !constantMass_) addGyroscopicOfM(-1.0, h);
}

void Coordinates::frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const {
  const double* x = arguments(t, q, u.data());
  frames_[static_cast<std::size_t>(id)]->evaluate(x, w_.data(), out);
}

bool Coordinates::dh(double t, ConstVec q, ConstVec u, int, Block K, Block D) const {
  using Columns = Eigen::Map<const Eigen::MatrixXd>;
  const double* x = arguments(t, q, u.data());
  K.setZero(), D.setZero();
  if (force_) {
    K = Columns(force_->gradient(x, q_), n(), n());
    D = Columns(force_->gradient(x, u_), n(), n());
  }
  if (potential_)
    for (int i = 0; i < n(); ++i)
      for (int j = 0; j < n(); ++j)
        K(i, j) -= potential_->secondPartial(x, q_[static_cast<std::size_t>(i)],
                                             q_[static_cast<std::size_t>(j)])[0];
  return true;
}

void Coordinates::describe(Description& d) const {
  for (int i = 0; i < n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    d.coordinate(names_.q[k], units_[k], i, "coordinate");
    d.velocity(names_.u[k], rate(units_[k]), i, "its velocity");
  }
  for (std::size_t k = 0; k < frames_.size(); ++k) {
    const int id = static_cast<int>(k);
    d.frame(frames_[k]->name(), id);
    for (const auto& s : frames_[k]->shapes()) d.shape(*s, id);
  }
  announceInstants(d, [this](double t) {
    double next = std::numeric_limits<double>::infinity();
    for (const Tape* tape : {mass_.get(), force_.get(), potential_.get()})
      if (tape) next = std::min(next, tape->nextInstant(t));
    for (const auto& frame : frames_) next = std::min(next, frame->nextInstant(t));
    return next;
  });
}

void Coordinates::declare(Attributes& a) {
  a.about(
      "System in minimal coordinates of its own, written as formulas over t, the coordinates, "
      "their velocities (name_dot) and the parameters of the model. "
      "M u' = h - dV/dq with M given, or Lagrange's equations of a kinetic energy.");
  a.add(AttributeType::names, "q", std::nullopt, "names of the coordinates");
  a.add(AttributeType::names, "units", "", "unit of each coordinate: m, rad or -");
  a.vector("q0", Unit::any, 0, "", "initial positions; default: zeros");
  a.vector("u0", Unit::any, 0, "", "initial velocities; default: zeros");
  a.add(AttributeType::expressions, "M", "",
        "mass matrix of t and q: all entries row after row, or those of the upper triangle");
  a.add(AttributeType::expression, "kineticEnergy", "",
        "kinetic energy T(t, q, q_dot), quadratic in q_dot, instead of M [J]");
  a.add(AttributeType::expressions, "h", "",
        "generalised forces without potential; with M given also the gyroscopic terms");
  a.add(AttributeType::expression, "potential", "",
        "potential energy V(t, q) [J]; its forces are -dV/dq");
  a.child(Kind::part, 0, 1000, "frames that carry shapes, joints and contacts", "CoordinateFrame");
  a.add(AttributeType::flag, "stiff", "false",
        "true: h and the potential are taken linearly implicitly by the schemes, with exact "
        "derivatives");
  a.example(
      "<Coordinates name=\"pendulum\" q=\"phi\" units=\"rad\" q0=\"30deg\" M=\"2 * 0.5^2\" "
      "potential=\"-2 * 9.81 * 0.5 * cos(phi)\"/>");
}

}  // namespace dynamy
