/// Held: the status of one contact that is held during a phase, or of a part of a contact. The
/// first part has the normal and sliding rows, later parts those of rolling or spinning.
#pragma once
#include <array>
#include <dynamy/core/number_archive.hpp>
#include <dynamy/core/types.hpp>
#include <dynamy/law/most_rows.hpp>
#include <vector>

namespace dynamy {

/// Index of the element that reports the contact with this key.
inline int elementOf(ContactKey key) { return static_cast<int>(key.value >> 40); }

/// Names the rows of a contact that have a status of their own: those from `first` on.
struct HeldKey {
  ContactKey key;
  int first = 0;
  bool operator==(const HeldKey& other) const = default;
};

struct Held {
  /// A slip slower than this has the direction that was decided [m/s]. The error of friction that
  /// depends on the slip is its slope times this speed.
  static constexpr double kLeastSlip = 1e-12;
  ContactKey key;
  int first = 0, rows = 0;  ///< first row within the contact, and number of rows; 0: all
  bool slips = false;       ///< slides; for a set on a displacement x: x is not zero, or leaves it
  double sign = 0.0;        ///< sign of γ_T where slip has one direction; sign of x
  /// True: a slip in several rows has just begun, and γ_T is too small to have a direction. The
  /// slip then has the direction of γ̇_T, by an inclusion on acceleration level (theory 20.6).
  bool starts = false;
  double turned = 0.0;  ///< ∫ |γ_T| dθ over the turning direction since the slip started [m/s]
  std::array<double, kMostRows - 1> direction{
      1.0};                  ///< as decided; while the slip starts: the present direction
  double mutedUntil = -1.0;  ///< time until which its force and slip are ignored [s]
  double weight = 1.0;       ///< weight of its forces in redundant rows: λ_N of the decision [N]
  std::array<double, kMostRows> lambda{};  ///< as the last decision gave them [N]
  int implied = 0;  ///< bit r: row first + r follows from others that are held
  void archive(NumberArchive& a) {
    a(key), a(first), a(rows), a(slips), a(sign), a(starts), a(turned), a(direction);
    a(mutedUntil), a(weight), a(lambda), a(implied);
  }
};

/// The first part of `held` that belongs to contact `key`; null: the contact is not held.
const Held* findHeld(const std::vector<Held>& held, ContactKey key);
/// The part with this key; null: it is not held.
const Held* findHeld(const std::vector<Held>& held, HeldKey part);
/// Appends the keys of all held contacts to `out` and sorts it.
void heldKeys(const std::vector<Held>& held, std::vector<ContactKey>& out);

}  // namespace dynamy
