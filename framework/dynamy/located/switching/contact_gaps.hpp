/// ContactGaps: gaps and relative velocities of all contacts at one state, open ones as well.
#pragma once
#include <dynamy/contact/contact_set.hpp>

namespace dynamy {

struct ContactGaps {
  ContactSet contacts;
  Eigen::VectorXd gammas;  ///< γ, row after row [m/s]

  /// γ with the velocities u.
  void evaluateGammas(const Eigen::VectorXd& u);
  int size() const { return contacts.size(); }
  ContactKey key(int i) const { return contacts.key[static_cast<std::size_t>(i)]; }
  /// Index of the contact with this key, or −1.
  int find(ContactKey key) const;
  const SetValuedForceLaw& law(int i) const { return *contacts.law[static_cast<std::size_t>(i)]; }
  int row0(int i) const { return contacts.row0[static_cast<std::size_t>(i)]; }
  /// Gap of a unilateral contact [m].
  double gap(int i) const { return contacts.position[static_cast<std::size_t>(row0(i))]; }
  /// γ of row r of contact i [m/s].
  double gamma(int i, int r = 0) const { return gammas[row0(i) + r]; }
  /// Positive while the features of contact i lie over one another [m].
  double presence(int i) const { return contacts.features.presence[static_cast<std::size_t>(i)]; }
  /// True: some contacts come and go.
  bool comeAndGo() const { return contacts.features.comeAndGo; }
  bool comesAndGoes(int i) const { return presence(i) < FollowedFeatures::kAlways; }
  /// True: contact i is the lowest point of a circle that is tilted little.
  bool isOnCircle(int i) const { return contacts.features.isOnCircle(i); }
  /// True: contacts i and j, which come and go, are at one place with one normal.
  bool coincide(int i, int j, double distance) const;
  /// Takes gap, presence and γ of contact i from contact j of `other`; false: it has other rows.
  bool take(int i, const ContactGaps& other, int j);
};

}  // namespace dynamy
