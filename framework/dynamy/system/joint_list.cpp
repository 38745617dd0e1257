#include <algorithm>
#include <dynamy/system/joint_list.hpp>

namespace dynamy {

void JointList::add(const std::string& bodyA, const std::string& bodyB, KnownJoint joint) {
  joints_.emplace(std::minmax(bodyA, bodyB), std::move(joint));
}

std::vector<const KnownJoint*> JointList::between(const std::string& a,
                                                  const std::string& b) const {
  std::vector<const KnownJoint*> out;
  const auto [first, end] = joints_.equal_range(std::minmax(a, b));
  for (auto it = first; it != end; ++it) out.push_back(&it->second);
  return out;
}

}  // namespace dynamy
