#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy_elements/joints/joint.hpp>
#include <dynamy_elements/laws/friction_of_law.hpp>

namespace dynamy {

// ---- declaration -------------------------------------------------------------------------------

void Joint::declareJoint(Attributes& a) {
  FramePair::declare(a);
  Attribute& at = a.add(AttributeType::vector, "at", std::nullopt,
                        "place of the joint at the start, in the world; default: origin of B");
  at.unit = Unit::length;
  at.size = 3;
  at.mayBeAbsent();
}

void Joint::declareAxis(Attributes& a, const std::string& text) {
  a.vector("axis", Unit::none, 3, "0 0 0", text);
}

void Joint::declareFriction(Attributes& a, const std::string& text) {
  a.child(Kind::law, 0, 1, text);
}

void Joint::declareStart(Attributes& a, Unit unit, const std::string& text) {
  a.optional("start", unit, 0.0, text);
}

void Joint::declareRotor(Attributes& a, Unit unit) {
  a.optional(
       "rotor", unit, 0.0,
       "inertia that the rate of the joint alone moves (armature): that of a motor's rotor times "
       "the square of its gear's ratio; only with coordinates=\"minimal\"")
      .nonNegative();
}

Joint::Joint(const Parameters& x)
    : NonSmoothElement(x), frames_(x), friction_(x.takeOne<SetValuedForceLaw>()) {
  if (friction_) requireLawOfRates(*friction_);
  const bool hasAt = x.declaration->find("at") != nullptr;
  atGiven_ = hasAt && x.has("at");
  if (atGiven_) at_ = x["at"].vec3();
  if (x.declaration->find("axis") != nullptr) axis_ = x["axis"].vec3();
  if (x.declaration->find("start") != nullptr) start_ = x["start"];
  if (x.declaration->find("rotor") != nullptr) rotor_ = x["rotor"];
}

// ---- connect -----------------------------------------------------------------------------------

void Joint::connect(Topology& topology) {
  if (rotor_ > 0.0 && !ofTree_)
    throw ModelError(
        "its rotor needs the coordinate of the joint, which is no coordinate here",
        "say <simulation coordinates=\"minimal\">; a joint that closes a loop, or is at "
        "a body that moves as told, has no rotor");
  bind(topology);
}

void Joint::bind(Topology& topology) {
  // A joint that became a coordinate needs frames for friction and signals only.
  if (ofTree_ && rows_.free.empty() && rows_.signals.empty())
    return frames_.belong(topology, *this);
  frames_.connect(topology, *this);
  const StartKinematics start(topology, {frames_.A, frames_.B});
  const Frame &A = start.frame(frames_.A), &B = start.frame(frames_.B);
  JointStart s;
  s.at_I = atGiven_ ? at_ : B.r_OS_I;
  s.plane = frames_.planeNormal;
  s.axis_I = axis_.norm() > 0.0 ? Vec3(axis_.normalized()) : Vec3(Vec3::Zero());
  s.A_IA = A.A_IK, s.A_IB = B.A_IK;
  rows_.begin(s, friction_ != nullptr, A.A_IK.transpose() * (s.at_I - A.r_OS_I),
              B.A_IK.transpose() * (s.at_I - B.r_OS_I));
  build(rows_);
  if (ofTree_) rows_.dropBilateral();
  if (rows_.points.empty() || rows_.points[0].kind != JointRow::Kind::distance) return;
  double& length = rows_.points[0].length;
  if (length > 0.0) return;
  length = (B.r_OS_I + B.A_IK * rows_.pointB - A.r_OS_I - A.A_IK * rows_.pointA).norm();
  if (!(length > 0.0))
    throw ModelError("the two points coincide at the start",
                     "a distance of 0 is a Spherical joint");
}

void Joint::becomeCoordinate() {
  ofTree_ = true;
  rows_.dropBilateral();
}

bool Joint::jointMotion(Topology& topology, JointMotion& out) {
  bind(topology);
  const auto systemOf = [&](FrameHandle f) {
    return topology.requestedFrames()[static_cast<std::size_t>(f.index)].first;
  };
  out.systemA = systemOf(frames_.A), out.systemB = systemOf(frames_.B);
  out.at_I = rows_.start.at_I;
  out.free.clear();
  if (!freeMotions(rows_.start, out.free)) return false;
  if (rotor_ > 0.0) out.free.front().rotor = rotor_;
  return true;
}

bool Joint::keepsPlane(const MirrorPlane& plane) {
  JointMotion motion;
  return jointMotion(*plane.topology, motion) &&
         std::all_of(motion.free.begin(), motion.free.end(), [&](const FreeMotion& m) {
           switch (m.kind) {
             case FreeMotion::Kind::turn:
               return plane.isNormal(m.axis_I);
             case FreeMotion::Kind::slide:
               return plane.isAlong(m.axis_I);
             case FreeMotion::Kind::ball:
               return plane.contains(motion.at_I);
             default:
               return false;
           }
         });
}

void refusePlane(const std::string& hint) {
  throw ModelError("the bodies move in one plane: the joint is for bodies in space", hint);
}

// ---- contacts ----------------------------------------------------------------------------------

void Joint::emit(const JointPose& p, std::uint64_t id, const std::vector<JointRow>& rows,
                 const SetValuedForceLaw& law, ContactSink& sink) const {
  double error[kMostRows] = {}, square = 0.0;
  const bool holds = &law == &bilateral_;  // friction has no error
  for (std::size_t r = 0; holds && r < rows.size(); ++r)
    error[r] = rowPosition(p, rows[r]), square += error[r] * error[r];
  ContactRows out = sink.add(id, std::sqrt(square), law, static_cast<int>(rows.size()));
  if (!out) return;
  const auto n = static_cast<int>(rows.size());
  RowWrench wrench[kMostRows];
  for (int r = 0; r < n; ++r) {
    const JointRow& row = rows[static_cast<std::size_t>(r)];
    out.position(r) = error[r];
    wrench[r] = rowWrench(p, row);
    if (out.wantsBias()) out.bias(r) = rowBias(p, row);
  }
  // Segments and χ of both sides. A distance row may use A's own point P as well: its force is
  // along r_PQ, so that the lever arms of P and Q give the same.
  const auto addSide = [&](const Frame& f, const Vec3& rho, double sign) {
    if (f.block >= 0) {
      const Block W = out.segment(f);
      for (int r = 0; r < n; ++r) addWrench(W, r, f, rho, wrench[r], sign);
    }
    for (int r = 0; r < n; ++r) out.chi(r) += sign * drivenRate(f, rho, wrench[r]);
  };
  addSide(p.A, p.rhoAQ_I(), -1.0);
  addSide(p.B, p.rhoB_I, 1.0);
  out.place(p.B.r_OS_I + p.rhoB_I, Vec3::Zero());
}

void Joint::contacts(const Kinematics& k, ContactSink& sink) const {
  if (rows_.empty()) return;
  const JointPose p = pose(k);
  if (!rows_.points.empty()) emit(p, 0, rows_.points, bilateral_, sink);
  if (!rows_.angles.empty()) emit(p, 1, rows_.angles, bilateral_, sink);
  if (!rows_.coupled.empty()) emit(p, 3, rows_.coupled, bilateral_, sink);
  if (!rows_.free.empty()) emit(p, 2, rows_.free, *friction_, sink);
}

std::vector<double> Joint::errors(const Kinematics& k) const {
  if (ofTree_) return {};
  const JointPose p = pose(k);
  std::vector<double> out;
  for (const auto* rows : {&rows_.points, &rows_.angles, &rows_.coupled})
    for (const JointRow& row : *rows) out.push_back(rowPosition(p, row));
  return out;
}

void Joint::describeSignal(const JointSignal& c, Description& d) const {
  const bool turn = c.row.kind == JointRow::Kind::turn;
  const auto seen = [this, inB = c.inB](const SignalView& v) {
    const JointPose p = pose(*v.kinematics);
    return inB ? JointPose(p.B, p.A, rows_.pointB, rows_.pointA) : p;
  };
  const double sign = c.inB ? -1.0 : 1.0;
  d.signal(c.name, turn ? Unit::angle : Unit::length,
           turn ? "angle of B against A, between -pi and pi" : "displacement of B against A",
           [=, row = c.row, start = start_](const SignalView& v) {
             const double x = sign * rowPosition(seen(v), row);
             if (start == 0.0) return x;
             return turn ? std::remainder(start + x, kTwoPi) : start + x;
           });
  d.signals.back().ofState = true;
  d.signal(c.rate, turn ? Unit::angularVelocity : Unit::velocity, "its rate",
           [=, row = c.row](const SignalView& v) {
             const JointPose p = seen(v);
             return sign * rowRate(p, rowWrench(p, row));
           });
  d.signals.back().ofState = true;
}

namespace {

AngularRows angularRows(const std::vector<JointRow>& rows) {
  AngularRows out = 0;
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].kind == JointRow::Kind::angle || rows[r].kind == JointRow::Kind::spin ||
        rows[r].kind == JointRow::Kind::turn)
      out |= 1U << r;
  return out;
}

}  // namespace

void Joint::describe(Description& d) const {
  if (!rows_.points.empty() && rows_.points.front().kind == JointRow::Kind::distance)
    d.link({frames_.A.index, frames_.B.index, rows_.pointA, rows_.pointB});
  if (!rows_.points.empty())
    describeContact(d, 0, static_cast<int>(rows_.points.size()), bilateral_);
  if (!rows_.angles.empty())
    describeContact(d, 1, static_cast<int>(rows_.angles.size()), bilateral_, "angles.",
                    kAllAngular);
  if (!rows_.free.empty())
    describeContact(d, 2, static_cast<int>(rows_.free.size()), *friction_, "friction.",
                    angularRows(rows_.free));
  if (!rows_.coupled.empty())
    describeContact(d, 3, static_cast<int>(rows_.coupled.size()), bilateral_, "screw.");
  for (const JointSignal& c : rows_.signals) describeSignal(c, d);
}

}  // namespace dynamy
