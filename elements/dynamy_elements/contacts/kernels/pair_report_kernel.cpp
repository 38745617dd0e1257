// Rows of one contact: W, χ and bias from point, directions and their rates.
#include <dynamy/contact/rolling_contact.hpp>
#include <dynamy_elements/contacts/kernels/grain.hpp>
#include <dynamy_elements/contacts/kernels/pair_report.hpp>
#include <dynamy_elements/contacts/pairs/contour_motion.hpp>

namespace dynamy {
namespace {

/// The point of contact moves with Ṗ, not with a body.
void addBias(ContactRows& rows, const ContactPoint& at, const Frame& A, const Frame& B) {
  const Vec3 rhoA = at.P - A.r_OS_I, rhoB = at.P - B.r_OS_I;
  const Vec3 v_BA = B.velocity(rhoB) - A.velocity(rhoA);
  const Vec3 a_BA = B.bias_S_I + B.bias_R_I.cross(rhoB) + B.Omega_I.cross(at.Pdot - B.v_S_I) -
                    A.bias_S_I - A.bias_R_I.cross(rhoA) - A.Omega_I.cross(at.Pdot - A.v_S_I);
  for (int r = 0; r < rows.dim() && r < 3; ++r)
    rows.bias(r) = at.ddot[r].dot(v_BA) + at.d[r].dot(a_BA);
  // Angular velocities: spin about the normal, and about the tangents.
  const int first = rows.dim() == 5 ? 1 : 0;
  for (int r = 3; r < rows.dim() && r < 6; ++r) {
    const int k = first + r - 3;
    rows.bias(r) = at.ddot[k].dot(B.Omega_I - A.Omega_I) + at.d[k].dot(B.bias_R_I - A.bias_R_I);
  }
}

}  // namespace

void PairReport::write(ContactRows& rows, std::size_t feature, const ContactPoint& found) const {
  const Frame &A = pair_.A, &B = pair_.B;
  ContactPoint turned;
  if (rule_.grain) {
    const bool ofA = !pair_.a.grain_K.isZero(0.0);
    const Frame& f = ofA ? A : B;
    turned = found;
    alongGrain(turned, f.A_IK * (ofA ? pair_.a : pair_.b).grain_K, f.Omega_I);
  }
  const ContactPoint& at = rule_.grain ? turned : found;
  const Vec3 rhoA = at.P - A.r_OS_I, rhoB = at.P - B.r_OS_I;
  if (rows.dim() <= 4) {
    pointContact(rows, A, rhoA, B, rhoB, at.d[0], at.d[1], at.d[2]);
    if (rows.wantsBias()) addBias(rows, at, A, B);
    return;
  }
  if (rows.dim() <= 6) {
    rollingContact(rows, A, rhoA, B, rhoB, at.d[0], at.d[1], at.d[2], nullptr);
    if (rows.wantsBias()) addBias(rows, at, A, B);
    return;
  }
  const ContourMotion contour(pair_.b.features[feature], A, B, at, rows.wantsBias());
  rollingContact(rows, A, rhoA, B, rhoB, at.d[0], at.d[1], at.d[2], contour.c);
  if (!rows.wantsBias()) return;
  addBias(rows, at, A, B);
  for (int i = 0; i < 2; ++i)
    rows.bias(6 + i) =
        contour.cdot[i].dot(B.Omega_I - A.Omega_I) + contour.c[i].dot(B.bias_R_I - A.bias_R_I);
}

}  // namespace dynamy
