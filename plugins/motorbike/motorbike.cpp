#include "motorbike.hpp"

#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy/system/description.hpp>

#include "picture.hpp"

namespace dynamy::motorbike {
namespace {

const Part& part(const Geometry& data, int id) {
  switch (id) {
    case kRearWheelId:
      return data.rear;
    case kForkId:
      return data.fork;
    case kFrontWheelId:
      return data.front;
    default:
      return data.frame;
  }
}

/// Vector from the point of reference to the centre of mass, in axes of the body.
Vec3 centre(const Geometry& data, int id) {
  if (id == kFrameId) return data.frame.r_OS;
  return id == kForkId ? Vec3(data.fork.r_OS - data.steerFoot()) : Vec3(Vec3::Zero());
}

}  // namespace

void Moving::shift(const Vec3& rho_K) {
  const Vec3 rho = A * rho_K;
  r += rho;
  v += Omega.cross(rho);
  betaS += betaR.cross(rho) + Omega.cross(Omega.cross(rho));
  for (int j = 0; j < kMost; ++j) JS.col(j) += JR.col(j).cross(rho);
}

void Moving::slide(const Vec3& e_K, double s, double rate, int j) {
  shift(s * e_K);
  const Vec3 e = A * e_K;
  v += rate * e;
  betaS += 2.0 * rate * Omega.cross(e);
  JS.col(j) += e;
}

void Moving::turn(const Vec3& e_K, double phi, double rate, int j) {
  const Vec3 e = A * e_K;
  betaR += rate * Omega.cross(e);
  Omega += rate * e;
  JR.col(j) += e;
  A = A * Eigen::AngleAxisd(phi, e_K).toRotationMatrix();
}

void Motorbike::declare(Attributes& a) {
  a.about(
      "Motorbike or bicycle: frame with rider, fork, two wheels with tyres, in minimal "
      "coordinates. "
      "Velocities: of the frame in its own axes (vx vy vz Omega_x Omega_y Omega_z), rearRate, "
      "steer_dot, frontRate, and with suspension rearTravel_dot, frontTravel_dot. Frames: the "
      "frame, rearWheel, fork, frontWheel. Its tyres touch half spaces, boxes, polyhedra and "
      "meshes.");
  Geometry::declare(a);
  a.add(AttributeType::name, "material", "", "of the tyres; without one they touch nothing");
  a.vector("position", Unit::length, 3, "0 0 0", "place of the rear contact at the start");
  a.optional("speed", Unit::velocity, 0.0, "speed at the start; the wheels roll");
  a.optional("leanRate", Unit::angularVelocity, 0.0,
             "at the start, about the line of the contacts");
  a.choice("picture", {"motorbike", "bicycle"}, "motorbike", "how it is drawn");
  a.example("<Motorbike name=\"bike\" material=\"rubber\" speed=\"8\"/>");
}

Motorbike::Motorbike(const Parameters& x)
    : PartialMechanicalSystem(x),
      data_(x),
      r_OB_(x["position"].vec3()),
      speed_(x["speed"]),
      leanRate_(x["leanRate"]),
      picture_(
          std::make_unique<Picture>(data_, x["material"].text, x["picture"].text == "bicycle")) {}

Motorbike::~Motorbike() = default;

void Motorbike::initialState(Vec q, Vec u) const {
  q.setZero(), u.setZero();
  q.head<3>() = r_OB_;
  q[3] = 1.0;
  u[kSpeed] = speed_, u[kOmega] = leanRate_;
  u[kRear] = speed_ / data_.rear.radius, u[kFront] = speed_ / data_.front.radius;
}

std::array<Moving, 4> Motorbike::motion(ConstVec q, const double* u) const {
  std::array<Moving, 4> out;
  Moving& frame = out[kFrameId];
  const Vec3 v(u[0], u[1], u[2]), Omega(u[3], u[4], u[5]);
  frame.r = q.head<3>();
  frame.A = rotationMatrix(q.data() + 3);
  frame.v = frame.A * v, frame.Omega = frame.A * Omega;
  frame.betaS = frame.A * Omega.cross(v);  // v_B turns with the frame
  frame.JS.leftCols<3>() = frame.A;
  frame.JR.middleCols<3>(kOmega) = frame.A;
  const bool travels = data_.suspended;

  Moving& rear = out[kRearWheelId] = frame;
  rear.shift(data_.rear.r_OS);
  if (travels) rear.slide(Vec3::UnitZ(), q[kRearTravel + 1], u[kRearTravel], kRearTravel);
  rear.turn(Vec3::UnitY(), q[kRear + 1], u[kRear], kRear);

  Moving& fork = out[kForkId] = frame;
  fork.shift(data_.steerFoot());
  fork.turn(data_.steerAxis(), q[kSteer + 1], u[kSteer], kSteer);

  Moving& front = out[kFrontWheelId] = fork;
  front.shift(data_.front.r_OS - data_.steerFoot());
  if (travels) front.slide(data_.steerAxis(), q[kFrontTravel + 1], u[kFrontTravel], kFrontTravel);
  front.turn(Vec3::UnitY(), q[kFront + 1], u[kFront], kFront);
  return out;
}

void Motorbike::M(double, ConstVec q, MassBlocks M) const {
  const double rest[kMost] = {};
  std::array<Moving, 4> bodies = motion(q, rest);
  Block out = M[0];
  out.setZero();
  for (int id = 0; id < 4; ++id) {
    Moving& b = bodies[static_cast<std::size_t>(id)];
    b.shift(centre(data_, id));
    const Mat3 J = b.A * part(data_, id).J_S * b.A.transpose();
    const auto JS = b.JS.leftCols(nu()), JR = b.JR.leftCols(nu());
    out += part(data_, id).m * JS.transpose() * JS + JR.transpose() * J * JR;
  }
}

void Motorbike::h(double t, ConstVec q, ConstVec u, Vec h) const {
  nonPotentialForce(t, q, u, h);
  std::array<Moving, 4> bodies = motion(q, u.data());
  for (int id = 0; id < 4; ++id) {
    Moving& b = bodies[static_cast<std::size_t>(id)];
    b.shift(centre(data_, id));
    const Mat3 J = b.A * part(data_, id).J_S * b.A.transpose();
    const Vec3 moment = J * b.betaR + b.Omega.cross(J * b.Omega);
    h -= b.JS.leftCols(nu()).transpose() * (part(data_, id).m * b.betaS) +
         b.JR.leftCols(nu()).transpose() * moment;
  }
  if (!data_.suspended) return;
  h[kRearTravel] -= data_.rearSuspension.k * q[kRearTravel + 1] + data_.rearSuspension.preload;
  h[kFrontTravel] -= data_.frontSuspension.k * q[kFrontTravel + 1] + data_.frontSuspension.preload;
}

void Motorbike::nonPotentialForce(double, ConstVec, ConstVec u, Vec h) const {
  h.setZero();
  h[kSteer] = -data_.steerDamping * u[kSteer];
  if (!data_.suspended) return;
  h[kRearTravel] = -data_.rearSuspension.d * u[kRearTravel];
  h[kFrontTravel] = -data_.frontSuspension.d * u[kFrontTravel];
}

double Motorbike::potentialEnergy(double, ConstVec q) const {
  if (!data_.suspended) return 0.0;
  const auto V = [](const Suspension& x, double s) { return (0.5 * x.k * s + x.preload) * s; };
  return V(data_.rearSuspension, q[kRearTravel + 1]) +
         V(data_.frontSuspension, q[kFrontTravel + 1]);
}

Vec3 Motorbike::centreOfMass(ConstVec q) const {
  const double rest[kMost] = {};
  std::array<Moving, 4> bodies = motion(q, rest);
  Vec3 sum = Vec3::Zero();
  double m = 0.0;
  for (int id = 0; id < 4; ++id) {
    Moving& b = bodies[static_cast<std::size_t>(id)];
    b.shift(centre(data_, id));
    sum += part(data_, id).m * b.r, m += part(data_, id).m;
  }
  return sum / m;
}

double Motorbike::gravity(double, ConstVec q, const Vec3& g_I, Vec h) const {
  const double rest[kMost] = {};
  std::array<Moving, 4> bodies = motion(q, rest);
  double V = 0.0;
  h.setZero();
  for (int id = 0; id < 4; ++id) {
    Moving& b = bodies[static_cast<std::size_t>(id)];
    b.shift(centre(data_, id));
    h += part(data_, id).m * b.JS.leftCols(nu()).transpose() * g_I;
    V -= part(data_, id).m * g_I.dot(b.r);
  }
  return V;
}

void Motorbike::qdot(double, ConstVec q, ConstVec u, Vec qdot) const {
  qdot.head<3>() = rotationMatrix(q.data() + 3) * u.head<3>();
  quaternionRate(q.data() + 3, u.segment<3>(kOmega), qdot.data() + 3);
  qdot.tail(nu() - 6) = u.tail(nu() - 6);
}

void Motorbike::move(double, Vec q, ConstVec u, double dt) const {
  // Screw motion with constant v_B and Ω: r ← r + Δt A (∫₀¹ exp(s θ~) ds) v.
  const Vec3 v = u.head<3>(), theta = dt * u.segment<3>(kOmega);
  q.head<3>() += dt * (rotationMatrix(q.data() + 3) * (rotationTangent(-theta) * v));
  rotate(q.data() + 3, theta);
  q.tail(nu() - 6) += dt * u.tail(nu() - 6);
}

void Motorbike::normalise(Vec q) const { q.segment<4>(3).normalize(); }

void Motorbike::frame(double, ConstVec q, ConstVec u, int id, Frame& out) const {
  const Moving b = motion(q, u.data())[static_cast<std::size_t>(id)];
  out.block = 0;
  out.r_OS_I = b.r, out.A_IK = b.A, out.v_S_I = b.v, out.Omega_I = b.Omega;
  out.bias_S_I = b.betaS, out.bias_R_I = b.betaR;
  out.J_S_I = b.JS.leftCols(nu()), out.J_R_I = b.JR.leftCols(nu());
}

void Motorbike::describe(Description& d) const {
  const char* const axis[3] = {"x", "y", "z"};
  const char* const quaternion[4] = {"qw", "qx", "qy", "qz"};
  for (int i = 0; i < 3; ++i)
    d.coordinate(axis[i], Unit::length, i, "of the frame at the rear contact");
  for (int i = 0; i < 4; ++i) d.coordinate(quaternion[i], Unit::none, 3 + i, "quaternion");
  const char* const joint[3] = {"rearAngle", "steer", "frontAngle"};
  const char* const rate[3] = {"rearRate", "steer_dot", "frontRate"};
  const char* const travel[2] = {"rearTravel", "frontTravel"};
  for (int i = 0; i < 3; ++i) {
    d.velocity(std::string("v") + axis[i], Unit::velocity, i,
               "of that point, in axes of the frame");
    d.coordinate(joint[i], Unit::angle, kRear + 1 + i);
  }
  for (int i = 0; i < 3; ++i)
    d.velocity(std::string("Omega_") + axis[i], Unit::angularVelocity, kOmega + i, "in its axes");
  for (int i = 0; i < 3; ++i) d.velocity(rate[i], Unit::angularVelocity, kRear + i);
  for (int i = 0; i < 2 && data_.suspended; ++i) {
    d.coordinate(travel[i], Unit::length, kRearTravel + 1 + i, "compression");
    d.velocity(std::string(travel[i]) + "_dot", Unit::velocity, kRearTravel + i);
  }
  const auto angle = [&d](const char* name, const char* text, double (*of)(const Mat3&)) {
    d.signal(name, Unit::angle, text,
             [of](const SignalView& s) { return of(rotationMatrix(s.q.data() + 3)); });
  };
  angle("lean", "to the right", [](const Mat3& A) { return std::asin(A(2, 1)); });
  angle("pitch", "nose down", [](const Mat3& A) { return -std::asin(A(2, 0)); });
  angle("heading", "to the left", [](const Mat3& A) { return std::atan2(A(1, 0), A(0, 0)); });
  for (int i = 0; i < 3; ++i)
    d.signal(std::string("S") + axis[i], Unit::length, "centre of mass of the whole",
             [this, i](const SignalView& s) { return centreOfMass(s.q)[i]; });
  d.frame("rearWheel", kRearWheelId), d.frame("fork", kForkId),
      d.frame("frontWheel", kFrontWheelId);
  picture_->describe(d);
}

}  // namespace dynamy::motorbike
