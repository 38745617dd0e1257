/// Contacts for simulations that follow gaps (theory 50.9, 50.11): pairs of features of boxes,
/// polyhedra and polygons one by one, and pairs of shapes that are noted before they touch.
#pragma once
#include <dynamy_elements/contacts/kernels/pair_report.hpp>
#include <dynamy_elements/contacts/pairs/capsule_features.hpp>
#include <dynamy_elements/contacts/pairs/disc_features.hpp>
#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>
#include <dynamy_elements/contacts/pairs/two_discs.hpp>

namespace dynamy {

/// Reports the pairs of features of two bodies that are requested by key, and notes those that may
/// touch within the time that is looked ahead.
void followFeatures(PairReport& report, const PlacedPolyhedron& a, const PlacedPolyhedron& b);
void followFeatures(PairReport& report, const PlacedPolygon& a, const PlacedPolygon& b);
void followFeatures(PairReport& report, const CapsuleFeatures& pairs);
void followFeatures(PairReport& report, const TwoCapsules& pairs);
void followFeatures(PairReport& report, const DiscFeatures& pairs);
void followFeatures(PairReport& report, const TwoDiscs& pairs);

/// Reports the contacts of the pair if some of them are requested by key, and notes its contacts if
/// they may close. Of a pair whose contacts jump exactly those that are requested are reported, also
/// as absent (ContactRequest::absent), and its overlap.
void watch(PairReport& report);

/// A rim over a half space is followed as its lowest point, and, where it lies flat, as four of its
/// points: notes those that may touch within the time that is looked ahead.
void noteFlat(PairReport& report, const OverHalfSpace& over);

}  // namespace dynamy
