/// Couplings of joint coordinates:  g = Σ a_k (x_k − x_k(0)) = 0,  or a law on γ = Σ a_k ẋ_k.
///                                                                                 (theory 40.6)
///   Gear           φ_A − i φ_B                 angles against a carrier
///   RackAndPinion  z − r φ
///   Rope           L − Σ l_k                   distances of the points it runs through
///
/// Rejected: couplings that refer to joints by name. A gear could then not act between bodies of a
/// tree, where a joint is no element.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/joints/joint_coordinate.hpp>
#include <memory>
#include <string>
#include <vector>

namespace dynamy {

class Coupling : public NonSmoothElement {
 public:
  explicit Coupling(const Parameters& x);
  void connect(Topology& topology) final;
  void contacts(const Kinematics& k, ContactSink& sink) const final;
  void remember(const Kinematics& k, Vec memory) const final;
  void describe(Description& d) const override;

 protected:
  static void declareLaw(Attributes& a, const std::string& text);
  /// Adds the coordinates; frames are obtained from frame().
  virtual void build(Topology& topology) = 0;
  FrameHandle frame(Topology& topology, const std::string& name);
  /// Normal of the plane in which the frames requested so far move; zero: none.
  const Vec3& plane() const { return plane_; }
  void add(const CoordinateRow& row, double factor) { parts_.push_back({row, factor}); }
  void constant(double g0) { constant_ = g0; }
  /// Σ a_k x_k of the coordinates.
  double sum(const Kinematics& k) const;
  const SetValuedForceLaw& law() const { return *law_; }

 private:
  struct Part {
    CoordinateRow row;
    double factor;
  };
  std::unique_ptr<SetValuedForceLaw> law_;
  bool placed_ = false;  // the force of the law depends on the position
  std::vector<Part> parts_;
  double constant_ = 0.0;
  Vec3 plane_ = Vec3::Zero();
  bool planeKnown_ = false, moves_ = false;
  MemoryHandle memory_;
  mutable std::vector<RateTerm> terms_;  // scratch
};

class Gear final : public Coupling {
 public:
  static void declare(Attributes& a);
  explicit Gear(const Parameters& x);

 private:
  void build(Topology& topology) override;
  std::string a_, b_, carrier_;
  Vec3 axisA_, axisB_;
  double ratio_;
};

class RackAndPinion final : public Coupling {
 public:
  static void declare(Attributes& a);
  explicit RackAndPinion(const Parameters& x);

 private:
  void build(Topology& topology) override;
  std::string pinion_, rack_, carrier_;
  Vec3 axis_, direction_;
  double radius_;
};

class Rope final : public Coupling {
 public:
  static void declare(Attributes& a);
  explicit Rope(const Parameters& x);
  void describe(Description& d) const override;

 private:
  void build(Topology& topology) override;
  std::vector<std::string> names_;
  std::vector<Vec3> points_;
  std::vector<FrameHandle> frames_;
  double length_ = 0.0;
};

}  // namespace dynamy
