// Laws between materials: <Contact between="rubber steel"><Law/></Contact>, and pairs that are
// switched off: <NoContact between="rubber rubber"/>.
#include <dynamy/core/declared/two_names.hpp>
#include <dynamy/law/contact_rule.hpp>
#include <dynamy/law/pair_laws.hpp>

namespace dynamy {
namespace {

void declareBetween(Attributes& a) {
  a.add(AttributeType::names, "between", std::nullopt, "the two materials");
}

std::pair<std::string, std::string> materials(const Parameters& x) {
  return twoNames(x["between"], "two materials",
                  "a material in contact with itself is written twice");
}

}  // namespace

ContactRule::ContactRule(const Parameters& x)
    : MaterialRule(x), law_(x.takeOne<SetValuedForceLaw>()) {
  const auto [a, b] = materials(x);
  a_ = a, b_ = b;
  if (law_ == nullptr || law_->unilateral()) return;
  throw ModelError(
      Diagnostic{.place = law_->place(),
                 .element = law_->type(),
                 .text = "has no normal force, and bodies of these materials would pass through "
                         "each other",
                 .hint = "friction between bodies is <UnilateralCoulomb>, or <UnilateralStribeck> "
                         "where mu at rest is above that of slipping"});
}

ContactRule::~ContactRule() = default;

void ContactRule::enter(PairLaws& laws) const { laws.enter(*this); }

void ContactRule::declare(Attributes& a) {
  a.about(
      "The force law between all shapes of two materials. Signals of all shapes that touch: "
      "contacts.count, contacts.meanOverlap, contacts.deepestOverlap.");
  declareBetween(a);
  a.child(Kind::law, 1, 1, "the force law");
  a.example("<Contact between=\"rubber concrete\"><UnilateralCoulomb mu=\"0.3\"/></Contact>");
}

void NoContactRule::declare(Attributes& a) {
  a.about("Shapes of these two materials pass through each other.");
  declareBetween(a);
  a.example("<NoContact between=\"rubber rubber\"/>");
}

}  // namespace dynamy
