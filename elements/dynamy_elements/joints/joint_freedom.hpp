/// JointFreedom: which coordinates between two bodies their joints leave free, from the motions that
/// these leave free at the start (theory 40.3).
///
///   turn about a through P     an angle about d changes if d ∥ a; a displacement of Q along d if Q lies
///                              beside the axis and d does not point along it
///   slide along s              a displacement along d changes if d·s ≠ 0; no angle does
///   turns about several axes   every angle changes; every displacement of Q ≠ P
///
/// Rejected: the rows of the joints at the start. They tell the rates of one instant: a Universal turns
/// about a third axis later, which it does not at its start.
#pragma once
#include <dynamy/core/types.hpp>
#include <dynamy/system/joint_list.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// A coordinate between two bodies: an angle about an axis, or a displacement of the point at_I along
/// it. The axis is zero if it is not known.
struct SoughtCoordinate {
  bool angle = true;
  Vec3 axis_I = Vec3::Zero(), at_I = Vec3::Zero();
  const char* axisName = "axis";  ///< attribute of the axis, for messages
  bool hasKind = true;            ///< an attribute `coordinate` says which of both it is
};

class JointFreedom {
 public:
  explicit JointFreedom(std::vector<const KnownJoint*> joints) : joints_(std::move(joints)) {}
  /// The kind of coordinate that is meant where the model names none: a displacement if a joint
  /// leaves no turn, or none about the axis but a slide along it.
  bool suggestsAngle(const Vec3& axis_I) const;
  /// Throws ModelError at `place` if a joint locks the coordinate.
  void requireFree(const SoughtCoordinate& x, const Place& place) const;

 private:
  std::vector<const KnownJoint*> joints_;
};

}  // namespace dynamy
