/// BroadPhase: finds which of n balls are near each other, in O(n), by a hierarchy of grids.
///
///   pairs (i, j), i < j, with |c_i − c_j| ≤ R_i + R_j, ordered by i, then j
///
/// Level k is a grid of cells of edge s 2^k. A ball belongs to the lowest level whose
/// edge is at least its diameter, in the cell of its centre. Two near balls of one level
/// are in equal or neighbouring cells. A ball finds larger ones in the 27 cells about its
/// centre on their level. Cells are hashed, so that only cells with balls cost memory. A
/// few balls are compared pair by pair.
///
/// Boxes, which hold paths, are sorted along the axis on which they spread most, and compared while
/// they overlap there.
///
/// A tree over the balls was rejected: heaps of bodies change everywhere in every step, and a grid
/// is rebuilt in less time than a tree is refitted. All memory is kept between calls; nothing is
/// allocated once the largest problem has been seen.
#pragma once
#include <Eigen/Geometry>
#include <dynamy/core/types.hpp>
#include <utility>
#include <vector>

namespace dynamy {

class BroadPhase {
 public:
  using Pair = std::pair<int, int>;
  /// A ball around a shape, enlarged by the distance at which other shapes are to be found.
  struct Ball {
    Vec3 c = Vec3::Zero();  ///< [m]
    double radius = 0.0;    ///< [m]; below zero: the ball is ignored
  };
  /// The near pairs, valid until the next call. The search ends early once there are more than
  /// kMostPairs + each·n pairs.
  const std::vector<Pair>& near(const std::vector<Ball>& balls, std::size_t each = kPassed);
  /// As above, for boxes that overlap; empty boxes are ignored, and no bound may be NaN.
  using Box = Eigen::AlignedBox3d;
  const std::vector<Pair>& near(const std::vector<Box>& boxes, std::size_t each = kPassed);
  /// Did the last call end early? Then its pairs are incomplete.
  bool overfull() const { return overfull_; }
  /// Number of pairs per ball above which no step could use them. kNeighbours: at rest, where
  /// grains have about five and packed rods of ten diameters 130. kPassed: balls widened by their
  /// motion in a step.
  static constexpr std::size_t kNeighbours = 128, kPassed = 1024;

 private:
  static constexpr std::size_t kMostPairs = 1u << 21;
  static constexpr int kLevels = 32;
  struct Cell {
    int x = 0, y = 0, z = 0, level = 0;
    bool operator==(const Cell&) const = default;
  };
  void compareAll(const std::vector<Ball>& balls);
  bool fill(const std::vector<Ball>& balls);
  std::size_t cellsOfEach() const;
  void lookAround(const std::vector<Ball>& balls, int i);
  void lookInto(const std::vector<Ball>& balls, int i, const Cell& cell, bool later);
  bool fillsUp();
  void order(std::size_t n);
  Cell cellOf(const Vec3& c, int level) const;
  std::size_t bucket(const Cell& cell) const;

  bool overfull_ = false;
  std::size_t most_ = 0;
  double edge_ = 1.0;  ///< edge of the cells of level 0 [m]
  bool used_[kLevels] = {};
  std::vector<Cell> cell_;  ///< per ball
  std::vector<int> first_;  ///< per bucket, into `members_`
  std::vector<int> members_;
  std::vector<Pair> pairs_, ordered_;
  std::vector<int> firstOf_;  ///< per ball, into `ordered_`
};

}  // namespace dynamy
