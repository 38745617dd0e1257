/// SheaveRope: a massless, inextensible rope from P on A over a sheave to Q on B.   (theory 42.5)
///
///   e_P = P − C = r n + l t + h a,   L = √(l² + h²) = √(|e_P|² − r²),   and the same for Q
///   slack   g = length − L_P − L_Q − r θ,   γ_N = −p_P − p_Q,   p = w·ė + m·Ω
///   slip    γ_T = ½ (p_Q − p_P)
///   w = (l t + h a)/L − r (1/l − 1/L) n,    m = (r/l) e × n
///
/// with the centre C of the sheave of radius r, its axis a and its Ω; n from C to where the strand
/// leaves it, t ⊥ n the strand's direction in the plane of the sheave, h what the end lies beside that
/// plane, θ the angle of wrap. p is the rate at which rope comes off on a side: in the plane t·ė and
/// ∓r a·Ω. Λ_N is the mean of the rope forces S1, S2, and Λ_T = S1 − S2. The law BeltFriction limits
/// Λ_T; a law without friction lets the rope run freely. Where θ would be negative, the rope has left
/// the sheave and runs straight from P to Q: g = length − |PQ|. Between planar bodies h = 0.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <memory>

namespace dynamy {

class SheaveRope final : public NonSmoothElement {
 public:
  static void declare(Attributes& a);
  explicit SheaveRope(const Parameters& x);
  ~SheaveRope() override;
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;

 private:
  /// One strand of the rope: from the sheave with the centre C to the point where the strand ends.
  struct Strand {
    Vec3 rho_I, e, n, t;            ///< lever arm on its body; e, n, t of above
    Vec3 w, m;                      ///< p = w·ė + m·Ω  [–, m]
    double inPlane, aside, length;  ///< l, h, L [m]; l = 0: the end lies within the sheave
  };
  /// `turn`: sense about the axis in which t is n turned by a right angle.
  Strand strand(const Frame& body, const Vec3& point, const Frame& sheave, const Vec3& axis_I,
                double turn) const;
  double wrap(const Strand& a, const Strand& b, const Vec3& axis_I, double sense) const;
  void chooseSense(const Frame& A, const Frame& B, const Frame& S, const Vec3& axis_I);
  void bias(ContactRows& out, const Kinematics& k, const Strand& a, const Strand& b) const;
  void straight(const Frame& A, const Strand& a, const Frame& B, const Strand& b,
                ContactSink& sink) const;
  double biasOf(const Frame& body, const Frame& sheave, const Strand& s) const;
  void drawStrands(Description& d) const;
  /// Force of a strand in the last step: sign +1 on A, −1 on B  [N].
  static double force(const SignalView& v, double sign);

  FramePair frames_;
  Vec3 pointA_, pointB_, axis_, side_;
  std::string sheaveName_, carrierName_;
  FrameHandle sheave_, carrier_;
  double radius_, length_, breaksAt_;
  int turns_;
  static constexpr std::uint64_t kStraight = 1;  // number of the contact beside the sheave
  std::unique_ptr<SetValuedForceLaw> law_;
  Unilateral free_{0.0};
  Vec3 axis_S_ = Vec3::Zero();        // in axes of the sheave
  double sense_ = 1.0, wrap0_ = 0.0;  // σ, θ at the start
  bool flat_ = false;                 // planar bodies: places across their plane mean nothing
  Vec3 drawn_[2];                     // T1, T2 at the start, in axes of the carrier
};

}  // namespace dynamy
