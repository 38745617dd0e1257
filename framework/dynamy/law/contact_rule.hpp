/// Rules of a model about the contact of materials: the law of two materials, two materials that do
/// not touch, the values of one material, and how the values of two materials mix. Materials belong
/// to shapes, laws to pairs of materials; PairLaws finds the law of a pair.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>
#include <memory>
#include <string>

namespace dynamy {

class PairLaws;

/// One rule about the contact of materials.
class MaterialRule : public Element {
 public:
  static constexpr Kind kKind = Kind::rule;
  using Element::Element;
  /// Enters the rule into `laws`, which borrows it: the rule must outlive the answers of `laws`.
  virtual void enter(PairLaws& laws) const = 0;
};

/// `<Contact between="a b">law</Contact>`. The order of the materials does not matter.
class ContactRule : public MaterialRule {
 public:
  explicit ContactRule(const Parameters& x);
  ~ContactRule() override;
  static void declare(Attributes& a);
  void enter(PairLaws& laws) const override;
  bool isMirrored(const MirrorPlane& plane) const override {
    return law_ == nullptr || law_->isMirrored(plane);
  }
  const std::string& materialA() const { return a_; }
  const std::string& materialB() const { return b_; }
  /// Null: the pair is switched off (NoContact).
  const SetValuedForceLaw* law() const { return law_.get(); }

 private:
  std::string a_, b_;
  std::unique_ptr<SetValuedForceLaw> law_;
};

/// `<NoContact between="a b"/>`: a rule without a law.
class NoContactRule final : public ContactRule {
 public:
  using ContactRule::ContactRule;
  static void declare(Attributes& a);
};

}  // namespace dynamy
