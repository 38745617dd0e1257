/// Machine: what a file of another program describes, before it becomes a model. Readers of all
/// formats fill it, and the writer of the model reads it alone.
///
/// A link is carried by another link, or by the world, and moves relative to it by the joints that
/// it lists, one after the other. All numbers are in SI units. Where all joints have their value
/// `reference`, the link's frame has the pose `pose` in the frame of its parent.
#pragma once
#include <cmath>
#include <dynamy/core/error.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "import/pose.hpp"

namespace dynamy::app {

/// An index of links as an index of arrays.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Mass properties in axes of a link: J about the centre of mass.
struct Inertia {
  double mass = 0.0;           ///< [kg]
  Vec3 centre = Vec3::Zero();  ///< centre of mass from the link's origin [m]
  Mat3 J = Mat3::Zero();       ///< about the centre of mass [kg m²]
  bool none() const { return mass <= 0.0; }
  /// Both together, `other` given in axes of a frame with this pose.
  void add(const Inertia& other, const Pose& pose);
};

/// A shape on a link. A mesh is a picture and has no part in contact.
struct Skin {
  enum class Kind : std::uint8_t { box, sphere, capsule, cylinder, ellipsoid, plane, hull, mesh };
  Kind kind = Kind::sphere;
  /// box: edges; sphere: radius; capsule, cylinder: radius and length of the straight part;
  /// ellipsoid: half axes [m]
  Vec3 size = Vec3::Zero();
  /// hull: the corners of one convex body or of several, in axes of the shape [m]
  std::vector<std::vector<Vec3>> hulls;
  std::filesystem::path file;  ///< of a mesh, or of that of a hull, which is drawn; may be empty
  Vec3 scale = Vec3::Ones();   ///< of that mesh: metres of a unit of the file
  Pose pose;                   ///< in the link
  bool touches = true;         ///< takes part in contact; false: is drawn only
  bool hidden = false;         ///< is not drawn if others of its link are
  double mu = 1.0;             ///< coefficient of friction
  unsigned category = 1,
           collidesWith = 1;  ///< bits: A and B touch if (A.category & B.collidesWith)
                              ///< or the other way round is not zero
  std::string colour;         ///< "" by body
};

struct MachineJoint {
  enum class Kind : std::uint8_t { turn, slide, ball };
  std::string name;
  Kind kind = Kind::turn;
  Vec3 axis = Vec3::UnitX();           ///< unit, in axes of the link
  Vec3 at = Vec3::Zero();              ///< a point of the axis, in the link [m]
  std::optional<double> lower, upper;  ///< [rad or m]
  double reference = 0.0;              ///< value where the link has the pose of the file [rad or m]
  double start = 0.0;                  ///< value at the start of the model
  bool startGiven = false;             ///< by the file; else it is chosen
  double damping = 0.0;                ///< [N m s/rad or N s/m]
  double friction = 0.0;               ///< dry friction [N m or N]
  double inertia = 0.0;                ///< of a rotor, in the coordinate [kg m² or kg]
  double stiffness = 0.0;              ///< of a spring [N m/rad or N/m]
  double rest = 0.0;                   ///< value at which the spring is free of force
  Place place;
};

struct Link {
  std::string name;
  int parent = -1;                   ///< index of a link, lower than its own; −1: the world
  bool between = false;              ///< stands between two joints of one link of the file
  bool free = false;                 ///< moves freely in space; then it has no joints
  Pose pose;                         ///< in the parent
  std::vector<MachineJoint> joints;  ///< empty: rigidly connected with its parent, unless free
  Inertia inertia;
  std::vector<Skin> skins;
  std::vector<std::pair<std::string, Pose>> frames;  ///< points with axes that have names
  Place place;
  bool rigid() const { return joints.empty() && !free; }
};

/// A joint that closes a loop between two links of the tree.
struct LoopJoint {
  enum class Kind : std::uint8_t { turn, slide, ball, fixed };
  std::string name;
  Kind kind = Kind::ball;
  int A = -1, B = -1;         ///< links; −1: the world
  Vec3 at = Vec3::Zero();     ///< in B [m]
  Vec3 axis = Vec3::UnitZ();  ///< in axes of B
  Place place;
};

/// Rate of joint B = ratio times rate of joint A.
struct Coupling {
  std::string name, jointA, jointB;
  double ratio = 1.0;
  Place place;
};

/// A drive in a joint: with x' = gear · x, the force is gear · (gain · input + bias₀ + bias₁ x' +
/// bias₂ dx'/dt), input and the force before the gear within bounds.
struct Drive {
  std::string name, joint;
  double gear = 1.0, gain = 1.0;
  double bias[3] = {0.0, 0.0, 0.0};
  double lowInput = -HUGE_VAL, highInput = HUGE_VAL, lowForce = -HUGE_VAL, highForce = HUGE_VAL;
  double input = 0.0;  ///< at the start
  Place place;
};

/// Something of the file that the model has not, or has in another way.
struct ImportNote {
  Place place;
  std::string element, text;
};

struct Machine {
  std::string name;
  Vec3 gravity = Vec3(0.0, 0.0, -9.81);
  std::vector<Link> links;   ///< parents before children
  std::vector<Skin> ground;  ///< shapes of the world
  std::vector<LoopJoint> loops;
  std::vector<Coupling> couplings;
  std::vector<Drive> drives;
  std::vector<std::pair<int, int>> apart;  ///< links that never touch
  bool selfContact = true;                 ///< false: links of the machine never touch each other
  bool staticContact = false;              ///< a link touches what stands still and carries it
  bool parentContact = true;               ///< false: a link and its parent never touch
  std::vector<ImportNote> notes;
};

}  // namespace dynamy::app
