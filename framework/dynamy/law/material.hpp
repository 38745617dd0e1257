/// Values of single materials, and the rule by which the values of two materials mix.
///
///   min        min(a, b)      the slippery one decides
///   max        max(a, b)      the rough one decides
///   mean       (a + b)/2
///   geometric  √(a b)
///   product    a b            equal values give their square
///
/// No mixing rule follows from the physics of surfaces, because friction is a property of pairs.
/// Hence values mix only if the model names a rule, and a law given for the pair takes precedence.
#pragma once
#include <dynamy/law/contact_rule.hpp>

namespace dynamy {

/// Coefficients of contact [–].
struct ContactValues {
  double mu = 0.0, epsilonN = 0.0, epsilonT = 0.0;
};

/// `<Material name="rubber" mu="0.8" epsilonN="0.5"/>`.
class Material final : public MaterialRule {
 public:
  explicit Material(const Parameters& x);
  static void declare(Attributes& a);
  void enter(PairLaws& laws) const override;
  bool isMirrored(const MirrorPlane&) const override { return true; }
  const ContactValues& values() const { return values_; }

 private:
  ContactValues values_;
};

/// `<Contacts mixing="min"/>`.
class MixingRule final : public MaterialRule {
 public:
  explicit MixingRule(const Parameters& x);
  static void declare(Attributes& a);
  void enter(PairLaws& laws) const override;
  bool isMirrored(const MirrorPlane&) const override { return true; }
  ContactValues mix(const ContactValues& a, const ContactValues& b) const;

 private:
  std::string friction_, restitution_;
};

}  // namespace dynamy
