/// Shape: geometry with a material, bound to a frame. It is drawn by the replay and, if it has a
/// material, takes part in contact.
#pragma once
#include <array>
#include <cstdint>
#include <dynamy/core/declared/element.hpp>
#include <dynamy/core/types.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// What contact and replay take a shape for.
enum class ShapeType : std::uint8_t {
  point,       ///< size[0]: radius of its dot [m], may be 0
  sphere,      ///< size[0]: radius
  circle,      ///< size[0]: radius, about z
  line,        ///< points
  polygon,     ///< points
  contour,     ///< points on a closed curve about z
  box,         ///< size[0…2]: edge lengths; points: its eight corners
  cylinder,    ///< size[0]: radius, size[1]: length along z
  capsule,     ///< as a cylinder
  cone,        ///< size[0]: radius of its base at z = 0, size[1]: height of its tip
  torus,       ///< size[0]: radius of its circle about z, size[1]: of the tube
  ellipsoid,   ///< size[0…2]: semi-axes
  polyhedron,  ///< points: triangles, three points each, counterclockwise from outside
  mesh,        ///< the same, open: ground with one side
  halfSpace,   ///< points[0]: outward unit normal; the origin lies in the plane
  bore         ///< the wall of a hole about z. size[0]: radius, size[1]: length along z, 0: any
};

/// Geometry of a shape for contact and replay. A shape of a user may give one of these types, and
/// is then treated as this type.
struct ShapeGeometry {
  ShapeType type = ShapeType::point;
  std::array<double, 4> size{};  ///< [m], by type: Sphere radius; Box edge lengths x y z; …
  std::vector<Vec3> points;      ///< corners, vertices or curve points in shape axes [m]
  std::string colour;            ///< CSS colour or empty
};

/// Volume, centre and inertia for unit density.
struct MassProperties {
  double volume = 0.0;            ///< [m³]; 0: the shape cannot carry mass
  Vec3 centre_B = Vec3::Zero();   ///< [m], in shape axes
  Mat3 inertia_B = Mat3::Zero();  ///< [m⁵], about the centre
};

/// Declares `position`, and `orientation` or `euler`, of a shape, frame or body.
void declarePose(Attributes& a, const std::string& of);
/// Unit quaternion (w, x, y, z) from `orientation`, or from `euler`: rotations about the fixed axes
/// x, y and z, A = Rz(γ) Ry(β) Rx(α). Throws ModelError if both are given or the quaternion
/// vanishes.
std::array<double, 4> orientation(const Parameters& x);

class SmoothShape;
struct ShapeFamily;

/// Contact of a shape that brings its own pairs (shape_pair.hpp).
struct OwnContact {
  const ShapeFamily* family = nullptr;  ///< null: contacts follow from geometry()
  double bound = 0.0;                   ///< radius of a ball about the origin that holds it [m]
  double thickness = 0.0;  ///< half of its least width [m]; infinite: nothing passes through it
};

class Shape : public Element {
 public:
  static constexpr Kind kKind = Kind::shape;
  explicit Shape(const Parameters& x);
  /// Declares the attributes of all shapes: material, grain, position, orientation, colour, mass
  /// and density.
  static void declareCommon(Attributes& a);

  virtual ShapeGeometry geometry() const = 0;
  virtual MassProperties massProperties() const { return {}; }
  /// This shape, if it is a SmoothShape (smooth_shape.hpp); else null.
  virtual const SmoothShape* smooth() const { return nullptr; }
  /// By its geometry. Pictures are; so are convex bodies whose section has contacts in the plane.
  bool isMirrored(const MirrorPlane& plane_B) const override;
  /// Family and size of a shape whose contacts its plug-in computes.
  virtual OwnContact ownContact() const { return {}; }

  const std::string& material() const { return material_; }  ///< empty: drawn only, no contact
  const Vec3& r_SB_K() const { return r_SB_K_; }  ///< place of the shape in its frame [m]
  const Mat3& A_KB() const { return A_KB_; }
  double mass() const { return mass_; }        ///< [kg], 0: not given
  double density() const { return density_; }  ///< [kg/m³], 0: not given
  const std::string& colour() const { return colour_; }
  /// Unit vector in shape axes along which friction differs, zero: none.
  const Vec3& grain_B() const { return grain_B_; }

 private:
  std::string material_, colour_;
  Vec3 r_SB_K_ = Vec3::Zero();
  Mat3 A_KB_ = Mat3::Identity();
  double mass_ = 0.0, density_ = 0.0;
  Vec3 grain_B_ = Vec3::Zero();
};

/// Radius of a ball about the origin of the shape that holds it [m]; infinite: none does.
double boundOf(const ShapeGeometry& geometry);
/// The same of a shape of any kind.
double boundOf(const Shape& shape);

}  // namespace dynamy
