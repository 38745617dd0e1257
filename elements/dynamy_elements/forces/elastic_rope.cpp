#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/blocks/block_states.hpp>
#include <dynamy_elements/forces/elastic_rope.hpp>

namespace dynamy {
namespace {

/// A full turn too few or too many is drawn back with this rate, so that errors of the state that
/// counts turns do not add up over a long run [1/s].
constexpr double kRecount = 1.0;

constexpr int kArcPieces = 6;  ///< of an arc in the replay

const char* const kTurns[2] = {"turnA", "turnB"};

}  // namespace

// ---- Sheave ------------------------------------------------------------------------------------

void Sheave::declare(Attributes& a) {
  a.about(
      "A sheave that an ElasticRope passes: it turns freely and has no inertia of its own, so that "
      "the rope pulls at its centre only.");
  a.reference("on", "frame", "frame that carries the sheave: a system, or system.frame");
  a.vector("point", Unit::length, 3, "0 0 0", "centre, in axes of the frame");
  a.required("radius", Unit::length, "radius of the sheave").positive();
  a.vector(
       "side", Unit::none, 3, "0 0 1",
       "side of the sheave on which the middle of the wrap lies, in the world; default: the top")
      .notZero();
  a.example(
      "<ElasticRope between=\"world ball\" pointA=\"2 0 0\" EA=\"1e4\" axis=\"0 1 0\">"
      "<Sheave on=\"world\" point=\"1 0 3\" radius=\"0.2\"/></ElasticRope>");
}

Sheave::Sheave(const Parameters& x)
    : Element(x),
      on_(x["on"].text),
      point_(x["point"].vec3()),
      side_(x["side"].vec3().normalized()),
      radius_(x["radius"]) {}

// ---- ElasticRope: declaration ------------------------------------------------------------------

void ElasticRope::declare(Attributes& a) {
  a.about(
      "A massless elastic rope from a point of A past free sheaves to a point of B; it can go "
      "slack. S = EA (eps + tau eps'), eps = (l - l0)/l0. An end may be wound on a drum, where the "
      "rope has no strain: the body A or B turns with it. Signals: force S, length l0 without "
      "strain, elongation l - l0 (negative: slack), and the turns of drums, turnA, turnB.");
  FramePair::declare(a);
  a.vector("pointA", Unit::length, 3, "0 0 0", "end on A, or the centre of its drum, in axes of A");
  a.vector("pointB", Unit::length, 3, "0 0 0", "end on B, or the centre of its drum, in axes of B");
  a.required("EA", Unit::force, "stiffness: force over strain").positive();
  a.optional("damping", Unit::time, 0.0, "tau: force over rate of strain and EA").nonNegative();
  Attribute& length = a.add(AttributeType::number, "length", std::nullopt,
                            "length l0 at the start, without strain; default: from the preload");
  length.unit = Unit::length;
  length.mayBeAbsent().positive();
  a.optional("preload", Unit::force, 0.0, "force S at the start, if no length is given")
      .nonNegative();
  a.optional("drumA", Unit::length, 0.0, "radius of the drum on A; 0: the end is fixed")
      .nonNegative();
  a.optional("drumB", Unit::length, 0.0, "radius of the drum on B; 0: the end is fixed")
      .nonNegative();
  a.vector("sideA", Unit::none, 3, "1 0 0",
           "side of the drum on A where the rope leaves it, in the world at the start")
      .notZero();
  a.vector("sideB", Unit::none, 3, "1 0 0",
           "side of the drum on B where the rope leaves it, in the world at the start")
      .notZero();
  a.vector("axis", Unit::none, 3, "0 0 0",
           "axis of sheaves and drums at the start, in the world; planar bodies have their own");
  a.reference("carrier", "frame",
              "frame that carries a drum and turns the axis; default: the world")
      .mayBeAbsent();
  a.child(Kind::part, 0, static_cast<int>(RopeWay::kMostCircles) - 2,
          "sheaves in their order from A to B", "Sheave");
  a.example(
      "<ElasticRope between=\"world ball\" pointA=\"2 0 0\" EA=\"1e4\" damping=\"0.01\" "
      "axis=\"0 1 0\"><Sheave on=\"world\" point=\"1 0 3\" radius=\"0.2\"/></ElasticRope>");
}

ElasticRope::ElasticRope(const Parameters& x)
    : ExternalForce(x),
      ends_(x),
      sheaves_(x.take<Sheave>()),
      carrierName_(x.has("carrier") ? x["carrier"].text : std::string()),
      axis_(x["axis"].vec3()),
      sideA_(x["sideA"].vec3().normalized()),
      sideB_(x["sideB"].vec3().normalized()),
      posts_(sheaves_.size() + 2),
      EA_(x["EA"]),
      damping_(x["damping"]),
      length_(x.has("length") ? double(x["length"]) : 0.0),
      preload_(x["preload"]) {
  posts_.front().point = x["pointA"].vec3(), posts_.front().radius = x["drumA"];
  posts_.back().point = x["pointB"].vec3(), posts_.back().radius = x["drumB"];
  int states = 0;
  for (Post* end : {&posts_.front(), &posts_.back()})
    if (end->radius > 0.0) end->state = states++;
  if (states > 0 && x.name.empty())
    throw ModelError("the rope has no name", "the turns of its drum are signals: add name=\"…\"");
  if (length_ > 0.0 && preload_ > 0.0)
    throw x["preload"].fault("length and preload are both given", "leave one of them out", 0,
                             x["preload"].text.size());
}

std::unique_ptr<PartialMechanicalSystem> ElasticRope::ownSystem() const {
  std::vector<std::string> names;
  if (posts_.front().state >= 0) names.emplace_back(kTurns[0]);
  if (posts_.back().state >= 0) names.emplace_back(kTurns[1]);
  if (names.empty()) return nullptr;
  Parameters x;
  x.type = type(), x.name = name(), x.place = place();
  const std::size_t states = names.size();
  return std::make_unique<BlockStates>(x, std::vector<double>(states, 0.0), std::move(names));
}

// ---- ElasticRope: start ------------------------------------------------------------------------

void ElasticRope::findPosts(Topology& topology) {
  ends_.find(topology, *this);
  posts_.front().frame = ends_.A, posts_.back().frame = ends_.B;
  for (std::size_t i = 0; i < sheaves_.size(); ++i) {
    const Sheave& s = *sheaves_[i];
    posts_[i + 1] = {
        .frame = topology.frame(s.on(), *this), .point = s.point(), .radius = s.radius()};
  }
  if (!carrierName_.empty()) carrier_ = topology.frame(carrierName_, *this);
  if (ownSystem()) states_ = topology.system(name(), *this);
  bool moves = false;
  Vec3 plane = Vec3::Zero();
  for (const Post& p : posts_) {
    const Blocks b = blocksOf(topology, p.frame);
    moves = moves || b.nu > 0;
    if (!b.planeNormal.isZero(0.0)) plane = b.planeNormal;
  }
  if (!moves)
    throw ModelError("the rope touches nothing that moves",
                     "one end or sheave has to be on a body with velocities of its own");
  flat_ = !plane.isZero(0.0);
  if (axis_.isZero(0.0)) axis_ = plane;
  const bool round =
      std::any_of(posts_.begin(), posts_.end(), [](const Post& p) { return p.radius > 0.0; });
  if (axis_.isZero(0.0) && round)
    throw ModelError("the axis of the sheaves is missing", "add axis=\"0 1 0\"");
  if (axis_.isZero(0.0)) axis_ = Vec3::UnitY();
  axis_.normalize();
}

void ElasticRope::connect(Topology& topology) {
  findPosts(topology);
  const StartKinematics start(topology);
  const Kinematics& k = start.kinematics();
  const Vec3 axis_I = axis_;
  if (!carrierName_.empty()) axis_ = k.frame(carrier_).A_IK.transpose() * axis_I;
  std::vector<RopeCircle> circles;
  std::vector<Vec3> sides{sideA_};
  for (const auto& s : sheaves_) sides.push_back(s->side());
  sides.push_back(sideB_);
  for (const Post& p : posts_) circles.push_back(circle(k, p, axis_I));
  chooseSenses(axis_I, circles, sides);
  const RopeWay way(axis_I, circles);
  double length = 0.0;
  for (int i = 0; i < way.strands(); ++i) {
    if (!(way.strand(i).length > 0.0))
      throw ModelError("two neighbours along the rope have no common tangent",
                       "an end lies within a sheave, or two sheaves overlap: move them apart");
    length += way.strand(i).length;
  }
  for (std::size_t i = 0; i < posts_.size(); ++i) {
    Post& p = posts_[i];
    const int n = static_cast<int>(i);
    p.sense = circles[i].sense;
    const bool inner = i > 0 && i + 1 < posts_.size();
    if (inner) p.wrap0 = way.wrap(n), length += p.radius * p.wrap0;
    if (p.state >= 0)
      p.mark = k.frame(p.frame).A_IK.transpose() * way.contact(n, i == 0 ? 0 : n - 1);
  }
  if (length_ == 0.0) length_ = length / (1.0 + preload_ / EA_);
  draw(k, way);
}

void ElasticRope::draw(const Kinematics& k, const RopeWay& way) {
  const int last = static_cast<int>(posts_.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const Post& p = posts_[static_cast<std::size_t>(i)];
    // A drum turns: its carrier shows where the rope leaves it.
    const FrameHandle by = p.state >= 0 && !carrierName_.empty() ? carrier_ : p.frame;
    const Frame &f = k.frame(p.frame), &shown = k.frame(by);
    const Vec3 centre = f.r_OS_I + f.A_IK * p.point - shown.r_OS_I;
    const auto at = [&](const Vec3& n) -> Vec3 {
      return shown.A_IK.transpose() * (centre + p.radius * n);
    };
    Vec3 from = way.contact(i, std::max(i - 1, 0));
    if (i > 0) links_.back().frameB = by.index, links_.back().pointB = at(from);
    if (i == last) break;
    const Vec3 first = from;
    for (int piece = 1; i > 0 && piece <= kArcPieces; ++piece) {
      const double angle = p.sense * p.wrap0 * piece / kArcPieces;
      const Vec3 to = std::cos(angle) * first + std::sin(angle) * way.axis().cross(first);
      links_.push_back({by.index, by.index, at(from), at(to)});
      from = to;
    }
    links_.push_back({by.index, by.index, at(from), at(from)});
  }
}

// ---- ElasticRope: motion -----------------------------------------------------------------------

Vec3 ElasticRope::axis(const Kinematics& k) const {
  return carrierName_.empty() ? axis_ : Vec3(k.frame(carrier_).A_IK * axis_);
}

RopeCircle ElasticRope::circle(const Kinematics& k, const Post& p, const Vec3& axis) const {
  const Frame& f = k.frame(p.frame);
  Vec3 centre = f.r_OS_I + f.A_IK * p.point;
  if (flat_) centre -= axis.dot(centre) * axis;
  return {centre, p.radius, p.sense};
}

RopeWay ElasticRope::way(const Kinematics& k) const {
  std::array<RopeCircle, RopeWay::kMostCircles> circles;
  const Vec3 a = axis(k);
  for (std::size_t i = 0; i < posts_.size(); ++i) circles[i] = circle(k, posts_[i], a);
  return {a, std::span(circles).first(posts_.size())};
}

Vec3 ElasticRope::strandVelocity(const Kinematics& k, int i) const {
  const auto velocity = [&](const Post& p) {
    const Frame& f = k.frame(p.frame);
    return f.velocity(f.A_IK * p.point);
  };
  const auto at = static_cast<std::size_t>(i);
  return velocity(posts_[at + 1]) - velocity(posts_[at]);
}

/// Ω of what carries the axis.
Vec3 ElasticRope::carrierRate(const Kinematics& k) const {
  return carrierName_.empty() ? Vec3::Zero() : Vec3(k.frame(carrier_).Omega_I);
}

double ElasticRope::drumRadius(int i) const {
  const Post &first = posts_.front(), &last = posts_.back();
  double out = 0.0;
  if (i == 0 && first.state >= 0) out -= first.sense * first.radius;
  if (i + 2 == static_cast<int>(posts_.size()) && last.state >= 0) out += last.sense * last.radius;
  return out;
}

/// Sheaves and drums take part in l̇ by the turn of strands against what carries the axis:
///
///   l̇ = Σ (v·ė + (l/L) ρ α̇ + (D − ρ) α̇_c),   α̇_c = (a × t)·(ė − Ω_c × e)/l
ElasticRope::Taut ElasticRope::taut(const Kinematics& k, const RopeWay& way) const {
  Taut out;
  out.free = length_;
  const int last = static_cast<int>(posts_.size()) - 1;
  const Vec3 Omega = carrierRate(k);
  const auto turns = [&](int i, const Vec3& spin) {
    const RopeStrand& s = way.strand(i);
    return s.across.dot(strandVelocity(k, i) - spin.cross(s.e)) / s.inPlane;
  };
  for (int i = 0; i < last; ++i) {
    const RopeStrand& s = way.strand(i);
    if (!(s.length > 0.0))
      throw ModelError("two neighbours along the rope run into each other",
                       "an end or a sheave has come too near to the next one; stop the run before");
    out.length += s.length, out.rate += s.v.dot(strandVelocity(k, i));
    if (s.rho != 0.0 || drumRadius(i) != 0.0)
      out.rate += s.inPlane / s.length * s.rho * turns(i, Vec3::Zero()) +
                  (drumRadius(i) - s.rho) * turns(i, Omega);
    if (i == 0) continue;
    const Post& p = posts_[static_cast<std::size_t>(i)];
    const double theta = way.wrap(i);
    out.length += p.radius * (theta + kTwoPi * std::round((p.wrap0 - theta) / kTwoPi));
  }
  for (int end = 0; end < 2; ++end) {
    const Post& p = end == 0 ? posts_.front() : posts_.back();
    if (p.state < 0) continue;
    const Frame& f = k.frame(p.frame);
    const int i = end == 0 ? 0 : last - 1;
    const Vec3 n = way.contact(end == 0 ? 0 : last, i), mark = f.A_IK * p.mark;
    const double angle = std::atan2(way.axis().dot(n.cross(mark)), n.dot(mark)),
                 counted = k.u(states_)[p.state];
    out.turn[end] = angle + kTwoPi * std::round((counted - angle) / kTwoPi);
    out.turnRate[end] = way.axis().dot(f.Omega_I - Omega) - turns(i, Omega);
    const double sign = (end == 0 ? 1.0 : -1.0) * p.sense * p.radius;
    out.free += sign * out.turn[end], out.freeRate += sign * out.turnRate[end];
  }
  if (!(out.free > 0.0))
    throw ModelError("the rope is wound up", "its free length is zero; stop the run before");
  out.strain = (out.length - out.free) / out.free;
  if (!(out.strain > 0.0)) return out;
  out.spring = EA_ * out.strain;
  const double strainRate = (out.rate - (1.0 + out.strain) * out.freeRate) / out.free;
  out.damper = std::max(EA_ * damping_ * strainRate, -out.spring);  // a rope does not push
  return out;
}

void ElasticRope::pull(const Kinematics& k, const RopeWay& way, double S, double extra,
                       ForceSink& sink) const {
  const auto lever = [&](const Post& p) { return Vec3(k.frame(p.frame).A_IK * p.point); };
  for (int i = 0; i < way.strands(); ++i) {
    const RopeStrand& s = way.strand(i);
    const Post &from = posts_[static_cast<std::size_t>(i)],
               &to = posts_[static_cast<std::size_t>(i) + 1];
    const double across = drumRadius(i) * extra, lean = 1.0 - s.inPlane / s.length;
    const bool turns = across != 0.0 || s.rho != 0.0;
    Vec3 F = S * s.v;
    if (turns) F -= (across + S * s.rho * lean) / s.inPlane * s.across;
    sink.force(k.frame(from.frame), lever(from), F);
    sink.force(k.frame(to.frame), lever(to), -F);
    if (turns && !carrierName_.empty())
      sink.moment(k.frame(carrier_), (across + S * s.rho) * s.aside / s.inPlane * s.t);
  }
  for (const Post* end : {&posts_.front(), &posts_.back()}) {
    if (end->state < 0) continue;
    const double sign = end == &posts_.front() ? 1.0 : -1.0;
    sink.moment(k.frame(end->frame), sign * end->sense * end->radius * (S + extra) * way.axis());
  }
}

void ElasticRope::addTo(const Kinematics& k, ForceSink& sink) const {
  const RopeWay way = this->way(k);
  const Taut now = taut(k, way);
  for (int end = 0; end < 2; ++end) {
    const int state = end == 0 ? posts_.front().state : posts_.back().state;
    if (state < 0) continue;
    const double rate = now.turnRate[end] + kRecount * (now.turn[end] - k.u(states_)[state]);
    sink.generalised(states_, state, BlockStates::kMass * rate);
  }
  if (!(now.strain > 0.0)) return;
  sink.hasPotential(true);
  pull(k, way, now.spring, 0.5 * now.spring * now.strain, sink);
  sink.hasPotential(false);
  if (damping_ > 0.0) pull(k, way, now.damper, now.damper * now.strain, sink);
}

double ElasticRope::potentialEnergy(const Kinematics& k) const {
  const Taut now = taut(k, way(k));
  return now.strain > 0.0 ? 0.5 * EA_ * now.strain * now.strain * now.free : 0.0;
}

void ElasticRope::describe(Description& d) const {
  d.timeless = true;
  for (const PlacedLink& l : links_) d.link(l);
  const auto number = [&](const char* name, Unit unit, const char* text, auto value) {
    d.signal(name, unit, text, [this, value](const SignalView& v) {
      return value(taut(*v.kinematics, way(*v.kinematics)));
    });
  };
  number("force", Unit::force, "S, equal along the rope",
         [](const Taut& s) { return s.spring + s.damper; });
  number("length", Unit::length, "l0, free and without strain",
         [](const Taut& s) { return s.free; });
  number("elongation", Unit::length, "l - l0; negative: slack",
         [](const Taut& s) { return s.length - s.free; });
}

}  // namespace dynamy
