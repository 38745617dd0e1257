#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy_elements/joints/joint.hpp>

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

Joint::Joint(const Parameters& x)
    : NonSmoothElement(x), frames_(x), friction_(x.takeOne<SetValuedForceLaw>()) {
  const bool hasAt = x.declaration->find("at") != nullptr;
  atGiven_ = hasAt && x.has("at");
  if (atGiven_) at_ = x["at"].vec3();
  if (x.declaration->find("axis") != nullptr) axis_ = x["axis"].vec3();
}

// ---- connect -----------------------------------------------------------------------------------

void Joint::connect(Topology& topology) {
  // A joint that became a coordinate needs frames for friction and signals only.
  if (ofTree_ && free_.empty() && coordinates_.empty()) return;
  frames_.connect(topology, *this);
  const StartKinematics start(topology);
  const Frame &A = start.frame(frames_.A), &B = start.frame(frames_.B);
  Start& s = start_;
  s.at_I = atGiven_ ? at_ : B.r_OS_I;
  s.plane = frames_.planeNormal;
  s.axis_I = axis_.norm() > 0.0 ? Vec3(axis_.normalized()) : Vec3(Vec3::Zero());
  s.A_IA = A.A_IK, s.A_IB = B.A_IK;
  pointA_ = A.A_IK.transpose() * (s.at_I - A.r_OS_I);
  pointB_ = B.A_IK.transpose() * (s.at_I - B.r_OS_I);
  points_.clear(), angles_.clear(), free_.clear(), coupled_.clear(), coordinates_.clear();
  build(s);
  if (ofTree_) points_.clear(), angles_.clear(), coupled_.clear();
  if (points_.empty() || points_[0].kind != JointRow::Kind::distance) return;
  if (points_[0].length > 0.0) return;
  points_[0].length = (B.r_OS_I + B.A_IK * pointB_ - A.r_OS_I - A.A_IK * pointA_).norm();
  if (!(points_[0].length > 0.0))
    throw ModelError("the two points coincide at the start",
                     "a distance of 0 is a Spherical joint");
}

void Joint::becomeCoordinate() {
  ofTree_ = true;
  points_.clear(), angles_.clear(), coupled_.clear();
}

bool Joint::jointMotion(Topology& topology, JointMotion& out) {
  connect(topology);
  const auto systemOf = [&](FrameHandle f) {
    return topology.requestedFrames()[static_cast<std::size_t>(f.index)].first;
  };
  out.systemA = systemOf(frames_.A), out.systemB = systemOf(frames_.B);
  out.at_I = start_.at_I;
  out.free.clear();
  return freeMotions(start_, out.free);
}

void Joint::addPoint(const Start& s, const Vec3& direction_I) {
  points_.push_back({JointRow::Kind::point, s.A_IA.transpose() * direction_I, Vec3::Zero(), 0.0});
}

void Joint::addAngle(const Start& s, const Vec3& d_I, const Vec3& b_I) {
  angles_.push_back(
      {JointRow::Kind::angle, s.A_IA.transpose() * d_I, s.A_IB.transpose() * b_I, 0.0});
}

void Joint::freeDirection(const Start& s, JointRow::Kind kind, const Vec3& axis_I) {
  if (friction_) free_.push_back({kind, s.A_IA.transpose() * axis_I, Vec3::Zero(), 0.0});
}

void Joint::addDistance(double length) {
  points_.push_back({JointRow::Kind::distance, Vec3::Zero(), Vec3::Zero(), length});
}

void Joint::addScrew(const Start& s, const Vec3& axis_I, double h) {
  Vec3 e, unused;
  tangents(axis_I, e, unused);
  coupled_.push_back({JointRow::Kind::screw, s.A_IA.transpose() * axis_I, s.A_IB.transpose() * e, h,
                      s.A_IA.transpose() * e});
}

void Joint::measureShift(const Start& s, const Vec3& d_I, const std::string& name,
                         const std::string& rate) {
  coordinates_.push_back(
      {{JointRow::Kind::point, s.A_IA.transpose() * d_I, Vec3::Zero(), 0.0}, name, rate});
}

void Joint::measureTurn(const Start& s, const Vec3& d_I, const Vec3& e_I, const std::string& name,
                        const std::string& rate, bool inB) {
  const Mat3 &axes = inB ? s.A_IB : s.A_IA, &other = inB ? s.A_IA : s.A_IB;
  coordinates_.push_back({{JointRow::Kind::turn, axes.transpose() * d_I, other.transpose() * e_I,
                           0.0, axes.transpose() * e_I},
                          name,
                          rate,
                          inB});
}

void Joint::refusePlane(const std::string& hint) {
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
      const Block W = out.segment(f.block, f.u0, f.nu());
      for (int r = 0; r < n; ++r) addWrench(W, r, f, rho, wrench[r], sign);
    }
    for (int r = 0; r < n; ++r) out.chi(r) += sign * drivenRate(f, rho, wrench[r]);
  };
  addSide(p.A, p.rhoAQ_I(), -1.0);
  addSide(p.B, p.rhoB_I, 1.0);
  out.place(p.B.r_OS_I + p.rhoB_I, Vec3::Zero());
}

void Joint::contacts(const Kinematics& k, ContactSink& sink) const {
  if (points_.empty() && angles_.empty() && coupled_.empty() && free_.empty()) return;
  const JointPose p = pose(k);
  if (!points_.empty()) emit(p, 0, points_, bilateral_, sink);
  if (!angles_.empty()) emit(p, 1, angles_, bilateral_, sink);
  if (!coupled_.empty()) emit(p, 3, coupled_, bilateral_, sink);
  if (!free_.empty()) emit(p, 2, free_, *friction_, sink);
}

std::vector<double> Joint::errors(const Kinematics& k) const {
  if (ofTree_) return {};
  const JointPose p = pose(k);
  std::vector<double> out;
  for (const auto* rows : {&points_, &angles_, &coupled_})
    for (const JointRow& row : *rows) out.push_back(rowPosition(p, row));
  return out;
}

void Joint::describeCoordinate(const Coordinate& c, Description& d) const {
  const bool turn = c.row.kind == JointRow::Kind::turn;
  const auto seen = [this, inB = c.inB](const SignalView& v) {
    const JointPose p = pose(*v.kinematics);
    return inB ? JointPose(p.B, p.A, pointB_, pointA_) : p;
  };
  const double sign = c.inB ? -1.0 : 1.0;
  d.signal(c.name, turn ? Unit::angle : Unit::length,
           turn ? "angle of B against A, between -pi and pi" : "displacement of B against A",
           [=, row = c.row](const SignalView& v) { return sign * rowPosition(seen(v), row); });
  d.signal(c.rate, turn ? Unit::angularVelocity : Unit::velocity, "its rate",
           [=, row = c.row](const SignalView& v) {
             const JointPose p = seen(v);
             return sign * rowRate(p, rowWrench(p, row));
           });
}

void Joint::describe(Description& d) const {
  if (!points_.empty() && points_.front().kind == JointRow::Kind::distance)
    d.link({frames_.A.index, frames_.B.index, pointA_, pointB_});
  if (!points_.empty()) describeContact(d, 0, static_cast<int>(points_.size()), bilateral_);
  if (!angles_.empty())
    describeContact(d, 1, static_cast<int>(angles_.size()), bilateral_, "angles.");
  if (!free_.empty())
    describeContact(d, 2, static_cast<int>(free_.size()), *friction_, "friction.");
  if (!coupled_.empty())
    describeContact(d, 3, static_cast<int>(coupled_.size()), bilateral_, "screw.");
  for (const Coordinate& c : coordinates_) describeCoordinate(c, d);
}

}  // namespace dynamy
