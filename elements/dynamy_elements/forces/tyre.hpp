/// Tyre: the forces between a wheel and a road, with a carcass that yields:             (theory 41.4)
///
///   δ = ρ − n·(r_c − r_o)          r_c: lowest point of the circle of radius R − ρ on the wheel
///   N = max(0, C_z δ + d δ̇)  for δ > 0
///
///   σ_x ṡ_x = −v_sx − V s_x,   σ_y ṡ_y = −v_sy − V (s_y + (c_γ/c_α) γ)
///   p = (c_κ (s_x + τ ṡ_x), c_α (s_y + τ ṡ_y))/μ,      (F_x, F_y) = μ N g(|p|) p/|p|
///   g(p) = sin(C atan(B p − E (B p − atan B p))),  B = 1/C
///   t = t_0 cos(C_t atan(B_t |p|)),   F_y acts t behind the contact
///
/// [Pacejka, Tire and Vehicle Dynamics: transient slips with relaxation lengths, magic formula,
/// similarity of both directions]. v_s: velocity of the wheel's material at the contact, V: speed at
/// which the contact travels, γ: camber. The slips s are of size 1, so that the error control counts
/// them like velocities of the scene. At rest they are the deflection of the carcass over σ: a
/// standing wheel holds its place, and no force jumps at V = 0. The set-valued law of Coulomb on a
/// torus is the limit of stiff carcass and tread (UnilateralCoulomb).
///
/// On a road z = h(x, y) that is not flat, n and r_o are those of the tangent plane at the point of
/// the road that is nearest to r_c: (r_c − r_o)·∂r_o/∂x = (r_c − r_o)·∂r_o/∂y = 0. Since the gap is
/// stationary there, its rate is that of the flat road.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

class Tyre final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit Tyre(const Parameters& x);
  std::unique_ptr<PartialMechanicalSystem> ownSystem() const override;
  void connect(Topology& topology) override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const override;
  void describe(Description& d) const override;

 private:
  /// The plane that the wheel rolls on, in the axes of I.
  struct Road {
    Vec3 n, r_o;
  };
  /// Where wheel and road meet, in the axes of I.
  struct Meeting {
    Vec3 n, ex, ey;          ///< normal of the road, directions along and across the wheel
    Vec3 rho;                ///< lever arm of the contact on the wheel [m]
    double delta, deltaDot;  ///< deflection [m], its rate [m/s]
    double gamma;            ///< camber [rad], positive if the wheel's top leans to −ey
    double V, Vx;            ///< speed of the contact, its part along the wheel [m/s]
    double vsx, vsy;         ///< velocity of the wheel's material there [m/s]
  };
  /// Forces on the wheel, and rates of both slips.
  struct Forces {
    double N = 0.0, Fx = 0.0, Fy = 0.0, trail = 0.0;  ///< [N], [m]
    double rate[2] = {0.0, 0.0};                      ///< [1/s]
  };
  Vec3 crown(const Vec3& axle, const Vec3& n) const;
  Road road(const Kinematics& k) const;
  Meeting meeting(const Kinematics& k) const;
  Forces forces(const Kinematics& k, const Meeting& m) const;
  double curve(double p) const;
  FramePair frames_;
  SystemHandle state_;
  SignalFormulas height_;
  Vec3 axis_, normal_;
  double radius_, tube_, stiffness_, damping_, mu_;
  double longitudinal_, cornering_, camber_, slipDamping_, trail_;
  Eigen::Vector2d relaxation_, shape_, trailShape_;
};

}  // namespace dynamy
