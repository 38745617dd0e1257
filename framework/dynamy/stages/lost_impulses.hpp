/// LostImpulses: a start for contacts whose bodies touched under another name in the last step.
///
/// Where faces and edges of two bodies are aligned, a corner on a face and two edges that cross are
/// told apart by rounding, and the same place gets another key. Where steps are solved to rounding
/// that is rare; where bodies move by 1e-7 m, a tenth of the contacts of a wall at rest changes its
/// key in every step. The impulse of a contact that is gone, as a vector, goes to the nearest new
/// contact of the same two bodies; what finds none is added to their nearest contact, so that the
/// bodies keep their sums. Rejected: the nearest contact of any bodies, which is one of another
/// brick as often as not.
#pragma once
#include <array>
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/system/state.hpp>

namespace dynamy {

class LostImpulses {
 public:
  /// Numbers that `remember` writes of each contact.
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
  /// Of the contacts of these bodies the one nearest to `point`, new ones before others; null: none.
  Contact* taker(const std::array<int, 2>& bodies, const Vec3& point, const ContactSet& contacts);
  std::vector<std::pair<ContactKey, int>> old_, now_;
  std::vector<std::array<int, 2>> kept_;   ///< contacts of the last step, and the same of this one
  std::vector<int> lost_, fresh_;          ///< contacts of the last step, of this one
  std::vector<Contact> contacts_;          ///< of pairs that lost some, sorted by bodies
  std::vector<std::array<int, 2>> pairs_;  ///< that lost some, sorted
};

}  // namespace dynamy
