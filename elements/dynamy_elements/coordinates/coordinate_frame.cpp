#include <Eigen/Geometry>
#include <dynamy_elements/bodies/body_parts.hpp>
#include <dynamy_elements/coordinates/coordinate_frame.hpp>

namespace dynamy {

void CoordinateFrame::declare(Attributes& a) {
  a.about(
      "Point with axes on a system of Coordinates, placed by formulas of t and q. Carries "
      "shapes for the replay and for contact, and joints.");
  a.add(AttributeType::expressions, "position", "0 ; 0 ; 0",
        "position of the point in I: x ; y ; z")
      .in(Unit::length);
  a.add(AttributeType::expressions, "angle", "",
        "angles of successive rotations, each about the axes turned so far")
      .in(Unit::angle);
  a.vector("axis", Unit::none, 0, "0 0 1", "axis of each angle: 3 numbers per angle");
  a.child(Kind::shape, 0, 1000, "shapes bound to the frame");
  a.example(
      "<CoordinateFrame name=\"bob\" position=\"l*sin(phi) ; 0 ; -l*cos(phi)\" angle=\"phi\" "
      "axis=\"0 -1 0\"/>");
}

CoordinateFrame::CoordinateFrame(const Parameters& x)
    : CoordinatePart(x), position_(x, "position"), angle_(x, "angle"), shapes_(x.take<Shape>()) {
  refuseMass(shapes_, "M of the <Coordinates> says all of it");
  const Eigen::VectorXd axis = x["axis"].vector();
  if (position_.size() != 3)
    throw ModelError(position_.fault(
        -1, "expects 3 formulas x ; y ; z, has " + std::to_string(position_.size())));
  if (angle_.empty()) return;
  if (angle_.size() > static_cast<int>(kMaxRotations))
    throw ModelError(angle_.fault(-1, "a frame has at most 8 angles"));
  if (axis.size() != 3 * angle_.size())
    throw ModelError(angle_.fault(-1, "expects an axis of 3 numbers for each angle, axis has " +
                                          std::to_string(axis.size()) + " numbers"));
  for (int k = 0; k < angle_.size(); ++k) {
    const Vec3 e = axis.segment<3>(3 * k);
    if (!(e.norm() > 0.0)) throw ModelError(angle_.fault(k, "the axis of this angle is zero"));
    axes_.push_back(e.normalized());
  }
}

CoordinateFrame::~CoordinateFrame() = default;

void CoordinateFrame::compile(const FormulaNames& names, Diagnostics& faults) {
  ExpressionCompiler compiler(names.symbols());
  const std::size_t before = faults.size();
  position_.compileAll(compiler, faults);
  angle_.compileAll(compiler, faults);
  if (faults.size() > before) return;
  slots_ = names.qSlots();
  tape_ = std::make_unique<Tape>(compiler.finish(), names);
  for (int k = 0; k < tape_->set().outputCount(); ++k)
    for (const int s : names.uSlots())
      if (tape_->set().dependsOn(k, s))
        faults.add((k < 3 ? position_ : angle_)
                       .fault(k < 3 ? k : k - 3, "a frame depends on t and positions only"));
  moves_ = tape_->dependsOn(slots_);
  position_ = {}, angle_ = {};  // only messages need them; a model may have 10⁵ frames
}

void CoordinateFrame::evaluate(const double* x, const double* w, Frame& out) const {
  const int n = static_cast<int>(slots_.size()), m = 3 + static_cast<int>(axes_.size());
  using Columns = Eigen::Map<const Eigen::MatrixXd>;

  // Point: one pass gives value, velocity and second derivative along the motion.
  const double* second = tape_->second(x, w, w);
  const double* first = tape_->firstDerivative();
  const double* value = tape_->value();
  out.r_OS_I = Eigen::Map<const Vec3>(value);
  out.v_S_I = Eigen::Map<const Vec3>(first);
  out.bias_S_I = Eigen::Map<const Vec3>(second);
  out.A_IK.setIdentity();
  out.Omega_I.setZero(), out.bias_R_I.setZero(), out.nu_R_I.setZero();

  // Rotations, one after the other: Ω = Σ α̇ e, Ω̇ = Σ α̈ e + α̇ Ω_before × e.
  Vec3 e[kMaxRotations];
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    e[k] = out.A_IK * axes_[k];
    out.bias_R_I += second[3 + k] * e[k] + first[3 + k] * out.Omega_I.cross(e[k]);
    out.Omega_I += first[3 + k] * e[k];
    out.A_IK = out.A_IK * Eigen::AngleAxisd(value[3 + k], axes_[k]).toRotationMatrix();
  }

  // Jacobians by columns, and the velocities that depend on time alone.
  out.block = moves_ ? 0 : -1;
  if (moves_) {
    const Columns J(tape_->gradient(x, slots_), m, n);
    for (int j = 0; j < n; ++j) {
      out.J_S_I.col(j) = J.col(j).head<3>();
      out.J_R_I.col(j).setZero();
      for (std::size_t k = 0; k < axes_.size(); ++k)
        out.J_R_I.col(j) += J(3 + static_cast<int>(k), j) * e[k];
    }
  }
  const double* rate = tape_->partial(x, FormulaNames::kTime);
  out.nu_S_I = Eigen::Map<const Vec3>(rate);
  for (std::size_t k = 0; k < axes_.size(); ++k) out.nu_R_I += rate[3 + k] * e[k];
}

}  // namespace dynamy
