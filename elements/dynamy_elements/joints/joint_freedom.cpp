#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/element.hpp>
#include <dynamy_elements/joints/joint_freedom.hpp>

namespace dynamy {
namespace {

using Free = FreeMotion::Kind;

/// Sine of the angle below which two axes are one, or are perpendicular: axes of models have four
/// digits, as those of a Universal.
constexpr double kSameAxis = 1e-3;

bool turns(const FreeMotion& m) { return m.kind == Free::turn || m.kind == Free::screw; }
bool slides(const FreeMotion& m) { return m.kind == Free::slide || m.kind == Free::screw; }

/// What a joint leaves free, sorted by kinds.
struct Freedom {
  std::vector<Vec3> turns, slides;  // unit axes; parallel ones once
  bool ball = false;                // turns about several axes

  explicit Freedom(const JointMotion& motion) {
    for (const FreeMotion& m : motion.free) {
      if (dynamy::turns(m)) insert(turns, m.axis_I);
      if (dynamy::slides(m)) insert(slides, m.axis_I);
      ball = ball || m.kind == Free::ball;
    }
    ball = ball || turns.size() > 1;
  }
  static void insert(std::vector<Vec3>& axes, const Vec3& axis) {
    const Vec3 a = axis.normalized();
    for (const Vec3& known : axes)
      if (known.cross(a).norm() < kSameAxis) return;
    axes.push_back(a);
  }
  bool slidesAlong(const Vec3& d) const {
    return std::any_of(slides.begin(), slides.end(),
                       [&](const Vec3& s) { return std::abs(s.dot(d)) > kSameAxis; });
  }
  bool turnsAbout(const Vec3& d) const {
    return ball || (turns.size() == 1 && turns.front().cross(d).norm() < kSameAxis);
  }
  /// An angle that changes with the joint's, and is another one.
  bool isOblique(const SoughtCoordinate& x) const {
    return x.angle && turns.size() == 1 &&
           std::abs(turns.front().dot(x.axis_I.normalized())) > kSameAxis;
  }
  bool shifts(const Vec3& d, const Vec3& r_PQ) const {
    if (slidesAlong(d)) return true;
    const bool beside = r_PQ.norm() > 1e-9 * (1.0 + r_PQ.norm());  // rounding of places in a file
    if (ball || turns.empty()) return ball && beside;
    const Vec3& a = turns.front();
    return a.cross(r_PQ).norm() > 1e-9 * (1.0 + r_PQ.norm()) && a.cross(d).norm() > kSameAxis;
  }
  bool leaves(const SoughtCoordinate& x, const Vec3& at_I) const {
    const Vec3 d = x.axis_I.normalized();
    return x.angle ? turnsAbout(d) : shifts(d, x.at_I - at_I);
  }
};

/// "0 1 0", with six digits.
std::string axisText(const Vec3& axis) {
  std::string out;
  for (int i = 0; i < 3; ++i)
    out += (i > 0 ? " " : "") + numberText(std::round(axis[i] * 1e6) / 1e6 + 0.0);
  return out;
}

/// What to write for a coordinate that the joint leaves free.
std::string remedy(const Freedom& free, const SoughtCoordinate& x) {
  if (!free.ball && free.turns.empty() && free.slides.empty())
    return "the joint leaves no motion between the two bodies: remove this element, or the joint";
  const Vec3 d = x.axis_I.normalized();
  const std::vector<Vec3>& axes = x.angle ? free.turns : free.slides;
  if (axes.size() == 1 && !x.hasKind)
    return std::string("write ") + x.axisName + "=\"" + axisText(axes.front()) +
           "\", as at the joint";
  if (!x.hasKind) return "let the joint leave it free";
  if (x.angle && free.slidesAlong(d)) return "write coordinate=\"displacement\"";
  if (!x.angle && free.turnsAbout(d)) return "write coordinate=\"angle\"";
  if (axes.size() == 1) return "write axis=\"" + axisText(axes.front()) + "\", as at the joint";
  if (free.slides.size() == 1 && free.turns.empty())
    return "write coordinate=\"displacement\" axis=\"" + axisText(free.slides.front()) + '"';
  if (free.turns.size() == 1 && free.slides.empty())
    return "write coordinate=\"angle\" axis=\"" + axisText(free.turns.front()) + '"';
  return "choose a coordinate that the joint leaves free";
}

}  // namespace

bool JointFreedom::suggestsAngle(const Vec3& axis_I) const {
  return std::none_of(joints_.begin(), joints_.end(), [&](const KnownJoint* known) {
    const Freedom free(known->motion);
    if (free.slides.empty() || free.ball) return false;
    if (free.turns.empty()) return true;
    const Vec3 d = axis_I.isZero(0.0) ? free.turns.front() : Vec3(axis_I.normalized());
    return !free.turnsAbout(d) && free.slidesAlong(d);
  });
}

void JointFreedom::requireFree(const SoughtCoordinate& x, const Place& place) const {
  for (const KnownJoint* known : joints_) {
    const Freedom free(known->motion);
    if (free.leaves(x, known->motion.at_I)) continue;
    const Element& joint = *known->joint;
    Diagnostic d;
    d.place = place;
    d.text = (x.angle ? "the angle about " : "the displacement along ") + axisText(x.axis_I) +
             (free.isOblique(x) ? " is not that of the joint <" : " is locked by the joint <") +
             joint.type() + (joint.name().empty() ? ">" : " name=\"" + joint.name() + "\">");
    d.hint = remedy(free, x);
    if (joint.place().line > 0) d.notes.push_back({.place = joint.place(), .text = "the joint"});
    throw ModelError(d);
  }
}

}  // namespace dynamy
