/// How deep the bodies of a model start inside each other, as a share of their sizes.
///
///   share = max over closed unilateral contacts of −g / s,   s the smaller of the moving bodies
///
/// The size of a shape is its smallest extent (a ball: diameter, a plate: thickness), that of a
/// body the largest of its shapes in contact. Fixed bodies do not count, and half spaces have no
/// size. Rejected: the length of the scene as the measure, because a marble could sink into the
/// floor of a hall without a report.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

struct StartOverlap {
  double depth = 0.0;  ///< −g [m]
  double size = 0.0;   ///< s [m]; 0: no bodies with a size overlap
  ContactKey contact;
  ContactKey joint = kNoContact;  ///< a joint between the two bodies
  double share() const { return size > 0.0 ? depth / size : 0.0; }
};

/// The contact with the largest share; `start`: the contacts of the initial state.
StartOverlap startOverlap(const Model& model, const ContactSet& start);

/// Size of the smallest moving body that can touch others [m]; infinite: no such body has a size.
double smallestBody(const Model& model);

/// Smallest extent of a shape [m], 0 for points, lines, half spaces and other shapes without
/// volume.
double thickness(const ShapeGeometry& shape);

}  // namespace dynamy
