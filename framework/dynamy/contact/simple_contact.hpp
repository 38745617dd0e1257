/// SimpleContact: the short way to write a contact on ONE system. The class gives g and γ; W and χ
/// follow exactly, because γ is affine in u:
///
///   χ = γ(t, q, 0),   W e_j = γ(t, q, e_j) − χ.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/system/own_coordinates.hpp>
#include <memory>

namespace dynamy {

class SimpleContact : public NonSmoothElement {
 public:
  /// Attributes all simple contacts have: `on` (the system) and a law as child (default: Unilateral
  /// with ε_N = 0). The model loader adds them to what the class itself declares.
  static void declareCommon(Attributes& a);
  explicit SimpleContact(const Parameters& x);
  ~SimpleContact() override;

  /// Gap [m] (unilateral laws) or position error (joints).
  virtual double g(double t, ConstVec q) const = 0;
  /// Relative velocities, `rows()` entries, affine in u: normal first, γ_N = ġ, then tangential
  /// ones [m/s].
  virtual void gamma(double t, ConstVec q, ConstVec u, Vec gamma) const = 0;
  /// Number of rows that gamma() fills: 1 without friction, 2 planar, 3 spatial.
  virtual int rows() const { return 1; }

  /// For the replay: the point of contact and the directions of its rows, N first, in I. A contact
  /// is not drawn if drawnAt() returns false.
  struct DrawnPlace {
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero(), t1 = Vec3::Zero();  ///< [m], [–], [–]
  };
  virtual bool drawnAt(double, ConstVec, DrawnPlace&) const { return false; }

  /// Exact d(Wᵀ)/dt u + dχ/dt, rows() entries [m/s²]; false: the framework takes a 4-point
  /// difference along the motion (needs q̇ = u).
  virtual bool bias(const Kinematics&, Vec) const { return false; }

  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;

 protected:
  const SetValuedForceLaw& law() const { return *law_; }

 private:
  void addBias(const Kinematics& k, ContactRows& out, int dim) const;
  std::string on_;
  std::unique_ptr<SetValuedForceLaw> law_;
  OwnCoordinates own_;
};

}  // namespace dynamy
