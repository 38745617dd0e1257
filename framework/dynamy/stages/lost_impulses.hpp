/// LostImpulses: start values for contacts whose bodies touched under another key in the last step.
///
/// Where faces and edges of two bodies are aligned, rounding decides between a corner on a face and
/// two edges that cross, and the same place gets another key. This is rare where steps are solved
/// to rounding. Where bodies move by 1e-7 m, a tenth of the contacts of a wall at rest change their
/// keys in every step. The impulse of a contact that is gone goes, as a vector, to the nearest new
/// contact of the same two bodies. Without a new contact it is added to their nearest contact, so
/// that the sum for the two bodies is kept. Rejected: the nearest contact of any bodies, which
/// often belongs to another brick.
#pragma once
#include <array>
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/system/state.hpp>

namespace dynamy {

class LostImpulses {
 public:
  /// Count of numbers that `remember` writes per contact.
  static constexpr int kNumbers = 8;
  /// Writes place [m], impulse [N s] and bodies of every contact; at least one number. `Lambda`:
  /// rows of `contacts`.
  static void remember(const ContactSet& contacts, ConstVec Lambda, Eigen::VectorXd& out);
  /// Puts `scale` times the lost impulses into `Lambda`, rows of `contacts`. `places`: what was
  /// remembered of the contacts of `old`.
  void handOn(const RememberedImpulses& old, ConstVec places, const ContactSet& contacts,
              double scale, Vec Lambda);

 private:
  struct Contact {
    std::array<int, 2> bodies;
    int number;
    bool fresh;  ///< nothing remembered has its key, and nothing was handed to it
  };
  void compare(const RememberedImpulses& old, ConstVec places, const ContactSet& contacts);
  /// The contact of these bodies nearest to `point`, new contacts before others; null: none.
  Contact* taker(const std::array<int, 2>& bodies, const Vec3& point, const ContactSet& contacts);
  std::vector<std::pair<ContactKey, int>> old_, now_;
  std::vector<std::array<int, 2>> kept_;  ///< index of a contact in the last and in this step
  std::vector<int> lost_, fresh_;         ///< lost contacts of the last step, new ones of this step
  std::vector<Contact> contacts_;         ///< contacts of `pairs_`, sorted by bodies
  std::vector<std::array<int, 2>> pairs_;  ///< pairs of bodies that lost contacts, sorted
};

}  // namespace dynamy
