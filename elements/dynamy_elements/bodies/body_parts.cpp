#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>

namespace dynamy {

// ---- NamedFrame --------------------------------------------------------------------------------

void NamedFrame::declare(Attributes& a) {
  a.about("A point with axes on a body; joints and forces refer to it as body.name.");
  declarePose(a, "frame in the body");
  a.example("<Frame name=\"tip\" position=\"0 0 -1\"/>");
}

NamedFrame::NamedFrame(const Parameters& x)
    : Element(x), r_BF_K_(x["position"].vec3()), A_KF_(rotationMatrix(orientation(x).data())) {}

// ---- BodyParts ---------------------------------------------------------------------------------

void BodyParts::declare(Attributes& a) {
  a.child(Kind::shape, 0, 1000, "shapes: picture, contact, mass");
  a.child(Kind::part, 0, 1000, "named frames", "Frame");
}

BodyParts::BodyParts(const Parameters& x)
    : shapes_(x.take<Shape>()), frames_(x.take<NamedFrame>()) {
  for (const auto& frame : frames_) {
    if (!frame->name().empty()) continue;
    throw ModelError(Diagnostic{.place = frame->place(),
                                .element = "Frame",
                                .text = "a frame needs a name",
                                .hint = "others refer to it as body.name"});
  }
}

void refuseMass(std::span<const std::unique_ptr<Shape>> shapes, const std::string& why) {
  for (const auto& shape : shapes) {
    if (!(shape->mass() > 0.0) && !(shape->density() > 0.0)) continue;
    throw ModelError(Diagnostic{.place = shape->place(),
                                .element = shape->type(),
                                .text = std::string(shape->mass() > 0.0 ? "mass" : "density") +
                                        " would have no effect: " + why,
                                .hint = "leave it out"});
  }
}

namespace {

/// Throws ModelError for a shape whose density gives no mass, since it has no volume.
void refuseFlat(std::span<const std::unique_ptr<Shape>> shapes) {
  for (const auto& shape : shapes)
    if (shape->density() > 0.0 && !(shape->massProperties().volume > 0.0))
      throw ModelError(Diagnostic{
          .place = shape->place(),
          .element = shape->type(),
          .text = "has no volume, so that its density gives no mass",
          .hint = "give it mass=\"…\" and the body an inertia, or take a shape with a volume (a "
                  "disc: a <Cylinder> whose axis, z, is turned along the normal of the plane)"});
}

/// Attitude of a frame with x forward, y left and z up: A = R_z(heading) R_y(pitch) R_x(lean).
struct Attitude {
  const char* name;
  std::string_view text;
  double (*value)(const Mat3& A, const Vec3& v);
};

/// Angle from the x-axis of the axes A to v, both seen from above; 0 at rest.
double courseAngle(const Mat3& A, const Vec3& v) {
  const double along = A(0, 0) * v[0] + A(1, 0) * v[1], left = A(0, 0) * v[1] - A(1, 0) * v[0];
  return std::atan2(left, along);
}

constexpr std::array<Attitude, 4> kAttitudes{
    {{"lean", "about its x-axis; positive: to the right, if x points forward and z up",
      [](const Mat3& A, const Vec3&) { return std::atan2(A(2, 1), A(2, 2)); }},
     {"pitch", "of its x-axis below the horizontal",
      [](const Mat3& A, const Vec3&) {
        return std::atan2(-A(2, 0), std::hypot(A(0, 0), A(1, 0)));
      }},
     {"heading", "of its x-axis, seen from above, from the x-axis of the world",
      [](const Mat3& A, const Vec3&) { return std::atan2(A(1, 0), A(0, 0)); }},
     {"sideslip", "from its x-axis to its velocity, seen from above; 0 at rest",
      [](const Mat3& A, const Vec3& v) { return courseAngle(A, v); }}}};

}  // namespace

void BodyParts::describe(Description& d, const std::string& moving, const Vec3& r_BS_K,
                         const std::function<BodyMotion(const SignalView&)>& motion) const {
  for (const auto& shape : shapes_) d.shape(*shape, 0);
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    d.frame(frames_[i]->name(), static_cast<int>(i) + 1);
    const Vec3 r_SF_K = frames_[i]->r_BF_K() - r_BS_K;
    for (const char axis : moving) {
      const int k = axis - 'x';
      d.signal(frames_[i]->name() + "." + axis, Unit::length, "position of the frame",
               [=](const SignalView& s) {
                 const BodyMotion m = motion(s);
                 return m.r_OS_I[k] + (m.A_IK * r_SF_K)[k];
               });
      d.signal(frames_[i]->name() + ".v" + axis, Unit::velocity, "velocity of the frame",
               [=](const SignalView& s) {
                 const BodyMotion m = motion(s);
                 return m.v_S_I[k] + m.Omega_I.cross(m.A_IK * r_SF_K)[k];
               });
    }
    if (moving != "xyz") continue;
    const Mat3 A_KF = frames_[i]->A_KF();
    for (const Attitude& a : kAttitudes)
      d.signal(frames_[i]->name() + "." + a.name, Unit::angle, std::string(a.text),
               [=, value = a.value](const SignalView& s) {
                 const BodyMotion m = motion(s);
                 return value(m.A_IK * A_KF, m.v_S_I + m.Omega_I.cross(m.A_IK * r_SF_K));
               });
  }
}

namespace {

/// r − s, with components set to zero that are within the rounding of r and s. Masses at one place,
/// or on a line along an axis, thus have no moment of inertia instead of a tiny one.
Vec3 offset(const Vec3& r, const Vec3& s) {
  Vec3 out = r - s;
  for (int k = 0; k < 3; ++k)
    if (std::abs(out[k]) <= 64.0 * kEpsilon * std::max(std::abs(r[k]), std::abs(s[k])))
      out[k] = 0.0;
  return out;
}

}  // namespace

bool BodyParts::areMirrored(const MirrorPlane& plane_K) const {
  return std::all_of(shapes_.begin(), shapes_.end(), [&](const auto& shape) {
    return shape->isMirrored(plane_K.in(shape->r_SB_K(), shape->A_KB()));
  });
}

BodyMass BodyParts::mass(double total) const {
  // Masses of the parts.
  std::vector<double> part(shapes_.size(), 0.0);
  double volume = 0.0;
  for (const auto& shape : shapes_) volume += shape->massProperties().volume;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const double V = shapes_[i]->massProperties().volume;
    if (total > 0.0)
      part[i] = volume > 0.0 ? total * V / volume : 0.0;
    else
      part[i] = shapes_[i]->mass() > 0.0 ? shapes_[i]->mass() : shapes_[i]->density() * V;
  }

  // Centre of mass.
  BodyMass out;
  out.J_S_K.setZero();
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Shape& s = *shapes_[i];
    out.m += part[i];
    out.r_BS_K += part[i] * (s.r_SB_K() + s.A_KB() * s.massProperties().centre_B);
  }
  if (!(out.m > 0.0)) return out;
  out.r_BS_K /= out.m;

  // Inertia about it: parallel axes.
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Shape& s = *shapes_[i];
    const MassProperties p = s.massProperties();
    const Vec3 d = offset(s.r_SB_K() + s.A_KB() * p.centre_B, out.r_BS_K);
    if (p.volume > 0.0)
      out.J_S_K += part[i] / p.volume * s.A_KB() * p.inertia_B * s.A_KB().transpose();
    out.J_S_K += part[i] * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
  }
  return out;
}

Attribute& BodyParts::declareMass(Attributes& a, AttributeType inertia, const std::string& about) {
  Attribute& mass =
      a.add(AttributeType::number, "mass", std::nullopt,
            "mass; default: of the shapes. Without inertia it is spread over their volumes");
  mass.unit = Unit::mass;
  mass.mayBeAbsent().positive();
  Attribute& out = a.add(inertia, "inertia", std::nullopt, about);
  out.unit = Unit::inertia;
  return out.mayBeAbsent();
}

BodyMass BodyParts::mass(const Parameters& x, Mat3 (*J)(const ParameterValue&)) const {
  const bool given = x.has("mass");
  const double total = given ? double(x["mass"]) : 0.0;
  if (given) refuseMass("the body has a mass of its own");
  if (x.has("inertia")) {
    if (!given)
      throw x["inertia"].fault("an inertia needs a mass beside it", "add mass=\"…\"", 0,
                               x["inertia"].text.size());
    return {.m = total, .J_S_K = J(x["inertia"])};
  }
  BodyMass out = mass(total);
  refuseFlat(shapes_);
  if (!(out.m > 0.0))
    throw ModelError(given ? "the body has a mass but no inertia" : "the body has no mass",
                     given ? "add inertia=\"…\", or a shape with a volume"
                           : "add mass and inertia, or give its shapes a mass or density");
  return out;
}

// ---- kinematics --------------------------------------------------------------------------------

void shiftFrame(Frame& f, const Vec3& rho_I, const Mat3& A_KF) {
  f.r_OS_I += rho_I;
  f.v_S_I += f.Omega_I.cross(rho_I);
  f.nu_S_I += f.nu_R_I.cross(rho_I);
  f.bias_S_I += f.bias_R_I.cross(rho_I) + f.Omega_I.cross(f.Omega_I.cross(rho_I));
  for (Eigen::Index j = 0; j < f.J_S_I.cols(); ++j) f.J_S_I.col(j) += f.J_R_I.col(j).cross(rho_I);
  f.A_IK = f.A_IK * A_KF;
}

// ---- plane -------------------------------------------------------------------------------------

Plane::Plane(const std::string& word) {
  first = word[0], second = word[1];
  a = first - 'x', b = second - 'x';
  e1 = Vec3::Unit(a), e2 = Vec3::Unit(b);
  n = e1.cross(e2);
}

void placeInPlane(const Plane& plane, ConstVec q, ConstVec u, double across, const Mat3& A,
                  Frame& out) {
  out.block = 0;
  out.r_OS_I[plane.a] = q[0], out.r_OS_I[plane.b] = q[1], out.r_OS_I[plane.rest()] = across;
  out.A_IK = A;
  out.v_S_I = u[0] * plane.e1 + u[1] * plane.e2;
  out.Omega_I = u[2] * plane.n;
  out.nu_S_I.setZero(), out.nu_R_I.setZero();
  out.bias_S_I.setZero(), out.bias_R_I.setZero();
  out.J_S_I.setZero(), out.J_R_I.setZero();
  out.J_S_I.col(0) = plane.e1, out.J_S_I.col(1) = plane.e2;
  out.J_R_I.col(2) = plane.n;
}

void turningArm(const Plane& plane, const Vec3& rho_I, const Vec3& F_I, Block K) {
  K.setZero();
  K(2, 2) = (plane.n.dot(rho_I) * plane.n - rho_I).dot(F_I);
}

void expectInPlane(const ParameterValue& value, const Plane& plane) {
  const double out = value.numbers[static_cast<std::size_t>(plane.rest())];
  if (out == 0.0) return;
  const std::string word{plane.first, plane.second};
  throw value.fault("the motion stays in the plane " + word,
                    "the component out of this plane must be 0", 0, value.text.size());
}

}  // namespace dynamy
