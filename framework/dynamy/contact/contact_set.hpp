/// ContactSet: all contacts of one evaluation as a struct of arrays.
///
/// Candidates (every reported gap): key, g, element, closed index. Closed contacts, i = 0 …
/// size()−1: law, rows row0[i] … row0[i+1]−1, segments segment0[i] … segment0[i+1]−1. A segment
/// holds the dim × nu part of Wᵀ that belongs to one mass block, row after row, so that M⁻¹w is
/// local. A contact is ONE block, never three rows tied by position.
#pragma once
#include <dynamy/contact/contact_places.hpp>
#include <dynamy/contact/followed_features.hpp>
#include <dynamy/law/set_valued_force_law.hpp>
#include <span>
#include <vector>

namespace dynamy {

struct Segment {
  int block = -1;  ///< mass block
  int u0 = 0;      ///< first velocity of the block
  int nu = 0;
  std::ptrdiff_t w = 0;  ///< offset of the dim × nu entries in `W`
};

class ContactSet {
 public:
  // Candidates, in the order of emission.
  std::vector<ContactKey> candidateKey;
  std::vector<double> g;  ///< gap [m]; joints: norm of the position error
  std::vector<int> candidateElement;
  std::vector<int> closedIndex;  ///< −1: open

  // Closed contacts.
  std::vector<ContactKey> key;
  std::vector<const SetValuedForceLaw*> law;
  std::vector<int> element;         ///< index of the emitting element
  std::vector<int> candidate;       ///< index of the contact among the candidates
  std::vector<int> row0, segment0;  ///< size() + 1 entries
  std::vector<Segment> segment;
  std::vector<double> W;     ///< the segments' entries of Wᵀ
  std::vector<double> chi;   ///< per row: γ = Wᵀu + χ [m/s]
  std::vector<double> bias;  ///< per row: γ̇ = Wᵀu̇ + bias [m/s²]; only if requested
  /// Per row: the position whose rate is γ, and which the constraint keeps at zero or above [m].
  /// It is the gap in a normal row, the signed position error in a joint row, 0 in other rows.
  std::vector<double> position;
  std::vector<double> scale;  ///< per contact: factor on the set of its law; empty: 1
  ContactPlaces places;       ///< per contact
  FollowedFeatures features;  ///< pairs of features that are followed one by one

  int size() const { return static_cast<int>(law.size()); }
  int rows() const { return row0.empty() ? 0 : row0.back(); }
  int dim(int i) const {
    return row0[static_cast<std::size_t>(i) + 1] - row0[static_cast<std::size_t>(i)];
  }
  void clear();
  /// Input for the law of closed contact i. gammaA: relative velocities of all rows at the
  /// beginning of the step; null: not known.
  LawInput input(int i, double dt, const double* gammaA) const {
    const auto at = static_cast<std::size_t>(i);
    const std::ptrdiff_t first = row0[at];
    return {dim(i), dt, gammaA ? gammaA + first : kZeroRows.data(),
            position.empty() ? kZeroRows.data() : position.data() + first,
            scale.empty() ? 1.0 : scale[at]};
  }
  /// γ = Wᵀu + χ, rows() entries.
  void gamma(ConstVec u, Vec gamma) const;
  /// sum += |Wᵀ| v, rows() entries. For v ≥ |u| the rounding of Wᵀu is measured by this sum.
  void addAbsolute(ConstVec v, double* sum) const;
  /// Index of the closed contact of element `element` with number `id`, or −1.
  int find(int element, std::uint64_t id) const;
};

/// Key of contact `id` (< 2^40) of contact element number `element`.
inline ContactKey contactKey(int element, std::uint64_t id) {
  return {(static_cast<std::uint64_t>(element) << 40) | id};
}
/// Number of the contact with this key within its element.
inline std::uint64_t contactNumber(ContactKey key) {
  return key.value & ((std::uint64_t{1} << 40) - 1);
}

}  // namespace dynamy
