#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/carried_body.hpp>

namespace dynamy {

void CarriedBody::ownState(const RigidMotion& motion, Vec q, Vec u) const {
  q.head<3>() = motion.r_OS_I;
  quaternionProduct(motion.p.data(), p_.data(), q.data() + 3);
  u.head<3>() = motion.v_S_I;
  u.tail<3>() = rotationMatrix(q.data() + 3).transpose() * motion.Omega_I;
}

}  // namespace dynamy
