/// MechanismGraph: which mass blocks and joints of a mechanism are coupled, where their unknowns
/// stand, and the colours of the blocks.
///
/// Unknowns are the velocities of the blocks and one impulse per row of a joint. They follow a walk
/// along the mechanism (MechanismWalk), so that the matrix of the mechanism is a band. No two
/// blocks of a colour have a common neighbour: all blocks of one colour can be moved at once to
/// find the columns of that matrix by differences.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/schemes/joints/mechanism_walk.hpp>
#include <dynamy/system/mass_matrix.hpp>
#include <utility>
#include <vector>

namespace dynamy {

class MechanismGraph {
 public:
  /// The joints are the contacts `joints` of c; `coupled`: pairs of blocks that forces couple, in
  /// both orders.
  void build(const MassMatrix& mass, const ContactSet& c, const std::vector<int>& joints,
             const std::vector<std::pair<int, int>>& coupled);
  /// True: the last build() had these joints.
  bool isOf(const ContactSet& c, const std::vector<int>& joints) const;

  const MechanismWalk& walk() const { return walk_; }
  int blocks() const { return static_cast<int>(nu_.size()); }
  int u0(int b) const { return u0_[static_cast<std::size_t>(b)]; }  ///< first velocity of block b
  int nu(int b) const { return nu_[static_cast<std::size_t>(b)]; }
  int mostNu() const { return mostNu_; }  ///< the largest nu(b)
  /// The rows of joint k are row0(k) ≤ i < row0(k + 1); rows(): of all joints.
  int row0(int k) const { return row0_[static_cast<std::size_t>(k)]; }
  int rows() const { return row0_.back(); }

  /// Blocks that a joint or a force couples with block b, and b itself; ascending.
  const std::vector<int>& nearBlocks(int b) const {
    return nearBlocks_[static_cast<std::size_t>(b)];
  }
  const std::vector<int>& nearJoints(int b) const {
    return nearJoints_[static_cast<std::size_t>(b)];
  }
  int colours() const { return colours_; }
  int colour(int b) const { return colour_[static_cast<std::size_t>(b)]; }

 private:
  void colourBlocks();

  std::vector<ContactKey> keys_;
  std::vector<int> row0_ = {0};
  std::vector<int> u0_, nu_, colour_;  // per block
  std::vector<std::vector<int>> nearBlocks_, nearJoints_;
  int colours_ = 0, mostNu_ = 0;
  MechanismWalk walk_;
};

}  // namespace dynamy
