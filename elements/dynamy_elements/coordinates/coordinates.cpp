#include <algorithm>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/coordinates/coordinates.hpp>

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

Coordinates::Coordinates(const Parameters& x) : PartialMechanicalSystem(x) {
  Diagnostics faults;
  for (auto& part : x.take<CoordinatePart>())
    if (CoordinatePart* own = part.release(); own->frame() != nullptr)
      frames_.emplace_back(own->frame());
    else
      jumps_.add(std::unique_ptr<CoordinateJump>(own->jump()));
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
  w_ = x_;
  w_[FormulaNames::kTime] = 1.0;
}

void Coordinates::compile(const Parameters& x, Diagnostics& faults) {
  const SymbolTable symbols = names_.symbols();
  const std::size_t before = faults.size();
  inertia_.compile(x, names_, q0_, u0_, faults);

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
  jumps_.compile(names_, faults);
  if (faults.size() > before) return;
  if (!force.empty()) force_ = std::make_unique<Tape>(forces.finish(), names_);
  if (!energy.empty()) potential_ = std::make_unique<Tape>(energies.finish(), names_);
  if (potential_ && potential_->dependsOn(u_))
    faults.add(energy.fault(0, "a potential depends on t and positions only"));
}

const double* Coordinates::arguments(double t, ConstVec q, const double* u) const {
  x_[FormulaNames::kTime] = t;
  std::copy_n(q.data(), n(), x_.begin() + 1);
  std::copy_n(u, n(), x_.begin() + 1 + n());
  std::copy_n(u, n(), w_.begin() + 1);
  return x_.data();
}

Blocks Coordinates::blocks() const { return {n(), n(), 1, inertia_.constant()}; }

void Coordinates::initialState(Vec q, Vec u) const { q = q0_, u = u0_; }

void Coordinates::M(double t, ConstVec q, MassBlocks M) const {
  std::fill(x_.begin() + 1 + n(), x_.end(), 0.0);
  x_[FormulaNames::kTime] = t;
  std::copy_n(q.data(), n(), x_.begin() + 1);
  inertia_.mass(x_.data(), M[0]);
}

void Coordinates::h(double t, ConstVec q, ConstVec u, Vec h) const {
  const double* x = arguments(t, q, u.data());
  h.setZero();
  if (force_) h = ConstVec(force_->eval(x), n());
  if (potential_) h -= ConstVec(potential_->gradient(x, q_), n());
  if (inertia_.byEnergy()) inertia_.addGyroscopic(1.0, x, w_.data(), h);
}

double Coordinates::potentialEnergy(double t, ConstVec q) const {
  return potential_ ? potential_->eval(arguments(t, q, u0_.data()))[0] : 0.0;
}

void Coordinates::nonPotentialForce(double t, ConstVec q, ConstVec u, Vec h) const {
  const double* x = arguments(t, q, u.data());
  h.setZero();
  if (force_) h = ConstVec(force_->eval(x), n());
  // If M is given, the user's h includes the gyroscopic terms.
  if (!inertia_.byEnergy() && !inertia_.constant()) inertia_.addGyroscopic(-1.0, x, w_.data(), h);
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
    double next = inertia_.nextInstant(t);
    for (const Tape* tape : {force_.get(), potential_.get()})
      if (tape) next = std::min(next, tape->nextInstant(t));
    for (const auto& frame : frames_) next = std::min(next, frame->nextInstant(t));
    return std::min(next, jumps_.nextInstant(t));
  });
  if (jumps_.empty()) return;
  d.signal(kSwitching, Unit::none, "positive where a jump takes place",
           [this](const SignalView& v) { return jumps_.monitor(arguments(v.t, v.q, v.u.data())); });
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
        "kinetic energy T(t, q, q_dot), quadratic in q_dot, instead of M")
      .in(Unit::energy);
  a.add(AttributeType::expressions, "h", "",
        "generalised forces without potential; with M given also the gyroscopic terms");
  a.add(AttributeType::expression, "potential", "",
        "potential energy V(t, q); its forces are -dV/dq")
      .in(Unit::energy);
  a.child(Kind::part, 0, 1000, "frames that carry shapes, joints and contacts", "CoordinateFrame");
  a.child(Kind::part, 0, 100, "jumps of a hybrid system", "Jump");
  a.add(AttributeType::flag, "stiff", "false",
        "true: h and the potential are taken linearly implicitly by the schemes, with exact "
        "derivatives");
  a.example(
      "<Coordinates name=\"pendulum\" q=\"phi\" units=\"rad\" q0=\"30deg\" M=\"2 * 0.5^2\" "
      "potential=\"-2 * 9.81 * 0.5 * cos(phi)\"/>");
}

}  // namespace dynamy
