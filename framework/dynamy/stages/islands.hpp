/// Islands: which systems act on each other at present, and which do not.
///
/// Systems that one force or one contact element has requested by name are joined for the whole
/// run. Shapes that touch join their systems contact by contact. An element that has requested no
/// system (gravity) joins nothing. A system is in one island however many blocks it has, since
/// nothing states that its blocks do not act on each other.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class Islands {
 public:
  /// Begins with the islands of forces and named elements. False: they are not known, since an
  /// element has requested no system and reports contacts all the same.
  bool start(const SystemParts& parts);
  /// False: a force may couple systems that it has not requested by name (ExternalForce::mayCouple).
  static bool forcesAreKnown(const SystemParts& parts);
  /// Joins the systems of a contact into one island.
  void join(const ContactSet& c, int contact);
  /// Joins the islands of two systems.
  void join(int a, int b);
  /// Number of the island of a system.
  int of(int system) const;
  /// The first system with velocities in a contact, −1: none.
  int systemOf(const ContactSet& c, int contact) const;
  /// The system of velocity i.
  static int systemOfVelocity(const Topology& topology, int i);
  /// Extends flags (not 0) of single systems to all systems of their islands.
  void spread(std::vector<char>& systems) const;

 private:
  mutable std::vector<int> parent_;
  std::vector<int> systemOfBlock_;
};

}  // namespace dynamy
