#include <algorithm>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/law/bilateral_rate.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/coordinates/coordinate_contact.hpp>
#include <dynamy_elements/laws/friction_of_law.hpp>

namespace dynamy {

void CoordinateContact::declare(Attributes& a) {
  a.about(
      "Contact, stop or friction on one system by formulas over t, its coordinates and the "
      "parameters of the model: gap and slip directions. Derivatives are exact.");
  a.reference("on", "system", "the system whose coordinates the formulas use");
  a.add(AttributeType::expression, "gap", "", "gap g(t, q) [m]; with a bilateral law: g = 0");
  a.add(AttributeType::expressions, "slip", "",
        "slip directions of t and q: one component per coordinate, directions separated by |");
  a.add(AttributeType::expressions, "slipVelocity", "",
        "slip velocities instead of directions: formulas affine in the velocities [m/s]");
  a.add(AttributeType::expressions, "drawnAt", "",
        "place in the world where its force is drawn and recorded, x; y; z, formulas of t and "
        "positions [m]; default: it has no place");
  a.vector("drawnNormal", Unit::none, 3, "0 0 1",
           "direction of the force on the system where the gap presses it, at that place")
      .notZero();
  a.vector("drawnAlong", Unit::none, 3, "0 0 0",
           "direction of the first slip there; default: any across");
  ReservoirSwitch::declare(a, "t, positions, velocities and signals");
  a.child(Kind::law, 0, 1, "law of the contact; default: Unilateral with epsilonN = 0");
  a.example(
      "<CoordinateContact on=\"pendulum\" gap=\"0.2 - 0.5*sin(phi)\">"
      "<Unilateral epsilonN=\"0.5\"/></CoordinateContact>");
}

CoordinateContact::CoordinateContact(const Parameters& x)
    : NonSmoothElement(x),
      on_(x["on"].text),
      gapText_(x, "gap"),
      slipText_(x, "slip"),
      slipVelocityText_(x, "slipVelocity"),
      placeText_(x, "drawnAt"),
      law_(x.takeOne<SetValuedForceLaw>()),
      switch_(x),
      normal_(x["drawnNormal"].vec3().normalized()),
      along_(x["drawnAlong"].vec3()) {
  along_ -= normal_.dot(along_) * normal_;
  if (along_.norm() > 1e-6 * x["drawnAlong"].vec3().norm())
    along_.normalize();
  else
    along_ = normal_.unitOrthogonal();
  if (!placeText_.empty() && placeText_.size() != 3)
    throw ModelError(placeText_.fault(-1, "expects three formulas, x; y; z"));
  if (!law_) law_ = std::make_unique<Unilateral>(0.0);
  names_.parameters = x.symbols;
  if (!slipText_.empty() && !slipVelocityText_.empty())
    throw ModelError(slipVelocityText_.fault(-1, "slip and slipVelocity are both given"));
  if (gapText_.size() > 1) throw ModelError(gapText_.fault(-1, "expects one formula"));
  if (gapText_.empty() && law_->unilateral())
    throw ModelError(Diagnostic{.place = place(),
                                .element = type() + " name=\"" + name() + '"',
                                .text = "the gap is missing",
                                .hint = "only laws that always act can do without"});
  if (gapText_.empty() && law_->rowKind(0) == RowKind::joint)
    law_ = std::make_unique<BilateralRate>();
  tangents_ = directions() ? slipText_.rows() : slipVelocityText_.size();
  if (tangents_ == 0 && gapText_.empty())
    throw ModelError(Diagnostic{.place = place(),
                                .element = type() + " name=\"" + name() + '"',
                                .text = "there is nothing that it could act on",
                                .hint = "add gap, slip or slipVelocity"});
  if (tangents_ == 0 && hasFriction(*law_))
    throw ModelError(Diagnostic{.place = place(),
                                .element = type() + " name=\"" + name() + '"',
                                .text = "there is no direction in which the friction could act",
                                .hint = "add slip or slipVelocity, or take Unilateral"});
}

CoordinateContact::~CoordinateContact() = default;

void CoordinateContact::connect(Topology& topology) {
  own_ = {topology, on_, *this};
  nameCoordinates(own_.system());
  compile();
  switch_.connect(topology, *this, *law_, names_);
}

void CoordinateContact::nameCoordinates(const PartialMechanicalSystem& system) {
  const std::string element = type() + " name=\"" + name() + '"';
  const auto bad = [&](std::string text) {
    throw ModelError(Diagnostic{.place = place(), .element = element, .text = std::move(text)});
  };
  Description d;
  system.describe(d);
  const Blocks b = system.blocks();
  const auto n = static_cast<std::size_t>(b.nq);
  if (b.capacity != 1 || b.nq == 0 || b.nq != b.nu || d.coordinates.size() != n ||
      d.velocities.size() != n)
    bad("\"" + on_ + "\" does not name one coordinate and one velocity per degree of freedom");

  // W is the gradient of g only if q̇ = u.
  Eigen::VectorXd q(b.nq), u(b.nq), qdot(b.nq);
  system.initialState(view(q), view(u));
  for (int i = 0; i < b.nq; ++i) u[i] = 1.0 + 0.37 * i;
  const Eigen::VectorXd& cq = q;
  const Eigen::VectorXd& cu = u;
  system.qdot(0.0, view(cq), view(cu), view(qdot));
  if (qdot != u) bad("the velocities of \"" + on_ + "\" are not the derivatives of its positions");

  names_.q.assign(n, {}), names_.u.assign(n, {});
  for (const auto& [name, i] : d.coordinates) names_.q[static_cast<std::size_t>(i)] = name;
  for (const auto& [name, i] : d.velocities) names_.u[static_cast<std::size_t>(i)] = name;
  q_ = names_.qSlots(), u_ = names_.uSlots();
  x_.assign(static_cast<std::size_t>(names_.inputs()), 0.0);
  w_ = x_;
  w_[FormulaNames::kTime] = 1.0;
}

void CoordinateContact::compile() {
  Diagnostics faults;
  ExpressionCompiler gap(names_.symbols()), slip(names_.symbols());
  gapText_.compileAll(gap, faults);
  const FormulaText& rows = directions() ? slipText_ : slipVelocityText_;
  rows.compileAll(slip, faults);
  if (directions() && !slipText_.rowsHave(names_.n()))
    faults.add(slipText_.fault(
        -1, "expects " + std::to_string(names_.n()) + " components for each slip direction",
        "directions are separated by |"));
  faults.throwIfAny();
  ExpressionCompiler place(names_.symbols());
  placeText_.compileAll(place, faults);
  faults.throwIfAny();
  if (!placeText_.empty()) place_ = std::make_unique<Tape>(place.finish(), names_);
  if (!gapText_.empty()) gap_ = std::make_unique<Tape>(gap.finish(), names_);
  if (!rows.empty()) slip_ = std::make_unique<Tape>(slip.finish(), names_);

  if (gap_ && gap_->dependsOn(u_))
    faults.add(gapText_.fault(0, "a gap depends on t and positions only"));
  for (int k = 0; k < rows.size(); ++k) {
    if (!directions() && !slip_->set().isAffine(k, u_))
      faults.add(rows.fault(k, "a slip velocity must be affine in the velocities"));
    for (const int s : u_)
      if (directions() && slip_->set().dependsOn(k, s)) {
        faults.add(rows.fault(k, "a slip direction depends on t and positions only",
                              "slipVelocity takes a formula of the velocities"));
        break;
      }
  }
  faults.throwIfAny();
}

void CoordinateContact::inputs(const Kinematics& k) const {
  const int n = names_.n();
  x_[FormulaNames::kTime] = k.t();
  std::copy_n(own_.q(k).data(), n, x_.begin() + 1);
  const ConstVec u = own_.u(k);
  std::copy_n(u.data(), n, x_.begin() + 1 + n);
  std::copy_n(u.data(), n, w_.begin() + 1);
}

void CoordinateContact::contacts(const Kinematics& k, ContactSink& sink) const {
  if (!switch_.engaged(k)) return;
  inputs(k);
  const double g = gap_ ? gap_->eval(x_.data())[0] : 0.0;
  auto out = sink.add(0, law_->unilateral() ? g : std::abs(g), *law_, rows());
  if (!out) return;
  out.scale(switch_.scale(k, x_.data()));
  const SystemHandle& system = own_.handle();
  const Block moving = out.segment(system), W = own_.room(moving);
  const int first = gap_ ? 1 : 0;
  if (gap_ && out.dim() > 0) gapRow(x_.data(), out, W);
  if (slip_ && out.dim() > first) slipRows(x_.data(), first, out, W);
  if (place_) {
    const double* at = place_->eval(x_.data());
    out.place({at[0], at[1], at[2]}, normal_, along_, normal_.cross(along_));
  }
  const double* bias = own_.carry(k, moving);
  for (int r = 0; bias && out.wantsBias() && r < out.dim(); ++r) out.bias(r) += bias[r];
}

void CoordinateContact::gapRow(const double* x, ContactRows& out, Block W) const {
  out.position(0) = gap_->eval(x)[0];
  const double* gradient = gap_->gradient(x, q_);
  for (int j = 0; j < W.cols(); ++j) W(0, j) = gradient[j];
  out.chi(0) = gap_->partial(x, FormulaNames::kTime)[0];
  if (out.wantsBias()) out.bias(0) = gap_->second(x, w_.data(), w_.data())[0];
}

void CoordinateContact::slipRows(const double* x, int first, ContactRows& out, Block W) const {
  const int n = names_.n(), count = std::min(tangents_, out.dim() - first);
  const double* u = x + 1 + n;
  // Slip directions are the rows of W; for slip velocities W is ∂γ/∂u, and χ the rest of γ.
  const double* value = directions() ? slip_->eval(x) : slip_->gradient(x, u_);
  for (int r = 0; r < count; ++r)
    for (int j = 0; j < n; ++j)
      W(first + r, j) = directions() ? value[r * n + j] : value[r + j * tangents_];
  if (!directions())
    for (int r = 0; r < count; ++r) {
      out.chi(first + r) = slip_->value()[r];
      for (int j = 0; j < n; ++j) out.chi(first + r) -= W(first + r, j) * u[j];
    }
  if (!out.wantsBias()) return;
  // The bias is d/dt of the row with u constant.
  const double* rate = slip_->derivative(x, w_.data());
  for (int r = 0; r < count; ++r) {
    double& bias = out.bias(first + r);
    if (!directions()) bias = rate[r];
    for (int j = 0; directions() && j < n; ++j) bias += rate[r * n + j] * u[j];
  }
}

void CoordinateContact::remember(const Kinematics& k, Vec memory) const {
  inputs(k);
  switch_.remember(k, x_.data(), memory);
}

double CoordinateContact::nextInstant(double t) const {
  double next = switch_.nextInstant(t);
  for (const Tape* tape : {gap_.get(), slip_.get()})
    if (tape) next = std::min(next, tape->nextInstant(t));
  return next;
}

void CoordinateContact::describe(Description& d) const {
  describeContact(d, 0, rows(), *law_);
  switch_.describe(d);
  announceInstants(d, [this](double t) { return nextInstant(t); });
  if (switch_.engages())
    d.signal(kSwitching, Unit::none, "positive where the law would be engaged or released",
             [this](const SignalView& v) {
               inputs(*v.kinematics);
               return switch_.switching(*v.kinematics, x_.data());
             });
}

}  // namespace dynamy
