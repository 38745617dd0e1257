#include <boost/container/small_vector.hpp>
#include <dynamy/system/stiffness_sink.hpp>

namespace dynamy {

void StiffnessSink::spring(const Frame& A, const Vec3& rhoA_I, const Frame& B, const Vec3& rhoB_I,
                           const Vec3& e, double c, double d) {
  add({A, -e, -rhoA_I.cross(e)}, {B, e, rhoB_I.cross(e)}, c, d);
}

void StiffnessSink::torsion(const Frame& A, const Frame& B, const Vec3& a, double c, double d) {
  add({A, Vec3::Zero(), -a}, {B, Vec3::Zero(), a}, c, d);
}

void StiffnessSink::add(const Side& a, const Side& b, double c, double d) {
  struct Part {
    int u;
    double w;  // of the direction
  };
  boost::container::small_vector<Part, 24> parts;
  for (const Side* side : {&a, &b}) {
    if (side->frame.block < 0) continue;
    for (int j = 0; j < side->frame.nu(); ++j) {
      const double w =
          side->frame.J_S_I.col(j).dot(side->force) + side->frame.J_R_I.col(j).dot(side->moment);
      if (w != 0.0) parts.push_back({side->frame.u0 + j, w});
    }
  }
  for (const Part& row : parts)
    for (const Part& column : parts)
      entries_.push_back({row.u, column.u, -c * row.w * column.w, -d * row.w * column.w});
}

}  // namespace dynamy
