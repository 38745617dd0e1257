#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/joints/joint.hpp>

namespace dynamy {

double Joint::Pose::error(const JointRow& row) const {
  switch (row.kind) {
    case JointRow::Kind::point:
      return (A.A_IK * row.d_A).dot(r_PQ);
    case JointRow::Kind::angle:
      return (A.A_IK * row.d_A).dot(B.A_IK * row.b_B);
    case JointRow::Kind::distance:
      return r_PQ.norm() - row.length;
    case JointRow::Kind::spin:
      return 0.0;
  }
  return 0.0;
}

namespace {

constexpr int kMostRows = 8;

/// Acceleration at u̇ = 0 of the body point at rho_I.
Vec3 pointBias(const Frame& f, const Vec3& rho_I) {
  return f.bias_S_I + f.bias_R_I.cross(rho_I) + f.Omega_I.cross(f.Omega_I.cross(rho_I));
}

void addSpin(Block W, int row, const Frame& f, const Vec3& w, double sign) {
  for (int j = 0; j < f.nu(); ++j) W(row, j) += sign * f.J_R_I.col(j).dot(w);
}

}  // namespace

/// Line of action of the relative velocity in one row.
struct Joint::RowValues {
  bool spin = false;
  Vec3 w = Vec3::Zero();  ///< direction of the point rows, axis of the others
};

void Joint::Pose::line(const JointRow& row, RowValues& v) const {
  switch (row.kind) {
    case JointRow::Kind::point:
      v.w = A.A_IK * row.d_A;
      break;
    case JointRow::Kind::distance:
      v.w = r_PQ.normalized();
      break;
    case JointRow::Kind::angle:
      v.spin = true;
      v.w = (B.A_IK * row.b_B).cross(A.A_IK * row.d_A);
      break;
    case JointRow::Kind::spin:
      v.spin = true;
      v.w = A.A_IK * row.d_A;
      break;
  }
}

/// What γ̇ has beyond Wᵀu̇.
double Joint::Pose::bias(const JointRow& row, const RowValues& v) const {
  const Vec3 d = A.A_IK * row.d_A, b = B.A_IK * row.b_B, ddot = A.Omega_I.cross(d);
  if (v.spin) {
    const bool angle = row.kind == JointRow::Kind::angle;
    const Vec3 wdot = angle ? Vec3(B.Omega_I.cross(b).cross(d) + b.cross(ddot)) : ddot;
    return v.w.dot(B.bias_R_I - A.bias_R_I) + wdot.dot(B.Omega_I - A.Omega_I);
  }
  const Vec3 v_PQ = B.velocity(rhoB_I) - A.velocity(rhoA_I);
  const double ofPoints = v.w.dot(pointBias(B, rhoB_I) - pointBias(A, rhoA_I));
  if (row.kind == JointRow::Kind::distance) {
    const double along = v.w.dot(v_PQ);
    return ofPoints + (v_PQ.squaredNorm() - along * along) / r_PQ.norm();
  }
  return ofPoints + 2.0 * ddot.dot(v_PQ) + (A.bias_R_I.cross(d) + A.Omega_I.cross(ddot)).dot(r_PQ);
}

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

void Joint::declareFriction(Attributes& a) {
  a.child(Kind::law, 0, 1, "friction in the free direction, e.g. GivenFriction");
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
  frames_.connect(topology, *this);
  const StartKinematics start(topology);
  const Frame &A = start.frame(frames_.A), &B = start.frame(frames_.B);
  Start s;
  s.at_I = atGiven_ ? at_ : B.r_OS_I;
  s.plane = frames_.planeNormal;
  s.axis_I = axis_.norm() > 0.0 ? Vec3(axis_.normalized()) : Vec3(Vec3::Zero());
  s.A_IA = A.A_IK, s.A_IB = B.A_IK;
  pointA_ = A.A_IK.transpose() * (s.at_I - A.r_OS_I);
  pointB_ = B.A_IK.transpose() * (s.at_I - B.r_OS_I);
  points_.clear(), angles_.clear(), free_.clear();
  build(s);
  if (points_.empty() || points_[0].kind != JointRow::Kind::distance) return;
  if (points_[0].length > 0.0) return;
  points_[0].length = (B.r_OS_I + B.A_IK * pointB_ - A.r_OS_I - A.A_IK * pointA_).norm();
  if (!(points_[0].length > 0.0))
    throw ModelError("the two points coincide at the start",
                     "a distance of 0 is a Spherical joint");
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

// ---- contacts ----------------------------------------------------------------------------------

void Joint::emit(const Pose& p, std::uint64_t id, const std::vector<JointRow>& rows,
                 const SetValuedForceLaw& law, ContactSink& sink) const {
  double error[kMostRows], square = 0.0;
  for (std::size_t r = 0; r < rows.size(); ++r)
    error[r] = p.error(rows[r]), square += error[r] * error[r];
  const double g = &law == &bilateral_ ? std::sqrt(square) : 0.0;  // friction has no error
  ContactRows out = sink.add(id, g, law, static_cast<int>(rows.size()));
  if (!out) return;
  for (std::size_t r = 0; r < rows.size(); ++r) out.position(static_cast<int>(r)) = error[r];
  const Frame &A = p.A, &B = p.B;
  const Vec3 rhoAQ_I = p.rhoA_I + p.r_PQ;  // A's point that is at Q now
  RowValues values[kMostRows];
  for (std::size_t i = 0; i < rows.size(); ++i) p.line(rows[i], values[i]);
  if (out.wantsBias())
    for (std::size_t i = 0; i < rows.size(); ++i)
      out.bias(static_cast<int>(i)) = p.bias(rows[i], values[i]);

  // Segments, χ and bias of both sides. A distance row may take A's own point as well: w is along
  // r_PQ, so that the lever arms P and Q give the same.
  const auto addSide = [&](const Frame& f, const Vec3& rho, double sign) {
    const auto n = static_cast<int>(rows.size());
    if (f.block >= 0) {
      const Block W = out.segment(f.block, f.u0, f.nu());
      for (int r = 0; r < n; ++r)
        values[r].spin ? addSpin(W, r, f, values[r].w, sign)
                       : addPointRow(W, r, f, rho, values[r].w, sign);
    }
    const Vec3 nu = f.nu_S_I + f.nu_R_I.cross(rho);
    for (int r = 0; r < n; ++r)
      out.chi(r) += sign * values[r].w.dot(values[r].spin ? f.nu_R_I : nu);
  };
  addSide(A, rhoAQ_I, -1.0);
  addSide(B, p.rhoB_I, 1.0);
  out.place(B.r_OS_I + p.rhoB_I, Vec3::Zero());
}

void Joint::contacts(const Kinematics& k, ContactSink& sink) const {
  const Pose p(k.frame(frames_.A), k.frame(frames_.B), pointA_, pointB_);
  if (!points_.empty()) emit(p, 0, points_, bilateral_, sink);
  if (!angles_.empty()) emit(p, 1, angles_, bilateral_, sink);
  if (!free_.empty()) emit(p, 2, free_, *friction_, sink);
}

std::vector<double> Joint::errors(const Kinematics& k) const {
  const Pose p(k.frame(frames_.A), k.frame(frames_.B), pointA_, pointB_);
  std::vector<double> out;
  for (const JointRow& row : points_) out.push_back(p.error(row));
  for (const JointRow& row : angles_) out.push_back(p.error(row));
  return out;
}

void Joint::describe(Description& d) const {
  if (!points_.empty() && points_.front().kind == JointRow::Kind::distance)
    d.link({frames_.A.index, frames_.B.index, pointA_, pointB_});
  if (!points_.empty()) describeContact(d, 0, static_cast<int>(points_.size()), bilateral_);
  if (!angles_.empty())
    describeContact(d, 1, static_cast<int>(angles_.size()), bilateral_, "angles.");
  if (!free_.empty())
    describeContact(d, 2, static_cast<int>(free_.size()), *friction_, "friction.");
}

}  // namespace dynamy
