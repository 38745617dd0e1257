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
  const Side* sides[2] = {&a, &b};
  const auto w = [](const Side& s, int j) {  // entry j of the direction
    return s.frame.J_S_I.col(j).dot(s.force) + s.frame.J_R_I.col(j).dot(s.moment);
  };
  for (const Side* row : sides) {
    if (row->frame.block < 0) continue;
    for (int i = 0; i < row->frame.nu(); ++i) {
      const double wi = w(*row, i);
      if (wi == 0.0) continue;
      for (const Side* column : sides) {
        if (column->frame.block < 0) continue;
        for (int j = 0; j < column->frame.nu(); ++j)
          if (const double wj = w(*column, j); wj != 0.0)
            entries_.push_back(
                {row->frame.u0 + i, column->frame.u0 + j, -c * wi * wj, -d * wi * wj});
      }
    }
  }
}

}  // namespace dynamy
