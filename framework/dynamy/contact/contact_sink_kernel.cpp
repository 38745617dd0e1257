#include <algorithm>
#include <dynamy/contact/rolling_contact.hpp>
#include <dynamy/law/most_rows.hpp>
#include <stdexcept>

namespace dynamy {
namespace {

/// Raises the error for a wrong number of rows, before any row out of range is written. Open
/// contacts are checked too, so that a model fails at once and not when its bodies first touch.
/// The framework adds the element's name and place.
[[noreturn]] void wrongRows(const SetValuedForceLaw& law, std::uint64_t id, int dim) {
  throw std::length_error("its contact " + std::to_string(id) + " has " + std::to_string(dim) +
                          " rows" + (law.type().empty() ? "" : " by its law <" + law.type() + '>') +
                          "; a contact has 1 to " + std::to_string(kMostRows) +
                          " — report the rows as several contacts");
}

}  // namespace

ContactRows ContactSink::add(std::uint64_t id, double g, const SetValuedForceLaw& law,
                             int geometric) {
  ContactSet& c = *set_;
  const ContactKey key = contactKey(element_, id);
  const bool unilateral = law.unilateral();
  const int dim = law.dim(geometric);
  if (dim < 1 || dim > kMostRows) wrongRows(law, id, dim);
  const bool closed = request_.refresh
                          ? std::binary_search(request_.frozen.begin(), request_.frozen.end(), key)
                          : !unilateral || g <= request_.gTol;
  c.candidateKey.push_back(key);
  c.g.push_back(g);
  c.candidateElement.push_back(element_);
  c.closedIndex.push_back(closed ? c.size() : -1);
  if (!closed) return {};
  const int index = c.size();
  const auto row = c.chi.size(), rows = row + static_cast<std::size_t>(dim);
  c.key.push_back(key);
  c.law.push_back(&law);
  c.element.push_back(element_);
  c.candidate.push_back(static_cast<int>(c.g.size()) - 1);
  c.row0.push_back(c.row0.back() + dim);
  c.segment0.push_back(c.segment0.back());
  c.position.resize(rows), c.chi.resize(rows);
  if (unilateral || dim == 1) c.position[row] = g;
  c.scale.push_back(1.0);
  if (request_.follow)
    c.features.presence.push_back(FollowedFeatures::kAlways), c.features.circle.push_back(0);
  if (request_.bias) c.bias.resize(rows);
  c.places.add();
  return {c, index, request_.bias, some_};
}

void ContactSink::add(const ContactSet& from, int i, int geometric) {
  const auto at = static_cast<std::size_t>(i), row0 = static_cast<std::size_t>(from.row0[at]);
  ContactRows rows =
      add(contactNumber(from.key[at]), from.position[row0], *from.law[at], geometric);
  if (!rows) return;
  for (int r = 0; r < rows.dim(); ++r) {
    rows.chi(r) = from.chi[row0 + static_cast<std::size_t>(r)];
    if (rows.wantsBias()) rows.bias(r) = from.bias[row0 + static_cast<std::size_t>(r)];
  }
  for (int k = from.segment0[at]; k < from.segment0[at + 1]; ++k) {
    const Segment& s = from.segment[static_cast<std::size_t>(k)];
    rows.segment(BlockPlace{s.block, s.u0, s.nu}) =
        ConstBlock(from.W.data() + s.w, rows.dim(), s.nu);
  }
  const ContactPlaces& p = from.places;
  rows.place(p.point[at], p.normal[at], p.t1[at], p.t2[at]);
}

std::span<const ContactKey> ContactSink::asked(std::uint64_t first, std::uint64_t end) const {
  const std::span<const ContactKey> all = request_.frozen;
  const auto from = std::lower_bound(all.begin(), all.end(), contactKey(element_, first));
  const auto to = std::lower_bound(from, all.end(), contactKey(element_, end));
  return {from, to};
}

Block ContactRows::segment(const BlockPlace& block) {
  const auto [number, u0, nu] = block;
  ContactSet& c = *set_;
  const int rows = dim();
  // Two bodies of one tree share their block.
  for (int k = c.segment0[static_cast<std::size_t>(index_)]; k < c.segment0.back(); ++k)
    if (const Segment& s = c.segment[static_cast<std::size_t>(k)]; s.block == number)
      return {c.W.data() + s.w, rows, nu};
  const auto offset = static_cast<std::ptrdiff_t>(c.W.size());
  c.W.resize(c.W.size() + static_cast<std::size_t>(rows) * static_cast<std::size_t>(nu));
  c.segment.push_back({number, u0, nu, offset});
  ++c.segment0.back();
  return {c.W.data() + offset, rows, nu};
}

void ContactRows::place(const Vec3& point, const Vec3& normal, const Vec3& t1, const Vec3& t2) {
  const auto at = static_cast<std::size_t>(index_);
  ContactPlaces& places = set_->places;
  places.point[at] = point, places.normal[at] = normal;
  places.t1[at] = t1, places.t2[at] = t2;
}

void addPointRow(Block W, int row, const Frame& frame, const Vec3& rho_I, const Vec3& direction,
                 double sign) {
  const Vec3 moment = rho_I.cross(direction);
  if (frame.central) {
    Eigen::Map<Eigen::Matrix<double, 1, 6>> out(W.data() + row * W.cols());
    out.head<3>() += sign * direction.transpose();
    out.tail<3>() += sign * moment.transpose().lazyProduct(frame.A_IK);
    return;
  }
  if (frame.nu() == 6) {
    using Jacobian = Eigen::Map<const Eigen::Matrix<double, 3, 6>>;
    Eigen::Map<Eigen::Matrix<double, 1, 6>>{W.data() + row * W.cols()} +=
        sign * (direction.transpose().lazyProduct(Jacobian(frame.J_S_I.data())) +
                moment.transpose().lazyProduct(Jacobian(frame.J_R_I.data())));
    return;
  }
  for (int j = 0; j < frame.nu(); ++j)
    W(row, j) += sign * (frame.J_S_I.col(j).dot(direction) + frame.J_R_I.col(j).dot(moment));
}

namespace {

/// Number of rows with velocities of points; further rows have angular velocities.
constexpr int kPointRows = 3;

/// Rows Dᵀ J_S + (ρ × D)ᵀ J_R of all directions n, t1, t2 at once, for a block of six velocities.
void threeRows(Block W, const Frame& f, const Vec3& rho, const Vec3* const* direction,
               double sign) {
  if (f.central) {  // products are written out: a stack has eighty such blocks per step
    const double* A = f.A_IK.data();
    double* out = W.data();
    for (int r = 0; r < 3; ++r, out += 6) {
      const double x = sign * direction[r]->x(), y = sign * direction[r]->y(),
                   z = sign * direction[r]->z();
      const double mx = rho.y() * z - rho.z() * y, my = rho.z() * x - rho.x() * z,
                   mz = rho.x() * y - rho.y() * x;
      out[0] = x, out[1] = y, out[2] = z;
      out[3] = mx * A[0] + my * A[1] + mz * A[2];
      out[4] = mx * A[3] + my * A[4] + mz * A[5];
      out[5] = mx * A[6] + my * A[7] + mz * A[8];
    }
    return;
  }
  Mat3 D, moment;
  for (int r = 0; r < 3; ++r) {
    D.row(r) = sign * *direction[r];
    moment.row(r) = sign * rho.cross(*direction[r]);
  }
  using Jacobian = Eigen::Map<const Eigen::Matrix<double, 3, 6>>;
  Eigen::Map<Eigen::Matrix<double, 3, 6, Eigen::RowMajor>>{W.data()} +=
      D.lazyProduct(Jacobian(f.J_S_I.data())) + moment.lazyProduct(Jacobian(f.J_R_I.data()));
}

/// Adds the part of one body to W, χ and bias: the velocity of its point along each direction,
/// times `sign`. From the fourth row on it is the angular velocity along the row's direction.
void addSide(ContactRows& rows, const Frame& f, const Vec3& rho, const Vec3* const* direction,
             double sign) {
  const int dim = rows.dim();
  if (f.block >= 0) {
    Block W = rows.segment(f);
    if (dim >= kPointRows && f.nu() == 6)
      threeRows(W, f, rho, direction, sign);
    else
      for (int r = 0; r < dim && r < kPointRows; ++r)
        addPointRow(W, r, f, rho, *direction[r], sign);
    for (int r = kPointRows; r < dim; ++r)
      for (int j = 0; j < f.nu(); ++j) W(r, j) += sign * f.J_R_I.col(j).dot(*direction[r]);
  }
  if (!f.central) {  // else ν = 0
    const Vec3 nu = f.nu_S_I + f.nu_R_I.cross(rho);
    for (int r = 0; r < dim; ++r)
      rows.chi(r) += sign * (r < kPointRows ? nu : f.nu_R_I).dot(*direction[r]);
  }
  if (!rows.wantsBias()) return;
  const Vec3 a = f.bias_S_I + f.bias_R_I.cross(rho) + f.Omega_I.cross(f.Omega_I.cross(rho));
  for (int r = 0; r < dim; ++r)
    rows.bias(r) += sign * (r < kPointRows ? a : f.bias_R_I).dot(*direction[r]);
}

}  // namespace

void pointContact(ContactRows& rows, const Frame& A, const Vec3& rhoA_I, const Frame& B,
                  const Vec3& rhoB_I, const Vec3& n, const Vec3& t1, const Vec3& t2) {
  const Vec3* direction[4] = {&n, &t1, &t2, &n};
  addSide(rows, A, rhoA_I, direction, -1.0);
  addSide(rows, B, rhoB_I, direction, 1.0);
  rows.place(B.r_OS_I + rhoB_I, n, t1, t2);
}

void rollingContact(ContactRows& rows, const Frame& A, const Vec3& rhoA_I, const Frame& B,
                    const Vec3& rhoB_I, const Vec3& n, const Vec3& t1, const Vec3& t2,
                    const Vec3* c) {
  const Vec3* direction[8] = {&n, &t1, &t2, &n, &t1, &t2, c, c ? c + 1 : nullptr};
  if (rows.dim() == 5) direction[3] = &t1, direction[4] = &t2;
  addSide(rows, A, rhoA_I, direction, -1.0);
  addSide(rows, B, rhoB_I, direction, 1.0);
  rows.place(B.r_OS_I + rhoB_I, n, t1, t2);
}

}  // namespace dynamy
