/// Description: what an element reports about itself once, in build(): names of coordinates,
/// signals, frames, shapes, memory.
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

/// Input of a signal function: the state at the sample time, and the contacts of the step that
/// contains this time.
struct SignalView {
  double t = 0.0;
  ConstVec q{nullptr, 0},
      u{nullptr, 0};  ///< slices of the element's own system; empty for other elements
  const Kinematics* kinematics = nullptr;  ///< frames of the last evaluation
  /// Contacts with percussions and relative velocities, rows in the order of the contacts. With
  /// fixed steps they are those of the last step, velocities at its end. With a scheme that locates
  /// switches they are those at t, and Lambda is the force at t times dt.
  const ContactSet* contacts = nullptr;
  ConstVec Lambda{nullptr, 0};  ///< [N s]
  ConstVec gammaE{nullptr, 0};  ///< [m/s]
  /// Contacts of the whole last step, impacts at its end included; null: those in `contacts`.
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
  /// Of a contact element: the value follows from t, q, u and memory alone, so that formulas may
  /// read it. Signals of other elements always do.
  bool ofState = false;
};

struct PlacedShape {
  const Shape* shape = nullptr;
  int frame = 0;  ///< frame id within the system
};

/// Something drawn between points of two frames: spring, rope, rod.
struct PlacedLink {
  int frameA = 0, frameB = 0;  ///< FrameHandle::index
  Vec3 pointA, pointB;         ///< in axes of the frames [m]
  bool spring = false;         ///< drawn as a coil
};

/// One body of a system with several bodies. Its frames are found by its name, like a system's.
struct NamedBody {
  std::string name;
  int frame = 0;   ///< first frame of the body
  int frames = 1;  ///< number of its frames
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
  /// For elements between frames: adds a link that the replay draws.
  void link(const PlacedLink& l) { links.push_back(l); }
  void frame(std::string name, int id) { frames.push_back({std::move(name), id}); }

  /// Adds a body: the frames from `b.frame` on belong to it. Bodies are added in ascending order.
  void body(NamedBody b) { bodies.push_back(std::move(b)); }

  /// True: what the element does follows from positions and velocities alone, not from time, memory
  /// or signals. Only bodies on which nothing but such elements acts may sleep (theory 58).
  bool timeless = false;
  std::vector<Signal> signals;
  std::vector<NamedBody> bodies;
  /// Names of q[i] and u[i], given to coordinate() and velocity(). Formulas of elements use them.
  std::vector<std::pair<std::string, int>> coordinates, velocities;
  std::vector<PlacedShape> shapes;
  std::vector<PlacedLink> links;
  std::vector<std::pair<std::string, int>> frames;
};

}  // namespace dynamy
