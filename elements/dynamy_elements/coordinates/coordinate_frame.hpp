/// CoordinateFrame: a point with axes whose place is given by formulas of t and q.
///
///   r_OS = r(t, q),   A_IK = R(e₁, α₁(t,q)) R(e₂, α₂(t,q)) …
///   J_S = ∂r/∂q,  ν_S = ∂r/∂t,  β_S = (∂t + u·∂q)² r,   the same for the angles        (exact)
///
/// A formula for each entry of a rotation matrix was rejected: nine formulas would have to agree.
#pragma once
#include <dynamy/system/frame.hpp>
#include <dynamy/system/shape.hpp>
#include <dynamy_elements/coordinates/coordinate_part.hpp>
#include <dynamy_elements/coordinates/formula_text.hpp>
#include <memory>

namespace dynamy {

class CoordinateFrame final : public CoordinatePart {
 public:
  static void declare(Attributes& a);
  explicit CoordinateFrame(const Parameters& x);
  ~CoordinateFrame() override;
  CoordinateFrame* frame() override { return this; }

  /// Compiles the formulas for a system with these names; faults go to `faults`.
  void compile(const FormulaNames& names, Diagnostics& faults);
  /// Fills `out` at x = (t, q, u); w = (1, u, 0) is the direction of the motion.
  void evaluate(const double* x, const double* w, Frame& out) const;

  /// First instant after t at which a formula jumps or has a kink [s].
  double nextInstant(double t) const { return tape_->nextInstant(t); }

  const std::vector<std::unique_ptr<Shape>>& shapes() const { return shapes_; }

 private:
  static constexpr std::size_t kMaxRotations = 8;
  FormulaText position_, angle_;
  std::vector<Vec3> axes_;
  std::vector<std::unique_ptr<Shape>> shapes_;
  std::vector<int> slots_;
  std::unique_ptr<Tape> tape_;  // x, y, z, angles
  bool moves_ = true;
};

}  // namespace dynamy
