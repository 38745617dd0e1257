/// Parts of bodies: shapes, named frames, and the mass that follows from the shapes.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/frame.hpp>
#include <dynamy/system/shape.hpp>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace dynamy {

/// `<Frame name= position= orientation=/>` in a body: a point with axes that others can refer to as
/// `body.name`.
class NamedFrame final : public Element {
 public:
  static constexpr Kind kKind = Kind::part;
  static void declare(Attributes& a);
  explicit NamedFrame(const Parameters& x);
  const Vec3& r_BF_K() const { return r_BF_K_; }
  const Mat3& A_KF() const { return A_KF_; }

 private:
  Vec3 r_BF_K_;
  Mat3 A_KF_;
};

/// Mass, centre of mass in body axes from the body's origin, inertia about the centre of mass.
struct BodyMass {
  double m = 0.0;                 ///< [kg]
  Vec3 r_BS_K = Vec3::Zero();     ///< [m]
  Mat3 J_S_K = Mat3::Identity();  ///< [kg m²]
};

/// Throws ModelError at the first of `shapes` with a mass or density, which would have no effect.
void refuseMass(std::span<const std::unique_ptr<Shape>> shapes, const std::string& why);

/// Motion of a body's centre of mass S and of its axes K.
struct BodyMotion {
  Vec3 r_OS_I, v_S_I, Omega_I;  ///< [m], [m/s], [rad/s]
  Mat3 A_IK;
};

/// Shapes and frames of one body; frame 0 is the body's origin B with its axes K.
class BodyParts {
 public:
  static void declare(Attributes& a);
  explicit BodyParts(const Parameters& x);

  /// Names the frames and places the shapes on frame 0. Position and velocity of each frame are
  /// signals, frame.x … frame.vz, along the axes `moving` ("xyz" or two of them). `motion`: of the
  /// body, from its q and u.
  void describe(Description& d, const std::string& moving, const Vec3& r_BS_K,
                const std::function<BodyMotion(const SignalView&)>& motion) const;
  /// The same of a body that does not move: without signals.
  void describe(Description& d) const { describe(d, "", Vec3::Zero(), {}); }
  int frames() const { return 1 + static_cast<int>(frames_.size()); }
  /// Origin of frame `id` from B, and its axes, both in axes K.
  Vec3 position(int id) const { return id == 0 ? Vec3(Vec3::Zero()) : at(id).r_BF_K(); }
  Mat3 axes(int id) const { return id == 0 ? Mat3(Mat3::Identity()) : at(id).A_KF(); }

  /// True: all shapes are their own mirror image. `plane_K`: in axes of the body.
  bool areMirrored(const MirrorPlane& plane_K) const;

  /// Throws ModelError if a shape has a mass of its own, which would be ignored. `why`: names what
  /// has the mass instead.
  void refuseMass(const std::string& why) const { dynamy::refuseMass(shapes_, why); }

  /// Mass from the shapes: each contributes its `mass` or `density`; a mass `total` > 0 is spread
  /// over the shapes' volumes instead. m = 0: the shapes have neither.
  BodyMass mass(double total) const;

  /// Declares `mass` and `inertia`, which may both be absent and then follow from the shapes;
  /// returns the inertia.
  static Attribute& declareMass(Attributes& a, AttributeType inertia, const std::string& about);
  /// The mass properties that declareMass() declared, as given or from the shapes.
  /// `J` makes a matrix of the inertia's value. Throws ModelError if there is no
  /// mass, or an inertia without a mass.
  BodyMass mass(const Parameters& x, Mat3 (*J)(const ParameterValue&)) const;

 private:
  const NamedFrame& at(int id) const { return *frames_[static_cast<std::size_t>(id - 1)]; }
  std::vector<std::unique_ptr<Shape>> shapes_;
  std::vector<std::unique_ptr<NamedFrame>> frames_;
};

/// Moves a frame, whose Jacobians, velocities and axes are those at B, to the lever arm rho_I with
/// the axes A_KF; both are fixed to the body:
/// v ← v + Ω × ρ,   J_S ← J_S − ρ~ J_R,   β_S ← β_S + β_R × ρ + Ω × (Ω × ρ).
void shiftFrame(Frame& f, const Vec3& rho_I, const Mat3& A_KF);

/// The plane of a planar element: word "xy", "xz" or "yz".
struct Plane {
  int a = 0, b = 2;  ///< coordinates that move
  Vec3 e1 = Vec3::UnitX(), e2 = Vec3::UnitZ();
  Vec3 n = -Vec3::UnitY();  ///< e1 × e2: positive angles turn e1 towards e2
  char first = 'x', second = 'z';
  explicit Plane(const std::string& word = "xz");
  /// Index of the coordinate that does not move.
  int rest() const { return 3 - a - b; }
};

/// Frame at S of a body with q = (c1, c2, φ), u = (v1, v2, ω) in the plane. `across`: place of S along
/// the coordinate that does not move [m]; `A`: axes of the body.
void placeInPlane(const Plane& plane, ConstVec q, ConstVec u, double across, const Mat3& A,
                  Frame& out);
/// Stiffness of a force F_I at the lever arm rho_I from S, which turns with the body:
/// δ(n × ρ) = n × (n × ρ) δφ = (n n·ρ − ρ) δφ.
void turningArm(const Plane& plane, const Vec3& rho_I, const Vec3& F_I, Block K);

/// Throws ModelError unless the component of the attribute out of the plane is zero.
void expectInPlane(const ParameterValue& value, const Plane& plane);

}  // namespace dynamy
