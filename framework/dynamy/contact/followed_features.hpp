/// FollowedFeatures: pairs of features (corners, edges, faces) of bodies whose contacts come and go
/// with the features that touch. Filled only if such pairs are followed one by one
/// (ContactRequest::follow).
#pragma once
#include <dynamy/core/types.hpp>
#include <limits>
#include <vector>

namespace dynamy {

struct FollowedFeatures {
  static constexpr double kAlways = 1e300;
  /// Presence per closed contact [m]: positive while its two features lie over one another, zero
  /// where they cease to do so; kAlways: the contact does not come and go.
  std::vector<double> presence;
  /// Per closed contact: not 0 for the lowest point of a circle that is tilted little, whose presence
  /// is by how much it is further below its middle than that of a flat circle.
  std::vector<char> circle;
  std::vector<ContactKey> noted;  ///< pairs that may touch soon
  double searched = 0.0;          ///< work of gaps that took a search, in evaluations of a velocity
  bool comeAndGo = false;         ///< some contacts here come and go with the features that touch
  bool unseen = false;            ///< bodies may meet and part again before the next look
  /// Deepest overlap of bodies whose contacts come and go [m], −∞: there are none; and the least
  /// number that a contact of theirs may have.
  double overlap = 0.0;
  ContactKey deepest{};
  /// Of bodies whose contacts jump, so that they cannot be followed while they touch: deepest overlap
  /// [m], and a contact of theirs.
  double jumpingOverlap = 0.0;
  ContactKey jumping{};

  bool isOnCircle(int i) const {
    return static_cast<std::size_t>(i) < circle.size() && circle[static_cast<std::size_t>(i)] != 0;
  }
  void clear() {
    presence.clear(), circle.clear(), noted.clear(), comeAndGo = unseen = false, searched = 0.0;
    overlap = jumpingOverlap = -std::numeric_limits<double>::infinity();
  }
};

}  // namespace dynamy
