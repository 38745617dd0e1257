/// ContactRule: the law between two materials. Materials belong to shapes, laws to pairs of
/// materials.
#pragma once
#include <dynamy/contact/set_valued_force_law.hpp>
#include <memory>
#include <string>

namespace dynamy {

/// `<Contact between="a b">law</Contact>`. The order of the materials does not matter.
class ContactRule : public Element {
 public:
  static constexpr Kind kKind = Kind::rule;
  explicit ContactRule(const Parameters& x);
  ~ContactRule() override;
  static void declare(Attributes& a);
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
