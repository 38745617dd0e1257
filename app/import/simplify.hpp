/// Steps from the machine of a file to one that bodies and joints of a model can be: each link has
/// mass or stands still, and at most one joint.
#pragma once
#include "import/machine.hpp"

namespace dynamy::app {

/// Mass of a body that stands between the joints of a link, or of a link without mass, as a share
/// of the mass of the machine: it changes masses and inertias of the others by this share.
inline constexpr double kTinyShare = 1e-12;

/// Joins links without mass to links they are rigidly connected with, puts bodies of tiny mass
/// between several joints of a link, and chooses values of joints at the start inside their limits.
/// What it does is added to the notes.
void simplify(Machine& machine);

/// Poses of all links in the world at the start.
std::vector<Pose> startPoses(const Machine& machine);

/// Pose of the link in its parent with the joint at `value` instead of its reference.
Pose moved(const MachineJoint& joint, double value);

}  // namespace dynamy::app
