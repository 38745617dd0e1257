#include <Eigen/Eigenvalues>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/gyroscopic.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>

namespace dynamy {
namespace {

/// Principal moments, the least first. If there are products of inertia, a moment
/// below 64 ε of the largest is the rounding of zero and returned as zero: masses on
/// a slanted line have none about it.
Vec3 principalMoments(const Mat3& J) {
  Vec3 out = Eigen::SelfAdjointEigenSolver<Mat3>(J, Eigen::EigenvaluesOnly).eigenvalues();
  const bool products = J(1, 0) != 0.0 || J(2, 0) != 0.0 || J(2, 1) != 0.0;
  if (products && out[0] < 64.0 * kEpsilon * out[2]) out[0] = 0.0;
  return out;
}

bool isInertia(const Mat3& J) {
  const Vec3 principal = principalMoments(J);
  // The relative tolerance 1e-9 accepts thin plates whose numbers were rounded in the file.
  return principal[0] > 0.0 && principal[0] + principal[1] >= principal[2] * (1.0 - 1e-9);
}

Mat3 symmetric(double xx, double yy, double zz, double xy, double xz, double yz) {
  Mat3 J;
  J << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return J;
}

/// The six numbers in our order, if they are an inertia row after row: Jxx Jxy Jxz Jyy Jyz Jzz, as in
/// other formats; else `otherwise`.
std::string inOurOrder(const ParameterValue& value, const std::string& otherwise) {
  const std::vector<double>& v = value.numbers;
  const std::vector<std::string> word = value.words();
  if (v.size() != 6 || word.size() != 6 ||
      !isInertia(symmetric(v[0], v[3], v[5], v[1], v[2], v[4])))
    return otherwise;
  return "the order is Jxx Jyy Jzz Jxy Jxz Jyz: write \"" + word[0] + ' ' + word[3] + ' ' +
         word[5] + ' ' + word[1] + ' ' + word[2] + ' ' + word[4] + '"';
}

/// J from 3 or 6 numbers: Jxx Jyy Jzz [Jxy Jxz Jyz], the products as entries of the matrix.
Mat3 readInertia(const ParameterValue& value) {
  const std::vector<double>& v = value.numbers;
  if (v.size() != 3 && v.size() != 6)
    throw value.fault("3 or 6 numbers are needed: Jxx Jyy Jzz [Jxy Jxz Jyz]",
                      "here are " + std::to_string(v.size()), 0, value.text.size());
  Mat3 J = Vec3(v[0], v[1], v[2]).asDiagonal();
  if (v.size() == 6) J = symmetric(v[0], v[1], v[2], v[3], v[4], v[5]);
  if (isInertia(J)) return J;
  const bool positive = principalMoments(J)[0] > 0.0;
  throw value.fault(
      positive ? "no mass distribution has this inertia" : "the inertia is not positive",
      inOurOrder(value, positive ? "each principal moment is at most the sum of the other two"
                                 : "principal moments must be > 0"),
      0, value.text.size());
}

BodyMass readMass(const Parameters& x, const BodyParts& parts) {
  BodyMass out = parts.mass(x, readInertia);
  if (!(principalMoments(out.J_S_K)[0] > 0.0))
    throw ModelError("the body's shapes have mass but no inertia",
                     "add mass and inertia to the body, or use shapes with a volume");
  return out;
}

const char* const kRate[3] = {"Omega_x", "Omega_y", "Omega_z"};
const char* const kQuaternion[4] = {"qw", "qx", "qy", "qz"};

}  // namespace

void RigidBody::declare(Attributes& a) {
  a.about(
      "Free rigid body: m v' = f, J Ω' + Ω × J Ω = M. Signals: x y z and vx vy vz of the centre of "
      "mass S, qw qx qy qz, Omega_x Omega_y Omega_z in body axes, Omega_I_x Omega_I_y Omega_I_z in "
      "those of the world, kineticEnergy. Mass and inertia are given, or follow from the shapes' "
      "mass or density; then S is found, too.");
  declarePose(a, "body");
  a.vector("velocity", Unit::velocity, 3, "0 0 0", "velocity of the centre of mass at the start");
  a.vector("angularVelocity", Unit::angularVelocity, 3, "0 0 0",
           "angular velocity at the start, in body axes");
  BodyParts::declareMass(
      a, AttributeType::vector,
      "Jxx Jyy Jzz [Jxy Jxz Jyz] about S = position, in body axes; default: of the shapes")
      .size = 0;
  BodyParts::declare(a);
  a.example(
      "<RigidBody name=\"ball\" position=\"0 0 1\"><Sphere radius=\"0.1\" "
      "mass=\"1\"/></RigidBody>");
}

RigidBody::RigidBody(const Parameters& x)
    : PartialMechanicalSystem(x),
      parts_(x),
      mass_(readMass(x, parts_)),
      r_OB_I_(x["position"].vec3()),
      v_S_I_(x["velocity"].vec3()),
      Omega_K_(x["angularVelocity"].vec3()),
      p_(orientation(x)),
      carried_(mass_, p_) {}

void RigidBody::describe(Description& d) const {
  d.timeless = true;
  const char* const axis[3] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) d.coordinate(axis[i], Unit::length, i, "position of S");
  for (int i = 0; i < 4; ++i) d.coordinate(kQuaternion[i], Unit::none, 3 + i, "quaternion");
  for (int i = 0; i < 3; ++i)
    d.velocity(std::string("v") + axis[i], Unit::velocity, i, "velocity of S");
  for (int i = 0; i < 3; ++i)
    d.velocity(kRate[i], Unit::angularVelocity, 3 + i, "angular velocity in body axes");
  for (int i = 0; i < 3; ++i)
    d.signal(std::string("Omega_I_") + axis[i], Unit::angularVelocity,
             "angular velocity in axes of the world", [i](const SignalView& s) {
               return rotationMatrix(s.q.data() + 3).row(i).dot(s.u.tail<3>());
             });
  d.signal("kineticEnergy", Unit::energy, "½ m v² + ½ Ω·J Ω", [mass = mass_](const SignalView& s) {
    const Vec3 v = s.u.head<3>(), Omega = s.u.tail<3>();
    return 0.5 * mass.m * v.squaredNorm() + 0.5 * Omega.dot(mass.J_S_K * Omega);
  });
  parts_.describe(d, "xyz", mass_.r_BS_K, [](const SignalView& s) {
    const Mat3 A = rotationMatrix(s.q.data() + 3);
    return BodyMotion{s.q.head<3>(), s.u.head<3>(), A * s.u.tail<3>(), A};
  });
}

bool RigidBody::isMirrored(const MirrorPlane& plane) const {
  const Mat3 A = rotationMatrix(p_.data());
  const MirrorPlane own = plane.in(r_OB_I_, A);
  return own.contains(mass_.r_BS_K) && plane.isAlong(v_S_I_) && own.isNormal(Omega_K_) &&
         own.isNormal(mass_.J_S_K * own.n) && parts_.areMirrored(own);
}

void RigidBody::initialState(Vec q, Vec u) const {
  for (int i = 0; i < 4; ++i) q[3 + i] = p_[static_cast<std::size_t>(i)];
  q.head<3>() = r_OB_I_ + rotationMatrix(p_.data()) * mass_.r_BS_K;
  u.head<3>() = v_S_I_;
  u.tail<3>() = Omega_K_;
}

void RigidBody::M(double, ConstVec, MassBlocks M) const {
  Block block = M[0];
  block.setZero();
  block.diagonal().head<3>().setConstant(mass_.m);
  block.bottomRightCorner<3, 3>() = mass_.J_S_K;
}

void RigidBody::h(double, ConstVec, ConstVec u, Vec h) const {
  const Vec3 Omega = u.tail<3>();
  h.head<3>().setZero();
  h.tail<3>() = -Omega.cross(mass_.J_S_K * Omega);
}

void RigidBody::gyroscopicAtMean(double, ConstVec, ConstVec uA, double dt, Vec h) const {
  dynamy::gyroscopicAtMean(mass_.J_S_K, uA.tail<3>(), dt, h.data() + 3);
}

void RigidBody::qdot(double, ConstVec q, ConstVec u, Vec qdot) const {
  qdot.head<3>() = u.head<3>();
  quaternionRate(q.data() + 3, u.tail<3>(), qdot.data() + 3);
}

void RigidBody::move(double, Vec q, ConstVec u, double dt) const {
  q.head<3>() += dt * u.head<3>();
  rotate(q.data() + 3, dt * u.tail<3>());
}

bool RigidBody::dh(double, ConstVec, ConstVec u, int, Block K, Block D) const {
  const Vec3 Omega = u.tail<3>();
  K.setZero(), D.setZero();
  D.bottomRightCorner<3, 3>() = skew(mass_.J_S_K * Omega) - skew(Omega) * mass_.J_S_K;
  return true;
}

void RigidBody::moveTangent(ConstVec u, double dt, Block T) const {
  T.setIdentity();
  T.bottomRightCorner<3, 3>() = rotationTangent(dt * u.tail<3>());
}

void RigidBody::frameStiffness(double, ConstVec q, int id, const Vec3& F_I, const Vec3& M_I,
                               Block K) const {
  // J_Sᵀ F + J_Rᵀ M = (F, Aᵀ M + ρ_K × Aᵀ F),  δ(Aᵀ x) = (Aᵀ x) × δθ_K.
  const Mat3 A = rotationMatrix(q.data() + 3);
  const Vec3 rho_K = parts_.position(id) - mass_.r_BS_K;
  K.setZero();
  K.bottomRightCorner<3, 3>() = skew(A.transpose() * M_I) + skew(rho_K) * skew(A.transpose() * F_I);
}

void RigidBody::normalise(Vec q) const { q.tail<4>().normalize(); }

double RigidBody::gravity(double, ConstVec q, const Vec3& g_I, Vec h) const {
  h.head<3>() = mass_.m * g_I;
  h.tail<3>().setZero();
  return -mass_.m * g_I.dot(q.head<3>());
}

void RigidBody::frame(double, ConstVec q, ConstVec u, int id, Frame& out) const {
  out.block = 0;
  out.r_OS_I = q.head<3>();
  out.A_IK = rotationMatrix(q.data() + 3);
  out.v_S_I = u.head<3>();
  out.Omega_I = out.A_IK * u.tail<3>();
  out.nu_S_I.setZero(), out.nu_R_I.setZero();
  out.bias_S_I.setZero(), out.bias_R_I.setZero();  // d/dt (A Ω) at Ω̇ = 0: A (Ω × Ω) = 0
  out.J_S_I.setZero(), out.J_R_I.setZero();
  out.J_S_I.leftCols<3>().setIdentity();
  out.J_R_I.rightCols<3>() = out.A_IK;
  out.central = id == 0 && mass_.r_BS_K.isZero(0.0);
  if (out.central) return;
  const Vec3 rho_K = parts_.position(id) - mass_.r_BS_K;
  shiftFrame(out, out.A_IK * rho_K, parts_.axes(id));
}

}  // namespace dynamy
