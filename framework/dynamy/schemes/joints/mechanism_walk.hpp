/// MechanismWalk: an order of the unknowns of bodies and joints in which the matrix of a mechanism
/// is a narrow band. Each part is walked breadth first from a node with few neighbours
/// (Cuthill–McKee). Parts are mechanisms that no joint connects, and free bodies: nothing couples
/// two parts.
#pragma once
#include <cstddef>
#include <vector>

namespace dynamy {

class MechanismWalk {
 public:
  struct Node {
    bool joint = false;
    int index = 0;  ///< mass block, or joint
    int first = 0;  ///< its first unknown
  };
  struct Part {
    int firstNode = 0, lastNode = 0;  ///< nodes() firstNode ≤ i < lastNode
    int first = 0, last = 0;          ///< unknowns first ≤ i < last
  };
  /// Finds the order. near: the neighbours of each block and, after the blocks, of each joint;
  /// blockRows, jointRows: the number of unknowns of each block and joint.
  void order(const std::vector<std::vector<int>>& near, const std::vector<int>& blockRows,
             const std::vector<int>& jointRows);
  const std::vector<Node>& nodes() const { return nodes_; }
  const Part& part(int p) const { return parts_[static_cast<std::size_t>(p)]; }
  const std::vector<int>& ends() const { return ends_; }  ///< Part::last of each part
  int partOfBlock(std::size_t b) const { return blockPart_[b]; }
  /// First unknown of block b; joint(): of joint k.
  int block(std::size_t b) const { return block_[b]; }
  int joint(std::size_t k) const { return joint_[k]; }
  int unknowns() const { return unknowns_; }
  int band() const { return band_; }  ///< largest distance of two unknowns that are coupled

 private:
  std::vector<Node> nodes_;
  std::vector<Part> parts_;
  std::vector<int> ends_, block_, joint_, blockPart_;
  int unknowns_ = 0, band_ = 0;
};

}  // namespace dynamy
