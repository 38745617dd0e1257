/// Composition: the joints of a model, and what completions made of them.
#pragma once
#include <dynamy/system/joint_list.hpp>
#include <string>
#include <vector>

namespace dynamy {

struct Composition {
  JointList jointList;  ///< all joints that can say what they leave free; found by build()
  std::vector<std::string> notes;  ///< a line each, for `dynamy check`
  /// Joints that became coordinates, and joints that could have; sizes of the systems that are
  /// trees now: velocities, and rows of joints, before and after.
  int coordinates = 0, joints = 0;
  int velocitiesBefore = 0, velocitiesAfter = 0;
  int rowsSaved = 0;
  int flat = 0;       ///< bodies that are computed in a plane, with 3 velocities instead of 6
  std::string plane;  ///< "xy" "xz" "yz"

  /// Velocities given at the start that joints of trees do not allow. They are lost as by an impact
  /// of these joints.
  struct Start {
    double off = 0.0;            ///< largest change of a body's velocity [m/s, rad/s]
    long joints = 0;             ///< joints of bodies whose velocities change
    std::string joint;           ///< that of the body with the largest change, with its place
    double kineticBefore = 0.0;  ///< of the trees with the velocities given [J]
    double kineticAfter = 0.0;   ///< with those that they start with [J]
  } start;
};

}  // namespace dynamy
