/// Islands: which systems act on each other at present, and which do not.
///
/// Joined for good are the systems that one force or one contact element asked for by name; shapes
/// that touch are joined contact by contact. Whoever asked for nothing (gravity) joins nothing.
/// A system is one island however many blocks it has: nobody says that they do not act on each
/// other.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class Islands {
 public:
  /// Those of forces and named elements. False: they are not known, since an element asked for
  /// nothing and reports contacts all the same.
  bool start(const SystemParts& parts);
  /// Systems with a contact between them are one island.
  void join(const ContactSet& c, int contact);
  /// Number of the island of a system.
  int of(int system) const;
  /// The first system with velocities in a contact, −1: none.
  int systemOf(const ContactSet& c, int contact) const;
  /// The system of velocity i.
  static int systemOfVelocity(const Topology& topology, int i);
  /// Flags of single systems (not 0) go over to their islands.
  void spread(std::vector<char>& systems) const;

 private:
  void join(int a, int b);
  mutable std::vector<int> parent_;
  std::vector<int> systemOfBlock_;
};

}  // namespace dynamy
