#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/material.hpp>
#include <dynamy/law/pair_laws.hpp>

namespace dynamy {
namespace {

const std::vector<std::string> kRules{"min", "max", "mean", "geometric", "product"};

double mixed(const std::string& rule, double a, double b) {
  if (rule == "min") return std::min(a, b);
  if (rule == "max") return std::max(a, b);
  if (rule == "mean") return 0.5 * (a + b);
  if (rule == "geometric") return std::sqrt(a * b);
  return a * b;
}

}  // namespace

void Material::declare(Attributes& a) {
  a.about(
      "Values of one material, `name` as the shapes say it. Two materials that no <Contact> covers "
      "get a law from theirs if <Contacts> says how they mix.");
  a.required("mu", Unit::none, "coefficient of friction μ").nonNegative();
  a.optional("epsilonN", Unit::none, 0.0, "coefficient of restitution of the normal direction")
      .between(0.0, 1.0);
  a.optional("epsilonT", Unit::none, 0.0, "coefficient of restitution of the tangential directions")
      .between(0.0, 1.0);
  a.example("<Material name=\"rubber\" mu=\"0.8\" epsilonN=\"0.5\"/>");
}

Material::Material(const Parameters& x)
    : MaterialRule(x), values_{x["mu"], x["epsilonN"], x["epsilonT"]} {
  if (name().empty())
    throw ModelError("a material needs a name", "the one that shapes give as material=\"…\"");
}

void Material::enter(PairLaws& laws) const { laws.enter(*this); }

void MixingRule::declare(Attributes& a) {
  a.about(
      "How the values of two <Material>s mix to the law of their pair, UnilateralCoulomb, without "
      "friction Unilateral: the smaller, the larger, the mean, the geometric mean √(a b), the "
      "product. A <Contact> or <NoContact> of the pair wins; without <Contacts> nothing mixes.");
  Attribute& mixing =
      a.add(AttributeType::choice, "mixing", std::nullopt, "rule for mu, and for restitution");
  mixing.choices = kRules;
  Attribute& restitution = a.add(AttributeType::choice, "restitution", std::nullopt,
                                 "rule for epsilonN and epsilonT; default: that of mixing");
  restitution.choices = kRules;
  restitution.mayBeAbsent();
  a.example("<Contacts mixing=\"geometric\" restitution=\"max\"/>");
}

MixingRule::MixingRule(const Parameters& x)
    : MaterialRule(x),
      friction_(x["mixing"].text),
      restitution_(x.has("restitution") ? x["restitution"].text : friction_) {}

void MixingRule::enter(PairLaws& laws) const { laws.enter(*this); }

ContactValues MixingRule::mix(const ContactValues& a, const ContactValues& b) const {
  return {mixed(friction_, a.mu, b.mu), mixed(restitution_, a.epsilonN, b.epsilonN),
          mixed(restitution_, a.epsilonT, b.epsilonT)};
}

}  // namespace dynamy
