/// JointList: the joints between the bodies of a model and the motions that they leave free. Found
/// before elements are connected, for elements that act in the coordinate of a joint beside them.
#pragma once
#include <dynamy/system/tree_part.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dynamy {

class Element;

struct KnownJoint {
  const Element* joint = nullptr;
  JointMotion motion;
};

class JointList {
 public:
  /// Adds a joint between two bodies, by their names.
  void add(const std::string& bodyA, const std::string& bodyB, KnownJoint joint);
  /// Those between two bodies, named in either order.
  std::vector<const KnownJoint*> between(const std::string& a, const std::string& b) const;

 private:
  std::multimap<std::pair<std::string, std::string>, KnownJoint> joints_;
};

}  // namespace dynamy
