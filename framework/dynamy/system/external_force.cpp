#include <dynamy/system/external_force.hpp>

namespace dynamy {

void ForceSink::force(const Frame& frame, const Vec3& rho_I, const Vec3& F_I) {
  if (frame.block < 0 || (some_ != nullptr && frame.outside)) return;
  const Vec3 M_I = rho_I.cross(F_I);
  for (int j = 0; j < frame.nu(); ++j)
    add(frame.u0 + j, frame.J_S_I.col(j).dot(F_I) + frame.J_R_I.col(j).dot(M_I));
}

void ForceSink::moment(const Frame& frame, const Vec3& M_I) {
  if (frame.block < 0 || (some_ != nullptr && frame.outside)) return;
  for (int j = 0; j < frame.nu(); ++j) add(frame.u0 + j, frame.J_R_I.col(j).dot(M_I));
}

void ForceSink::generalised(const SystemHandle& system, ConstVec force) {
  if (!feels(system.index)) return;
  const int u0 = first(system);
  for (int j = 0; j < system.nu; ++j) add(u0 + j, force[j]);
}

void ForceSink::generalised(const SystemHandle& system, int i, double force) {
  if (!feels(system.index)) return;
  add(first(system) + i, force);
}

}  // namespace dynamy
