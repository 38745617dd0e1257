/// SheaveRope: a massless, inextensible rope from P on A over a sheave to Q on B.   (theory 42.5)
///
///   T1, T2 where the strands touch the sheave of radius r and centre C, θ the angle of wrap:
///   slack   g = l − |T1P| − |T2Q| − r θ,      γ_N = −t1·(v_P − v_C) − t2·(v_Q − v_C)
///   slip    γ_T = ½ (t2·(v_Q − v_C) − t1·(v_P − v_C)) − σ r ω
///
/// with t1 = T1P/|T1P|, t2 = T2Q/|T2Q| and σ = ±1 the sense about the axis in which the
/// rope runs from A to B. Λ_N is the mean of the rope forces S1, S2, and Λ_T = S1 − S2. The
/// law BeltFriction limits Λ_T; a law without friction lets the rope run freely. All
/// vectors are in the plane of the sheave.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
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
    Vec3 rho_I, n, t;  ///< lever arm on its body, direction C → T, direction T → end
    double length;     ///< of the free part [m]
  };
  /// `turn`: sense about the axis in which t is n turned by a right angle.
  Strand strand(const Frame& body, const Vec3& point, const Frame& sheave, const Vec3& axis_I,
                double turn) const;
  double wrap(const Strand& a, const Strand& b, const Vec3& axis_I, double sense) const;
  void chooseSense(const Frame& A, const Frame& B, const Frame& S, const Vec3& axis_I);
  void bias(ContactRows& out, const Kinematics& k, const Strand& a, const Strand& b) const;
  void drawStrands(Description& d) const;
  /// Force of a strand in the last step: sign +1 on A, −1 on B  [N].
  static double force(const SignalView& v, double sign);

  FramePair frames_;
  Vec3 pointA_, pointB_, axis_, side_;
  std::string sheaveName_, carrierName_;
  FrameHandle sheave_, carrier_;
  double radius_, length_, breaksAt_;
  int turns_;
  std::unique_ptr<SetValuedForceLaw> law_;
  Vec3 axis_S_ = Vec3::Zero();        // in axes of the sheave
  double sense_ = 1.0, wrap0_ = 0.0;  // σ, θ at the start
  Vec3 drawn_[2];                     // T1, T2 at the start, in axes of the carrier
};

}  // namespace dynamy
