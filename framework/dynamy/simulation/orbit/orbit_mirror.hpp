/// OrbitMirror: the symmetry S of a motion that repeats itself mirrored after half a period:
///
///   x(t + T/2) = S x(t),   S S = 1
///
/// S changes the signs of some coordinates and exchanges others. Rejected: any map as formulas; it
/// would have to be checked for S S = 1.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/orbit/orbit_section.hpp>

namespace dynamy {

class OrbitMirror {
 public:
  /// Throws ModelError for unknown names, and for coordinates that are named twice.
  OrbitMirror(const Model& model, const std::vector<std::string>& of);
  bool any() const { return !of_.empty(); }
  /// S x.
  State operator()(const State& x) const;
  /// The section through which the mirrored motion passes when the motion passes `section`.
  OrbitSection operator()(const OrbitSection& section) const;

 private:
  /// A number of q (or u) that becomes `sign` times number `from`.
  struct Part {
    std::string name;
    bool velocity = false;
    Eigen::Index to = 0, from = 0;
    std::string fromName;
    double sign = -1.0;
  };
  std::vector<Part> of_;
};

}  // namespace dynamy
