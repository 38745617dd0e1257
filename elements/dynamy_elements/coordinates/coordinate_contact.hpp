/// CoordinateContact: a contact on one system, given by formulas of its coordinates.
///
///   g(t,q):  γ_N = ġ,   W_N = ∂g/∂q,   χ_N = ∂g/∂t,   bias_N = (∂t + u·∂q)² g
///   slip directions d_k(t,q):   γ_T = d·u          or   slip velocities γ_T(t,q,u), affine in u
///
/// It works on every system that names its coordinates and has q̇ = u:
/// `<Coordinates>`, planar bodies, also those that joints carry, users' own systems. Rejected: a contact inside
/// `<Coordinates>`, which no other system could use.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/system/own_coordinates.hpp>
#include <dynamy_elements/coordinates/reservoir_switch.hpp>
#include <memory>

namespace dynamy {

class CoordinateContact final : public NonSmoothElement {
 public:
  static void declare(Attributes& a);
  explicit CoordinateContact(const Parameters& x);
  ~CoordinateContact() override;

  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void remember(const Kinematics& k, Vec memory) const override;
  void describe(Description& d) const override;

  /// Rows that the law is offered: the normal one, if there is a gap, then the tangential ones.
  int rows() const { return (gapText_.empty() ? 0 : 1) + tangents_; }

 private:
  void nameCoordinates(const PartialMechanicalSystem& system);
  void compile();
  void inputs(const Kinematics& k) const;
  double nextInstant(double t) const;
  void gapRow(const double* x, ContactRows& out, Block W) const;
  void slipRows(const double* x, int first, ContactRows& out, Block W) const;
  bool directions() const { return slipVelocityText_.empty(); }

  std::string on_;
  FormulaText gapText_, slipText_, slipVelocityText_, placeText_;
  int tangents_ = 0;
  std::unique_ptr<SetValuedForceLaw> law_;
  ReservoirSwitch switch_;
  FormulaNames names_;
  OwnCoordinates own_;
  std::vector<int> q_, u_;
  std::unique_ptr<Tape> gap_, slip_, place_;
  Vec3 normal_, along_;                // drawn directions of the first two rows, in I
  mutable std::vector<double> x_, w_;  // (t, q, u) and the direction (1, u, 0)
};

}  // namespace dynamy
