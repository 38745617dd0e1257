#include <algorithm>
#include <dynamy/stages/lost_impulses.hpp>
#include <limits>

namespace dynamy {
namespace {

using NumberedKeys = std::vector<std::pair<ContactKey, int>>;
using BodyPair = std::array<int, 2>;

void sortedKeys(const std::vector<ContactKey>& keys, NumberedKeys& out) {
  out.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) out.emplace_back(keys[i], static_cast<int>(i));
  std::sort(out.begin(), out.end());
}

/// `out`: numbers of the entries of `a` whose key is not in `b`. For keys in both, calls `both`
/// with the numbers in a and b.
template <class Both>
void splitBy(const NumberedKeys& a, const NumberedKeys& b, std::vector<int>& out, Both&& both) {
  out.clear();
  auto at = b.begin();
  for (const auto& [key, i] : a) {
    while (at != b.end() && at->first < key) ++at;
    if (at == b.end() || at->first != key)
      out.push_back(i);
    else
      both(i, at->second);
  }
}

/// First velocities of the blocks of contact i; −1: there is none.
BodyPair bodiesOf(const ContactSet& c, int i) {
  BodyPair bodies{-1, -1};
  const auto at = static_cast<std::size_t>(i);
  const int first = c.segment0[at], n = std::min(2, c.segment0[at + 1] - first);
  for (int k = 0; k < n; ++k)
    bodies[static_cast<std::size_t>(k)] = c.segment[static_cast<std::size_t>(first + k)].u0;
  return bodies;
}

const Vec3& rowDirection(const ContactSet& c, int i, int row) {
  const auto at = static_cast<std::size_t>(i);
  return row == 0 ? c.places.normal[at] : (row == 1 ? c.places.t1[at] : c.places.t2[at]);
}

/// Rows N, T1, T2 with known directions.
int placedRows(const ContactSet& c, int i) {
  const int most = std::min(3, c.dim(i));
  int rows = 0;
  while (rows < most && !rowDirection(c, i, rows).isZero(0.0)) ++rows;
  return rows;
}

/// Sets a pulling normal impulse of contact i to zero.
void onlyPush(const ContactSet& c, int i, Vec Lambda) {
  const auto at = static_cast<std::size_t>(i);
  if (c.law[at]->unilateral()) Lambda[c.row0[at]] = std::max(0.0, Lambda[c.row0[at]]);
}

}  // namespace

void LostImpulses::remember(const ContactSet& c, ConstVec Lambda, Eigen::VectorXd& out) {
  out.setZero(std::max(1, kNumbers * c.size()));
  for (int i = 0; i < c.size(); ++i) {
    auto of = out.segment<kNumbers>(kNumbers * i);
    const auto at = static_cast<std::size_t>(i);
    of.head<3>() = c.places.point[at];
    for (int r = 0; r < placedRows(c, i); ++r)
      of.segment<3>(3) += Lambda[c.row0[at] + r] * rowDirection(c, i, r);
    const BodyPair bodies = bodiesOf(c, i);
    of[6] = bodies[0], of[7] = bodies[1];
  }
}

void LostImpulses::compare(const RememberedImpulses& old, ConstVec places, const ContactSet& c) {
  sortedKeys(old.key, old_), sortedKeys(c.key, now_);
  kept_.clear();
  splitBy(old_, now_, lost_, [this](int i, int j) { kept_.push_back({i, j}); });
  splitBy(now_, old_, fresh_, [](int, int) {});
  pairs_.clear(), contacts_.clear();
  for (const int k : lost_)
    pairs_.push_back(
        {static_cast<int>(places[kNumbers * k + 6]), static_cast<int>(places[kNumbers * k + 7])});
  std::sort(pairs_.begin(), pairs_.end());
  for (int i = 0; i < c.size(); ++i)
    if (const BodyPair bodies = bodiesOf(c, i);
        std::binary_search(pairs_.begin(), pairs_.end(), bodies))
      contacts_.push_back({bodies, i, false});
  std::sort(fresh_.begin(), fresh_.end());
  for (Contact& x : contacts_) x.fresh = std::binary_search(fresh_.begin(), fresh_.end(), x.number);
  std::sort(contacts_.begin(), contacts_.end(), [](const Contact& a, const Contact& b) {
    return a.bodies != b.bodies ? a.bodies < b.bodies : a.number < b.number;
  });
}

LostImpulses::Contact* LostImpulses::taker(const BodyPair& bodies, const Vec3& point,
                                           const ContactSet& c) {
  Contact* best = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  const auto first =
      std::lower_bound(contacts_.begin(), contacts_.end(), bodies,
                       [](const Contact& a, const BodyPair& b) { return a.bodies < b; });
  for (auto x = first; x != contacts_.end() && x->bodies == bodies; ++x) {
    const double away = (c.places.point[static_cast<std::size_t>(x->number)] - point).squaredNorm();
    const bool sooner = !best || x->fresh > best->fresh;
    if (!sooner && (x->fresh < best->fresh || !(away < nearest))) continue;
    best = &*x, nearest = away;
  }
  return best;
}

void LostImpulses::handOn(const RememberedImpulses& old, ConstVec places, const ContactSet& c,
                          double scale, Vec Lambda) {
  if (places.size() != kNumbers * static_cast<Eigen::Index>(old.key.size())) return;
  compare(old, places, c);
  for (const auto& [k, i] : kept_) {
    const Vec3 impulse = scale * places.segment<3>(kNumbers * k + 3);
    for (int r = 0; r < placedRows(c, i); ++r)
      Lambda[c.row0[static_cast<std::size_t>(i)] + r] = rowDirection(c, i, r).dot(impulse);
    onlyPush(c, i, Lambda);
  }
  for (const int k : lost_) {
    const auto of = places.segment<kNumbers>(kNumbers * k);
    const Vec3 impulse = scale * of.segment<3>(3);
    if (impulse.isZero(0.0)) continue;
    const BodyPair bodies{static_cast<int>(of[6]), static_cast<int>(of[7])};
    Contact* const to = taker(bodies, of.head<3>(), c);
    if (!to) continue;
    to->fresh = false;
    const int row = c.row0[static_cast<std::size_t>(to->number)];
    for (int r = 0; r < placedRows(c, to->number); ++r)
      Lambda[row + r] += rowDirection(c, to->number, r).dot(impulse);
    onlyPush(c, to->number, Lambda);
  }
}

}  // namespace dynamy
