/// PairKernel: the contacts that two kinds of shapes make. One object serves all pairs of these
/// kinds; the table of pairs (pair_table.hpp) holds one for every two kinds that can touch.
///
///   contacts   g, point, directions and rates of all contacts of a pair at its place
///   gap        least distance of a pair, for bodies that are fast (theory 37)
///   features   contacts are numbered 0, 1, …; a number stays with its features while they move
///
/// A switch over the kinds of contact was rejected: what belongs to one pair was spread over six
/// of them, and nobody could add a pair from outside.
#pragma once
#include <cstdint>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>
#include <limits>
#include <string>

namespace dynamy {

class PairReport;

/// Two shapes at their places. The kind of `a` comes later in TouchingShape::Kind, or both are
/// equal.
struct PosedPair {
  const TouchingShape &a, &b;
  const Frame &A, &B;  ///< frames that carry them
  const Vec3& plane;   ///< normal of the plane of motion, zero in space
};

/// How a simulation that follows gaps (theory 50.9, 50.11) follows those of a pair.
enum class Following : std::uint8_t {
  gaps,      ///< each gap on its own, at any distance
  searched,  ///< the same; among many shapes for near pairs only, since the gap takes a search
  jumping,   ///< no gap: contacts jump between features. The pair is noted before it touches
  pairwise   ///< pairs of features, which come and go one by one (feature_pairs.hpp)
};

/// Work of a gap in closed form, and of one that takes a search for its normal, in evaluations of one
/// velocity, each 0.1 to 0.35 µs (theory 37.7).
inline constexpr double kGapWork = 3.0, kSearchWork = 50.0;
/// Pairs that take more work than this are searches: bodies are first seen to be apart.
inline constexpr double kDearWork = 10.0;

/// Of the followed pairs of features, those that share a corner with a contact: `count` from
/// number `first` on.
struct FollowedPartners {
  std::uint64_t first = 0, count = 0;
};

class PairKernel {
 public:
  PairKernel() = default;
  PairKernel(const PairKernel&) = delete;
  PairKernel& operator=(const PairKernel&) = delete;
  virtual ~PairKernel() = default;

  /// Can these two shapes touch? Depends on their traits only (pair_rules.cpp). Kinds are known
  /// to match.
  virtual bool fits(const TouchingShape& /*a*/, const TouchingShape& /*b*/) const { return true; }
  /// Reports all contacts of the pair.
  virtual void contacts(PairReport& report) const = 0;
  /// Gap of feature f < swept(b) [m]. Beyond seen(b) any larger value will do. Between bodies with
  /// faces, their separation.
  virtual double gap(const PosedPair& pair, std::size_t f) const = 0;

  /// How many contacts two shapes may make, numbered from 0.
  virtual std::uint64_t features(const TouchingShape& /*a*/, const TouchingShape& /*b*/) const {
    return 1;
  }
  /// Name of contact number f of two shapes; empty if it is their only contact.
  virtual std::string featureName(const TouchingShape& /*a*/, const TouchingShape& /*b*/,
                                  std::uint64_t /*f*/) const {
    return {};
  }

  virtual Following following(const TouchingShape& /*a*/, const TouchingShape& /*b*/) const {
    return Following::gaps;
  }
  /// Work of one gap(), in evaluations of one velocity (theory 37.7).
  virtual double work(const TouchingShape& a, const TouchingShape& b) const {
    const Following how = following(a, b);
    return how == Following::searched || how == Following::jumping ? kSearchWork : kGapWork;
  }
  // If following() is pairwise:
  /// How many of the features, the last ones, are pairs of features followed one by one.
  virtual std::uint64_t followed(const TouchingShape& /*a*/, const TouchingShape& /*b*/) const {
    return 0;
  }
  /// Reports those pairs of features that are requested by key, and notes those that may touch.
  virtual void follow(PairReport& /*report*/) const {}
  virtual FollowedPartners partners(const TouchingShape& /*a*/, const TouchingShape& /*b*/,
                                    std::uint64_t /*f*/) const {
    return {};
  }

  // For fast bodies:
  /// How many features of b have a gap of their own along a path.
  virtual std::size_t swept(const TouchingShape& /*b*/) const { return 1; }
  /// Depth to which an overlap is known [m]: deeper, bodies may have passed through each other.
  virtual double seenBelow(const TouchingShape& /*b*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Largest gap that is known [m].
  virtual double seen(const TouchingShape& /*b*/) const {
    return std::numeric_limits<double>::infinity();
  }
};

}  // namespace dynamy
