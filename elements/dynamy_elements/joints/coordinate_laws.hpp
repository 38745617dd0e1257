/// Inclusions (set-valued laws) in one joint coordinate x:                          (theory 40.4)
///
///   JointStop      g = x − lower ≥ 0,  g = upper − x ≥ 0     unilateral laws
///   JointDrive     g = x − motion(t) = 0                     bilateral: χ = −motion′(t)
///   JointMotor     γ = ẋ − speed(t)                          held while |force| < limit
///   JointFriction  γ = ẋ                                     any law that always acts
#pragma once
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/joints/joint_coordinate.hpp>
#include <dynamy_elements/laws/force_limit.hpp>
#include <dynamy_elements/signal_formulas.hpp>
#include <dynamy_elements/time_formulas.hpp>
#include <memory>

namespace dynamy {

/// Base of the elements with one joint coordinate.
class CoordinateLaw : public NonSmoothElement {
 public:
  explicit CoordinateLaw(const Parameters& x) : NonSmoothElement(x), coordinate_(x) {}
  void connect(Topology& topology) override { coordinate_.connect(topology, *this); }
  void remember(const Kinematics& k, Vec memory) const final { coordinate_.remember(k, memory); }

 protected:
  const JointCoordinate& coordinate() const { return coordinate_; }
  /// For describeContact().
  AngularRows angularRow() const { return coordinate_.isAngle() ? kAllAngular : 0U; }
  void hasUnits(const Parameters& x, const char* name, Unit ofAngle, Unit ofDisplacement) {
    coordinate_.hasUnits(x, name, ofAngle, ofDisplacement);
  }

 private:
  JointCoordinate coordinate_;
};

class JointStop final : public CoordinateLaw {
 public:
  static void declare(Attributes& a);
  explicit JointStop(const Parameters& x);
  bool isMirrored(const MirrorPlane& plane) const override {
    return coordinate().isMirrored(plane, *this) && law_->isMirrored(plane);
  }
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;
  std::string contactName(std::uint64_t id) const override { return id == 0 ? "lower" : "upper"; }

 private:
  double lower_, upper_;
  std::unique_ptr<SetValuedForceLaw> law_;
};

class JointDrive final : public CoordinateLaw {
 public:
  static void declare(Attributes& a);
  explicit JointDrive(const Parameters& x);
  bool isMirrored(const MirrorPlane& plane) const override {
    return coordinate().isMirrored(plane, *this);
  }
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;

 private:
  TimeFormulas motion_;
  Bilateral bilateral_;
};

/// The force of a drive: a ForceLimit whose work on the bodies is that of a drive.
class DriveForce final : public ForceLimit {
 public:
  using ForceLimit::ForceLimit;
  RowKind rowKind(int) const override { return RowKind::drive; }
};

class JointMotor final : public CoordinateLaw {
 public:
  static void declare(Attributes& a);
  explicit JointMotor(const Parameters& x);
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;

 private:
  TimeFormulas speed_;  // without signals
  SignalFormulas speedOfSignals_, speedRate_, scale_;
  DriveForce law_;
};

class JointFriction final : public CoordinateLaw {
 public:
  static void declare(Attributes& a);
  explicit JointFriction(const Parameters& x);
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;

 private:
  std::unique_ptr<SetValuedForceLaw> law_;
  SignalFormulas scale_;
};

}  // namespace dynamy
