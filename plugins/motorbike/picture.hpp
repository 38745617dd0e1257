/// Shapes of the vehicle: those that are only drawn, and the tyres, which also make contact.
#pragma once
#include <dynamy/system/description.hpp>
#include <dynamy/system/shape.hpp>
#include <memory>
#include <vector>

#include "geometry.hpp"

namespace dynamy::motorbike {

class Picture {
 public:
  Picture(const Geometry& data, const std::string& material, bool bicycle);
  ~Picture();
  void describe(Description& d) const;

 private:
  class Body;
  struct Placed {
    int frame;
    std::unique_ptr<Body> shape;
  };
  Body& add(int frame, std::unique_ptr<Body> shape);
  /// Adds a tube from a to b, in axes of the frame.
  void tube(int frame, const Vec3& a, const Vec3& b, double radius, const char* colour);
  void ellipsoid(int frame, const Vec3& at, const Vec3& semiAxes, double pitch, const char* colour);
  void wheel(int frame, const Wheel& wheel, const std::string& name, const std::string& material,
             bool bicycle);
  void motorbike(const Geometry& data);
  void bicycle(const Geometry& data);
  std::vector<Placed> all_;
};

}  // namespace dynamy::motorbike
