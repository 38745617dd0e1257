#include <algorithm>
#include <bit>
#include <cmath>
#include <dynamy_elements/contacts/search/broad_phase.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Up to so many balls all pairs are compared, which costs less than sorting balls into cells; and up to
/// kPairsOfCell times the cells that each looks into. A look into a cell takes as long as comparing
/// some ten pairs: by pairs, 100 balls of one size take 0.5 to 0.9 of the time, of seven sizes 0.2 to
/// 0.3 of it.
constexpr std::size_t kFew = 24, kPairsOfCell = 8;
/// Memory for up to so many pairs is reserved at once if more than a few are found (200 MB).
constexpr std::size_t kAtOnce = 25'000'000;
/// Bound of the coordinates of cells, also for bodies that fly away.
constexpr double kFarthest = 1e9;

bool touch(const BroadPhase::Ball& a, const BroadPhase::Ball& b) {
  const double R = a.radius + b.radius;
  return (a.c - b.c).squaredNorm() <= R * R;
}

/// The axis along which boxes start at the most different places.
int widestAxis(const std::vector<BroadPhase::Box>& boxes) {
  BroadPhase::Box starts;
  for (const BroadPhase::Box& box : boxes)
    if (!box.isEmpty() && box.min().allFinite()) starts.extend(box.min());
  int axis = 0;
  if (!starts.isEmpty()) starts.sizes().maxCoeff(&axis);
  return axis;
}

}  // namespace

const std::vector<BroadPhase::Pair>& BroadPhase::near(const std::vector<Ball>& balls,
                                                      std::size_t each) {
  pairs_.clear(), overfull_ = false;
  most_ = kMostPairs + each * balls.size();
  if (balls.size() <= kFew || !fill(balls) || balls.size() <= kPairsOfCell * cellsOfEach()) {
    compareAll(balls);
    return pairs_;
  }
  for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
    if (balls[static_cast<std::size_t>(i)].radius >= 0.0) lookAround(balls, i);
    if (fillsUp()) return pairs_;
  }
  order(balls.size());
  return ordered_;
}

const std::vector<BroadPhase::Pair>& BroadPhase::near(const std::vector<Box>& boxes,
                                                      std::size_t each) {
  pairs_.clear(), overfull_ = false;
  most_ = kMostPairs + each * boxes.size();
  const int axis = widestAxis(boxes);
  const auto box = [&](int i) -> const Box& { return boxes[static_cast<std::size_t>(i)]; };
  members_.clear();
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    if (!box(i).isEmpty()) members_.push_back(i);
  std::sort(members_.begin(), members_.end(), [&](int i, int j) {
    const double a = box(i).min()[axis], b = box(j).min()[axis];
    return a < b || (a == b && i < j);
  });
  for (auto i = members_.begin(); i != members_.end(); ++i) {
    for (auto j = i + 1; j != members_.end() && box(*j).min()[axis] <= box(*i).max()[axis]; ++j)
      if (box(*i).intersects(box(*j))) pairs_.push_back(std::minmax(*i, *j));
    if (fillsUp()) return pairs_;
  }
  order(boxes.size());
  return ordered_;
}

void BroadPhase::compareAll(const std::vector<Ball>& balls) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].radius < 0.0) continue;  // e.g. grains that are not present yet
    for (std::size_t j = i + 1; j < balls.size(); ++j)
      if (balls[j].radius >= 0.0 && touch(balls[i], balls[j]))
        pairs_.emplace_back(static_cast<int>(i), static_cast<int>(j));
    if (fillsUp()) return;
  }
}

bool BroadPhase::fillsUp() {
  // For many bodies at one place: growing by doubling would take three times as much memory.
  if (pairs_.size() > kMostPairs && most_ <= kAtOnce) pairs_.reserve(most_);
  return overfull_ = pairs_.size() > most_;
}

/// Sorts the balls into cells; false: their radii give no size for the cells.
bool BroadPhase::fill(const std::vector<Ball>& balls) {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (const Ball& b : balls) {
    if (b.radius > 0.0) smallest = std::min(smallest, b.radius);
    largest = std::max(largest, b.radius);
  }
  if (!(largest > 0.0) || !std::isfinite(largest)) return false;
  // Balls smaller than the lowest level allows share it.
  edge_ = 2.0 * std::max(smallest, std::ldexp(largest, 2 - kLevels));
  const std::size_t n = balls.size(), buckets = std::bit_ceil(2 * n);
  cell_.resize(n), members_.resize(n);
  first_.assign(buckets + 1, 0);
  std::fill(std::begin(used_), std::end(used_), false);
  for (std::size_t i = 0; i < n; ++i) {
    if (balls[i].radius < 0.0) continue;
    int level = 0;
    for (double edge = edge_; edge < 2.0 * balls[i].radius && level < kLevels - 1; edge *= 2.0)
      ++level;
    used_[level] = true;
    cell_[i] = cellOf(balls[i].c, level);
    ++first_[bucket(cell_[i])];
  }
  for (std::size_t b = 0; b < buckets; ++b) first_[b + 1] += first_[b];
  // Backwards: first_[b] moves from the end of bucket b to its begin, and balls keep their order.
  for (std::size_t i = n; i-- > 0;) {
    if (balls[i].radius < 0.0) continue;
    members_[static_cast<std::size_t>(--first_[bucket(cell_[i])])] = static_cast<int>(i);
  }
  return true;
}

/// Number of cells into which a ball of the mean level looks.
std::size_t BroadPhase::cellsOfEach() const {
  const auto levels =
      static_cast<std::size_t>(std::count(std::begin(used_), std::end(used_), true));
  return 14 + 27 * (levels - 1) / 2;
}

BroadPhase::Cell BroadPhase::cellOf(const Vec3& c, int level) const {
  const double scale = std::ldexp(1.0 / edge_, -level);
  const auto at = [&](int k) {  // NaN goes to the outermost cell
    const double x = std::floor(c[k] * scale);
    return static_cast<int>(x < kFarthest ? (x > -kFarthest ? x : -kFarthest) : kFarthest);
  };
  return {at(0), at(1), at(2), level};
}

std::size_t BroadPhase::bucket(const Cell& cell) const {
  // Three large odd factors mix the coordinates, the last product their high bits into the low
  // ones.
  std::uint64_t h = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u;
  h ^= static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4Fu;
  h ^= static_cast<std::uint64_t>(cell.z) * 0x165667B19E3779F9u;
  h = (h + static_cast<std::uint64_t>(cell.level)) * 0xD6E8FEB86659FD93u;
  return static_cast<std::size_t>(h >> 32) & (first_.size() - 2);
}

/// Finds near balls in one cell. `later`: only balls after i, so that
/// pairs of one level are found once.
void BroadPhase::lookInto(const std::vector<Ball>& balls, int i, const Cell& cell, bool later) {
  const std::size_t b = bucket(cell);
  const Ball& ball = balls[static_cast<std::size_t>(i)];
  for (int m = first_[b]; m < first_[b + 1]; ++m) {
    const int j = members_[static_cast<std::size_t>(m)];
    if ((later && j <= i) || !(cell_[static_cast<std::size_t>(j)] == cell)) continue;
    if (touch(ball, balls[static_cast<std::size_t>(j)])) pairs_.push_back(std::minmax(i, j));
  }
}

void BroadPhase::lookAround(const std::vector<Ball>& balls, int i) {
  const Cell own = cell_[static_cast<std::size_t>(i)];
  // On its own level a ball searches half of the neighbouring cells; balls
  // of the other half search here.
  lookInto(balls, i, own, true);
  for (int k = 14; k < 27; ++k)
    lookInto(balls, i, {own.x + k / 9 - 1, own.y + k / 3 % 3 - 1, own.z + k % 3 - 1, own.level},
             false);
  for (int level = own.level + 1; level < kLevels; ++level) {
    if (!used_[level]) continue;
    const Cell at = cellOf(balls[static_cast<std::size_t>(i)].c, level);
    for (int k = 0; k < 27; ++k)
      lookInto(balls, i, {at.x + k / 9 - 1, at.y + k / 3 % 3 - 1, at.z + k % 3 - 1, level}, false);
  }
}

/// Sorts the pairs by their first ball in one pass, then the few pairs of
/// each first ball by the second.
void BroadPhase::order(std::size_t n) {
  firstOf_.assign(n + 1, 0);
  ordered_.resize(pairs_.size());
  for (const Pair& p : pairs_) ++firstOf_[static_cast<std::size_t>(p.first) + 1];
  for (std::size_t i = 0; i < n; ++i) firstOf_[i + 1] += firstOf_[i];
  for (const Pair& p : pairs_)
    ordered_[static_cast<std::size_t>(firstOf_[static_cast<std::size_t>(p.first)]++)] = p;
  for (std::size_t a = 0; a < ordered_.size();) {
    std::size_t b = a;
    while (b < ordered_.size() && ordered_[b].first == ordered_[a].first) ++b;
    std::sort(ordered_.begin() + static_cast<std::ptrdiff_t>(a),
              ordered_.begin() + static_cast<std::ptrdiff_t>(b));
    a = b;
  }
}

}  // namespace dynamy
