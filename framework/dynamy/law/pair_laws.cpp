#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {
namespace {

PairLaws::Names inOrder(const std::string& a, const std::string& b) {
  const auto& [first, second] = std::minmax(a, b);
  return {first, second};
}

std::string quotedPair(const std::string& a, const std::string& b) {
  return "\"" + a + "\" and \"" + b + "\"";
}

/// Notes the names of a rule that no shape has as its material, if the rule may have been meant for
/// the materials `asked`: another of its names, or a similar one, is among them.
void addUncarried(Diagnostic& d, const MaterialRule& rule, const std::set<std::string>& names,
                  const std::set<std::string>& carried, const std::vector<std::string>& asked) {
  constexpr std::size_t kMostNotes = 4;
  std::string text;
  bool meant = false;
  for (const std::string& name : names) {
    if (carried.contains(name)) {
      if (std::find(asked.begin(), asked.end(), name) == asked.end()) return;
      meant = true;
      continue;
    }
    text += (text.empty() ? std::string(kNoShapeHas) : " or ") + '"' + name + '"';
    const std::string near = nearest(name, asked);
    if (near.empty()) continue;
    meant = true;
    text += typingDistance(name, near) == 0 ? ", but \"" + near + '"'
                                            : "; did you mean \"" + near + "\"?";
  }
  if (meant && !text.empty() && d.notes.size() < kMostNotes)
    d.notes.push_back({.place = rule.place(), .text = std::move(text)});
}

/// A known material with a name similar to the first unknown one of `asked`; "" if there is none.
std::string nearMaterial(const std::vector<std::string>& asked,
                         const std::vector<std::string>& known) {
  for (const std::string& name : asked) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (std::string near = nearest(name, known); !near.empty()) return near;
  }
  return {};
}

}  // namespace

void PairLaws::add(std::unique_ptr<MaterialRule> rule) {
  rules_.push_back(std::move(rule));
  rules_.back()->enter(*this);
}

/// Stores the rule in `known`. If `known` holds a rule already, this is noted as an error.
template <class Known, class Rule>
void PairLaws::once(Known& known, const Rule& rule, const std::string& what) {
  if (!known) {
    known = &rule;
    return;
  }
  twice_.add({.place = rule.place(),
              .element = rule.type(),
              .text = what,
              .hint = "remove one of the two",
              .notes = {{.place = known->place(), .text = "the first rule"}}});
}

void PairLaws::enter(const ContactRule& rule) {
  once(pairs_[inOrder(rule.materialA(), rule.materialB())], rule,
       "the materials " + quotedPair(rule.materialA(), rule.materialB()) + " have a rule already");
}

void PairLaws::enter(const Material& material) {
  once(materials_[material.name()], material,
       "the material \"" + material.name() + "\" has values already");
}

void PairLaws::enter(const MixingRule& rule) {
  once(mixing_, rule, "how values of materials mix is said already");
}

const Material* PairLaws::material(const std::string& name) const {
  const auto at = materials_.find(name);
  return at == materials_.end() ? nullptr : at->second;
}

PairLaw PairLaws::mixed(const Material& a, const Material& b) {
  const ContactValues v = mixing_->mix(a.values(), b.values());
  if (!std::isfinite(v.mu))
    throw ModelError(Diagnostic{.place = mixing_->place(),
                                .element = mixing_->type(),
                                .text = "mu of the materials " + quotedPair(a.name(), b.name()) +
                                        " mixes to " + numberText(v.mu),
                                .hint = "take smaller values"});
  std::unique_ptr<const SetValuedForceLaw> law;
  std::string text = "Unilateral";
  // Without friction a contact needs no tangents.
  if (v.mu > 0.0) {
    law = std::make_unique<UnilateralCoulomb>(v.epsilonN, v.epsilonT, v.mu);
    text += "Coulomb mu=" + numberText(v.mu);
  } else {
    law = std::make_unique<Unilateral>(v.epsilonN);
  }
  text += " epsilonN=" + numberText(v.epsilonN);
  if (v.mu > 0.0 && v.epsilonT > 0.0) text += " epsilonT=" + numberText(v.epsilonT);
  mixedLaws_.push_back(std::move(law));
  return {mixedLaws_.back().get(), mixing_, std::move(text)};
}

const PairLaw& PairLaws::find(const std::string& a, const std::string& b) {
  const Names names = inOrder(a, b);
  const auto [at, isNew] = found_.try_emplace(names);
  PairLaw& out = at->second;
  if (!isNew) return out;
  if (const auto own = pairs_.find(names); own != pairs_.end()) {
    const ContactRule& rule = *own->second;
    out = {rule.law(), &rule, rule.law() ? rule.law()->type() : "no contact"};
  } else if (mixing_) {
    const Material *first = material(names.first), *second = material(names.second);
    if (first && second) out = mixed(*first, *second);
  }
  return out;
}

bool PairLaws::meet(const std::string& a, const std::string& b) const {
  if (const auto own = pairs_.find(inOrder(a, b)); own != pairs_.end())
    return own->second->law() != nullptr;
  return mixing_ != nullptr && material(a) != nullptr && material(b) != nullptr;
}

const MaterialRule* PairLaws::notMirrored(const MirrorPlane& plane) const {
  for (const auto& rule : rules_)
    if (!rule->isMirrored(plane)) return rule.get();
  return nullptr;
}

Diagnostic PairLaws::missing(const std::string& a, const std::string& b,
                             const std::set<std::string>& carried) const {
  const std::string between = "between=\"" + a + " " + b + "\"";
  Diagnostic d;
  d.text = "no law for contact of the materials " + quotedPair(a, b);
  if (mixing_) {
    // Find the material without values, and whether its name was misspelt.
    const std::string& without = material(a) ? b : a;
    std::vector<std::string> known;
    for (const auto& [name, values] : materials_) known.push_back(name);
    d.text += ": \"" + without + "\" has no values to mix";
    d.hint = unknownNameHint(without, known);
    if (!d.hint.starts_with("did you mean"))
      d.hint = "add <Material name=\"" + without + "\" mu=\"…\"/>, or <Contact " + between +
               ">…</Contact>";
    d.notes.push_back({.place = mixing_->place(), .text = "values mix by this rule"});
    if (const Material* named = material(nearMaterial({without}, known)))
      addUncarried(d, *named, {named->name()}, carried, {a, b});
    return d;
  }
  std::vector<std::string> known;
  for (const auto& [name, values] : materials_) known.push_back(name);
  for (const auto& [names, rule] : pairs_) known.insert(known.end(), {names.first, names.second});
  const std::string near = nearMaterial({a, b}, known);
  d.hint = (near.empty() ? "add" : "did you mean the material \"" + near + "\"? Else add") +
           (" <Contact " + between + ">…</Contact>, or <NoContact " + between + "/>");
  if (material(a) && material(b))
    d.hint += ", or say by <Contacts mixing=\"…\"/> how the values of two materials mix";
  for (const auto& [names, rule] : pairs_)
    addUncarried(d, *rule, {names.first, names.second}, carried, {a, b});
  return d;
}

std::vector<std::string> PairLaws::namesOf(const MaterialRule& rule) const {
  for (const auto& [names, of] : pairs_)
    if (of == &rule) return {names.first, names.second};
  return {};
}

std::vector<const MaterialRule*> PairLaws::idle() const {
  std::vector<const MaterialRule*> out;
  for (const auto& rule : rules_) {
    bool used = false;
    for (const auto& [names, answer] : found_) {
      used = used || answer.from == rule.get();
      if (answer.from != mixing_ || !mixing_) continue;
      used = used || material(names.first) == rule.get() || material(names.second) == rule.get();
    }
    if (!used) out.push_back(rule.get());
  }
  return out;
}

}  // namespace dynamy
