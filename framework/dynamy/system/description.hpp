/// Description: what an element tells about itself once, in build(): names of coordinates, signals,
/// frames, shapes, memory.
#pragma once
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/core/types.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

class Shape;
class ContactSet;
class Kinematics;

/// What a signal function sees: the state at the sample time and the contacts of the step that
/// contains it.
struct SignalView {
  double t = 0.0;
  ConstVec q{nullptr, 0},
      u{nullptr, 0};  ///< slices of the element's own system; empty for other elements
  const Kinematics* kinematics = nullptr;  ///< frames of the last evaluation
  /// Contacts with percussions and relative velocities, rows in their order. A scheme of fixed
  /// steps knows those of the last step and at its end; one that locates switches those at t, and
  /// Lambda is the force there times dt.
  const ContactSet* contacts = nullptr;
  ConstVec Lambda{nullptr, 0};  ///< [N s]
  ConstVec gammaE{nullptr, 0};  ///< [m/s]
  /// The last step itself, impacts at its end included; null: as above.
  const ContactSet* stepContacts = nullptr;
  ConstVec stepLambda{nullptr, 0};  ///< percussions [N s]
  ConstVec memory{nullptr, 0};      ///< the element's own memory
  double dt = 0.0;                  ///< length of the last step [s]
  int element = -1;                 ///< index of the element among the contact elements
};
using SignalFunction = std::function<double(const SignalView&)>;

struct Signal {
  std::string name;  ///< without the element's name in front
  Unit unit = Unit::none;
  std::string_view text;  ///< lives as long as the program
  SignalFunction value;
};

struct PlacedShape {
  const Shape* shape = nullptr;
  int frame = 0;  ///< frame id within the system
};

/// Something drawn from a point of one frame to one of another: spring, rope, rod.
struct PlacedLink {
  int frameA = 0, frameB = 0;  ///< FrameHandle::index
  Vec3 pointA, pointB;         ///< in axes of the frames [m]
  bool spring = false;         ///< drawn as a coil
};

/// A body of a system that consists of several; found under its own name like a system.
struct NamedBody {
  std::string name;
  int frame = 0;   ///< the first of its frames
  int frames = 1;  ///< how many
  Place place;     ///< in the model file
};

class Description {
 public:
  /// q[i] of the element's own system as signal `name`.
  void coordinate(std::string name, Unit unit, int i, std::string text = {});
  /// u[i] of the element's own system as signal `name`.
  void velocity(std::string name, Unit unit, int i, std::string text = {});
  void signal(std::string name, Unit unit, std::string text, SignalFunction value);
  void shape(const Shape& shape, int frame) { shapes.push_back({&shape, frame}); }
  /// For elements between frames: what the replay draws of them.
  void link(const PlacedLink& l) { links.push_back(l); }
  void frame(std::string name, int id) { frames.push_back({std::move(name), id}); }

  /// The frames from `frame` on belong to a body of its own; in ascending order.
  void body(NamedBody b) { bodies.push_back(std::move(b)); }

  std::vector<Signal> signals;
  std::vector<NamedBody> bodies;
  /// Names of q[i] and u[i] as given above: elements with formulas find the coordinates by them.
  std::vector<std::pair<std::string, int>> coordinates, velocities;
  std::vector<PlacedShape> shapes;
  std::vector<PlacedLink> links;
  std::vector<std::pair<std::string, int>> frames;
};

}  // namespace dynamy
