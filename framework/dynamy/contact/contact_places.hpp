/// ContactPlaces: where contacts are, one entry per closed contact: the point of contact and the
/// directions of the rows N, T1, T2. For the replay, for signals, and for methods that compare
/// contacts by place.
#pragma once
#include <dynamy/core/types.hpp>
#include <vector>

namespace dynamy {

struct ContactPlaces {
  std::vector<Vec3> point;  ///< [m], in I
  /// Unit vectors in I. A zero direction is not known; a contact with a zero normal has no place.
  std::vector<Vec3> normal, t1, t2;

  void clear() { point.clear(), normal.clear(), t1.clear(), t2.clear(); }
  /// Adds a contact that has no place yet.
  void add() {
    point.push_back(Vec3::Zero());
    for (auto* directions : {&normal, &t1, &t2}) directions->push_back(Vec3::Zero());
  }
  /// Adds contact `i` of `other`.
  void add(const ContactPlaces& other, std::size_t i) {
    point.push_back(other.point[i]), normal.push_back(other.normal[i]);
    t1.push_back(other.t1[i]), t2.push_back(other.t2[i]);
  }
};

}  // namespace dynamy
