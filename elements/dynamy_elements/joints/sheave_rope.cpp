#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/constants.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/joints/sheave_rope.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

constexpr double kBrokenNow = 1e-13;  ///< part of the time within which a rope has just broken
constexpr double kNoWrap = 1e-9;      ///< an angle of wrap below is zero [rad]

/// Adds the Jacobian of m·Ω to a row.
void addSpin(Block W, int row, const Frame& f, const Vec3& m) {
  for (int j = 0; j < f.nu(); ++j) W(row, j) += f.J_R_I.col(j).dot(m);
}

/// Acceleration at u̇ = 0 of the body point at rho_I.
Vec3 ropePointBias(const Frame& f, const Vec3& rho_I) {
  return f.bias_S_I + f.bias_R_I.cross(rho_I) + f.Omega_I.cross(f.Omega_I.cross(rho_I));
}

}  // namespace

void SheaveRope::declare(Attributes& a) {
  a.about(
      "A massless, inextensible rope from a point of A over a sheave to a point of B; it can go "
      "slack. Law: Unilateral (default: it runs freely over the sheave) or BeltFriction. Signals: "
      "slack g, forceA and forceB of the strands.");
  FramePair::declare(a);
  a.vector("pointA", Unit::length, 3, "0 0 0", "end on A, in axes of A");
  a.vector("pointB", Unit::length, 3, "0 0 0", "end on B, in axes of B");
  a.reference("sheave", "frame", "frame in the centre of the sheave: a system, or system.frame");
  a.required("radius", Unit::length, "radius of the sheave").positive();
  a.vector("axis", Unit::none, 3, "0 0 0",
           "axis of the sheave at the start, in the world; planar bodies have their own");
  a.vector(
       "side", Unit::none, 3, "0 0 1",
       "side of the sheave on which the middle of the wrap lies, in the world; default: the top")
      .notZero();
  a.add(AttributeType::integer, "turns", "0", "full turns besides the angle of the geometry")
      .nonNegative();
  Attribute& length = a.add(AttributeType::number, "length", std::nullopt,
                            "length of the rope; default: taut at the start");
  length.unit = Unit::length;
  length.mayBeAbsent().positive();
  Attribute& breaks = a.add(AttributeType::number, "breaksAt", std::nullopt,
                            "time at which the rope breaks, for good; default: never");
  breaks.unit = Unit::time;
  breaks.optionalValue = true;
  a.reference("carrier", "frame",
              "frame that carries the sheave: the replay draws the strands to it")
      .mayBeAbsent();
  a.child(Kind::law, 0, 1, "law of the rope on the sheave; default: Unilateral with epsilonN = 0");
  a.example(
      "<SheaveRope between=\"ball bob\" pointA=\"-0.25 0 -1\" pointB=\"0.25 0 -1\" sheave=\"rod\" "
      "axis=\"0 1 0\" radius=\"0.25\">"
      "<BeltFriction mu=\"0.2\" wrap=\"180deg\"/></SheaveRope>");
}

SheaveRope::SheaveRope(const Parameters& x)
    : NonSmoothElement(x),
      frames_(x),
      pointA_(x["pointA"].vec3()),
      pointB_(x["pointB"].vec3()),
      axis_(x["axis"].vec3()),
      side_(x["side"].vec3().normalized()),
      sheaveName_(x["sheave"].text),
      carrierName_(x.has("carrier") ? x["carrier"].text : std::string()),
      radius_(x["radius"]),
      length_(x.has("length") ? double(x["length"]) : 0.0),
      breaksAt_(x.has("breaksAt") ? double(x["breaksAt"])
                                  : std::numeric_limits<double>::infinity()),
      turns_(x["turns"].integer()),
      law_(x.takeOne<SetValuedForceLaw>()) {
  if (!law_) law_ = std::make_unique<Unilateral>(0.0);
  if (!law_->unilateral())
    throw ModelError("a rope needs a law that acts while it is taut",
                     "<BeltFriction mu=\"0.2\" wrap=\"180deg\"/> or <Unilateral/>");
}

SheaveRope::~SheaveRope() = default;

SheaveRope::Strand SheaveRope::strand(const Frame& body, const Vec3& point, const Frame& sheave,
                                      const Vec3& axis_I, double turn) const {
  Strand out;
  out.rho_I = body.A_IK * point;
  out.e = body.r_OS_I + out.rho_I - sheave.r_OS_I;
  out.aside = axis_I.dot(out.e);
  const Vec3 d = out.e - out.aside * axis_I;
  if (flat_) out.e = d, out.aside = 0.0;
  const double D = d.norm(), l = std::sqrt(std::max(D * D - radius_ * radius_, 0.0));
  out.inPlane = l, out.length = std::hypot(l, out.aside);
  // d = r n + l t with t = turn a × n is solved for n.
  out.n = (radius_ * d - turn * l * axis_I.cross(d)) / (D * D);
  out.t = turn * axis_I.cross(out.n);
  out.w = (l * out.t + out.aside * axis_I) / out.length -
          radius_ * (1.0 / l - 1.0 / out.length) * out.n;
  out.m = radius_ / l * out.e.cross(out.n);
  return out;
}

double SheaveRope::wrap(const Strand& a, const Strand& b, const Vec3& axis_I, double sense) const {
  return std::atan2(sense * axis_I.dot(a.n.cross(b.n)), a.n.dot(b.n));
}

void SheaveRope::chooseSense(const Frame& A, const Frame& B, const Frame& S, const Vec3& axis_I) {
  // Both senses of wrap, with straight or crossed strands, may pass the wanted side: the shorter
  // arc is chosen.
  double best = -2.0;
  for (const double sense : {1.0, -1.0}) {
    const Strand a = strand(A, pointA_, S, axis_I, -sense),
                 b = strand(B, pointB_, S, axis_I, sense);
    double theta = wrap(a, b, axis_I, sense);
    if (theta < -kNoWrap) theta += kTwoPi;
    const double half = 0.5 * sense * theta;
    const Vec3 middle = std::cos(half) * a.n + std::sin(half) * axis_I.cross(a.n);
    const double along = middle.dot(side_), score = along > 0.0 ? 2.0 - theta / kTwoPi : along;
    if (score <= best) continue;
    best = score, sense_ = sense, wrap0_ = theta + kTwoPi * turns_;
  }
}

void SheaveRope::connect(Topology& topology) {
  frames_.connect(topology, *this);
  sheave_ = topology.frame(sheaveName_, *this);
  if (!carrierName_.empty()) carrier_ = topology.frame(carrierName_, *this);
  const StartKinematics start(topology, {frames_.A, frames_.B, sheave_});
  const Frame &A = start.frame(frames_.A), &B = start.frame(frames_.B), &S = start.frame(sheave_);
  const Vec3 given = axis_.isZero(0.0) ? frames_.planeNormal : axis_;
  if (given.isZero(0.0))
    throw ModelError("the axis of the sheave is missing", "add axis=\"0 1 0\"");
  const Vec3 axis_I = given.normalized();
  flat_ = !frames_.planeNormal.isZero(0.0);
  axis_S_ = S.A_IK.transpose() * axis_I;
  chooseSense(A, B, S, axis_I);
  const Strand a = strand(A, pointA_, S, axis_I, -sense_),
               b = strand(B, pointB_, S, axis_I, sense_);
  if (!(a.inPlane > 0.0 && b.inPlane > 0.0))
    throw ModelError("an end of the rope lies within the sheave",
                     "move it out or take a smaller radius");
  const double taut = a.length + b.length + radius_ * wrap0_;
  if (length_ == 0.0) length_ = taut;
  if (!carrierName_.empty()) {
    const Frame& C = start.frame(carrier_);
    for (int i = 0; i < 2; ++i)
      drawn_[i] = C.A_IK.transpose() * (S.r_OS_I + radius_ * (i == 0 ? a.n : b.n) - C.r_OS_I);
  }
}

void SheaveRope::contacts(const Kinematics& k, ContactSink& sink) const {
  if (k.t() >= breaksAt_) return;
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B), &S = k.frame(sheave_);
  const Vec3 axis_I = S.A_IK * axis_S_;
  const Strand a = strand(A, pointA_, S, axis_I, -sense_),
               b = strand(B, pointB_, S, axis_I, sense_);
  // The angle of wrap is the one nearest to that at the start: the rope
  // never changes by a whole turn.
  double theta = wrap(a, b, axis_I, sense_);
  theta += kTwoPi * std::round((wrap0_ - theta) / kTwoPi);
  if (theta < 0.0) return straight(A, a, B, b, sink);
  ContactRows out = sink.add(0, length_ - a.length - b.length - radius_ * theta, *law_, 2);
  if (!out) return;
  const bool slips = out.dim() > 1;
  const auto end = [&](const Frame& f, const Strand& s, double slip) {
    if (f.block >= 0) {
      const Block W = out.segment(f);
      addPointRow(W, 0, f, s.rho_I, s.w, -1.0);
      if (slips) addPointRow(W, 1, f, s.rho_I, s.w, slip);
    }
    const double nu = s.w.dot(f.nu_S_I + f.nu_R_I.cross(s.rho_I));
    out.chi(0) -= nu;
    if (slips) out.chi(1) += slip * nu;
  };
  end(A, a, -0.5);
  end(B, b, 0.5);
  const Vec3 pull = a.w + b.w, across = 0.5 * (a.w - b.w);
  const Vec3 turns = -a.m - b.m, spin = 0.5 * (b.m - a.m);
  if (S.block >= 0) {
    const Block W = out.segment(S);
    addPointRow(W, 0, S, Vec3::Zero(), pull, 1.0);
    addSpin(W, 0, S, turns);
    if (slips) {
      addPointRow(W, 1, S, Vec3::Zero(), across, 1.0);
      addSpin(W, 1, S, spin);
    }
  }
  out.chi(0) += pull.dot(S.nu_S_I) + turns.dot(S.nu_R_I);
  if (slips) out.chi(1) += across.dot(S.nu_S_I) + spin.dot(S.nu_R_I);
  if (out.wantsBias()) bias(out, k, a, b);
}

/// A rope that has left the sheave runs straight from P to Q. Its one row is a contact of its own where
/// the law has more.
void SheaveRope::straight(const Frame& A, const Strand& a, const Frame& B, const Strand& b,
                          ContactSink& sink) const {
  const bool alike = law_->dim(2) == 1;
  const Vec3 d = b.e - a.e;
  const double D = d.norm();
  const Vec3 e = D > 0.0 ? Vec3(d / D) : a.t;
  const SetValuedForceLaw* const law = alike ? law_.get() : &free_;
  ContactRows out = sink.add(alike ? 0 : kStraight, length_ - D, *law, 1);
  if (!out) return;
  const auto end = [&](const Frame& f, const Strand& s, double sign) {
    if (f.block >= 0) addPointRow(out.segment(f), 0, f, s.rho_I, e, sign);
    out.chi(0) += sign * e.dot(f.nu_S_I + f.nu_R_I.cross(s.rho_I));
  };
  end(A, a, 1.0);
  end(B, b, -1.0);
  if (!out.wantsBias()) return;
  const Vec3 rate = B.velocity(b.rho_I) - A.velocity(a.rho_I);
  const double along = e.dot(rate), across = (rate - along * e).squaredNorm();
  out.bias(0) =
      -e.dot(ropePointBias(B, b.rho_I) - ropePointBias(A, a.rho_I)) - (D > 0.0 ? across / D : 0.0);
}

/// ṗ at u̇ = 0. The strand turns about the axis by α̇ = (a × t)·ė/l against the sheave, ė as seen
/// from the sheave.
double SheaveRope::biasOf(const Frame& f, const Frame& S, const Strand& s) const {
  const double r = radius_, l = s.inPlane, h = s.aside, L = s.length;
  const Vec3 a = S.A_IK * axis_S_, Omega = S.Omega_I;
  const Vec3 rate = f.velocity(s.rho_I) - S.v_S_I, seen = rate - Omega.cross(s.e);
  const Vec3 turn = Omega + a.cross(s.t).dot(seen) / l * a;
  const Vec3 n = turn.cross(s.n), t = turn.cross(s.t), axis = Omega.cross(a);
  const double dl = (s.e - h * a).dot(seen) / l, dh = a.dot(seen), dL = (l * dl + h * dh) / L;
  const Vec3 u = (l * s.t + h * a) / L,
             du = (dl * s.t + l * t + dh * a + h * axis) / L - dL / L * u;
  const Vec3 dw = du + r * (dl / (l * l) - dL / (L * L)) * s.n - r * (1.0 / l - 1.0 / L) * n;
  const Vec3 dm = -dl / l * s.m + r / l * (rate.cross(s.n) + s.e.cross(n));
  return s.w.dot(ropePointBias(f, s.rho_I) - S.bias_S_I) + dw.dot(rate) + s.m.dot(S.bias_R_I) +
         dm.dot(Omega);
}

void SheaveRope::bias(ContactRows& out, const Kinematics& k, const Strand& a,
                      const Strand& b) const {
  const Frame& S = k.frame(sheave_);
  const double ofA = biasOf(k.frame(frames_.A), S, a), ofB = biasOf(k.frame(frames_.B), S, b);
  out.bias(0) = -ofA - ofB;
  if (out.dim() > 1) out.bias(1) = 0.5 * (ofB - ofA);
}

double SheaveRope::force(const SignalView& v, double sign) {
  int i = v.contacts->find(v.element, 0);
  if (i < 0) i = v.contacts->find(v.element, kStraight);
  if (i < 0 || !(v.dt > 0.0) || v.Lambda.size() == 0) return 0.0;
  const int first = v.contacts->row0[static_cast<std::size_t>(i)];
  const double traction = v.contacts->dim(i) > 1 ? v.Lambda[first + 1] : 0.0;
  return (v.Lambda[first] + 0.5 * sign * traction) / v.dt;
}

void SheaveRope::drawStrands(Description& d) const {
  d.link({frames_.A.index, carrier_.index, pointA_, drawn_[0]});
  d.link({frames_.B.index, carrier_.index, pointB_, drawn_[1]});
}

void SheaveRope::describe(Description& d) const {
  if (!carrierName_.empty()) drawStrands(d);
  describeContact(d, 0, 2, *law_);
  d.signal("forceA", Unit::force, "rope force at A",
           [](const SignalView& v) { return force(v, 1.0); });
  d.signal("forceB", Unit::force, "rope force at B",
           [](const SignalView& v) { return force(v, -1.0); });
  announceInstants(d, [this](double t) {
    return t < breaksAt_ * (1.0 - kBrokenNow) ? breaksAt_ : std::numeric_limits<double>::infinity();
  });
}

}  // namespace dynamy
