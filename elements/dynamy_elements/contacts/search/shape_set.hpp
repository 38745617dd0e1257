/// ShapeSet: all shapes of a model that have a material, in space and as sections in each plane of
/// motion, and the bodies that carry them.
///
/// Shape i is the same in all lists. Its place is in the axes of the frame that carries it, so that
/// nothing here changes after the model is built.
#pragma once
#include <dynamy_elements/contacts/shapes/contour.hpp>
#include <dynamy_elements/contacts/shapes/polyhedron.hpp>
#include <dynamy_elements/contacts/shapes/surface.hpp>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <limits>
#include <map>
#include <memory>

namespace dynamy {

class ShapeSet {
 public:
  ShapeSet() = default;
  ShapeSet(std::vector<ShapeInstance> instances, const Topology& topology,
           const StartKinematics& start);

  std::size_t size() const { return instances_.size(); }
  const std::vector<TouchingShape>& inSpace() const { return shapes_[0]; }
  /// The shapes in plane of motion number p; 0: in space.
  const std::vector<TouchingShape>& in(std::size_t p) const { return shapes_[p]; }
  const Vec3& plane(std::size_t p) const { return planes_[p]; }  ///< its normal, zero in space
  /// Number of a plane of motion; makes the sections of all shapes in it if it is new.
  std::size_t planeNumber(const Vec3& normal, const StartKinematics& start);

  const ShapeInstance& instance(std::size_t i) const { return instances_[i]; }
  /// Shapes of one body never touch.
  int body(std::size_t i) const { return body_[i]; }
  /// The shape's name, else that of its system; with a number if it is not the first of this name.
  const std::string& name(std::size_t i) const { return names_[i]; }
  /// Number of the ground that carries the shape, −1: none.
  int ground(std::size_t i) const { return ground_[i]; }
  /// Names of systems without velocities.
  const std::vector<std::string>& grounds() const { return grounds_; }
  /// Distance at which a shape of few is reported [m].
  double early(std::size_t i) const { return early_[i]; }
  const std::vector<int>& halfSpaces() const { return halfSpaces_; }
  double thinnest() const { return thinnest_; }  ///< least thickness of all shapes [m]

 private:
  void makeSurfaces();
  void nameShape(std::size_t i, const std::string& carrier, std::map<std::string, int>& times);

  std::vector<ShapeInstance> instances_;
  std::vector<Vec3> planes_;                        ///< the first is zero: space
  std::vector<std::vector<TouchingShape>> shapes_;  ///< per plane
  std::vector<std::unique_ptr<const Surface>> surfaces_;
  std::vector<std::unique_ptr<const Polyhedron>> polyhedra_;
  std::vector<std::unique_ptr<const Contour>> contours_;
  std::vector<int> body_, ground_;  ///< per shape
  std::vector<std::string> names_;  ///< per shape
  std::vector<std::string> grounds_;
  std::vector<double> early_;  ///< per shape
  std::vector<int> halfSpaces_;
  double thinnest_ = std::numeric_limits<double>::infinity();
};

}  // namespace dynamy
