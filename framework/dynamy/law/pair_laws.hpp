/// PairLaws: finds the law of two materials, and the rule that gives it. The rules of a model are
/// entered in any order; the law of a pair is
///
///   1. that of the <Contact> or <NoContact> of the pair,
///   2. else, if the model has <Contacts> and both materials have values, the law of the mixed
///   values,
///   3. else none: an error if shapes of the two materials can touch.
#pragma once
#include <dynamy/law/material.hpp>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy {

/// Begins the note that a rule names a material of no shape. It is wrong of a model that lacks
/// shapes.
inline constexpr std::string_view kNoShapeHas = "no shape has the material ";

/// The law of two materials.
struct PairLaw {
  const SetValuedForceLaw* law = nullptr;  ///< null: they pass through each other
  const MaterialRule* from = nullptr;      ///< the rule that gives the law; null: none does
  std::string text;                        ///< "UnilateralCoulomb mu=0.3", for reports
};

class PairLaws {
 public:
  using Names = std::pair<std::string, std::string>;  ///< in ascending order

  void add(std::unique_ptr<MaterialRule> rule);
  /// Called by each rule in MaterialRule::enter().
  void enter(const ContactRule& rule);
  void enter(const Material& material);
  void enter(const MixingRule& rule);

  /// Throws ModelError that names every pair, material and mixing rule given twice.
  void verify() const { twice_.throwIfAny(); }
  /// Law of the materials a and b, in any order. The answer is kept for found() and idle().
  const PairLaw& find(const std::string& a, const std::string& b);
  /// True: the materials a and b, in any order, have a law. Nothing is kept.
  bool meet(const std::string& a, const std::string& b) const;
  /// The error for shapes of materials a and b that can touch without a law: text, hint, notes.
  /// `carried`: the materials of all shapes; a rule with other names may have been meant for a and
  /// b.
  Diagnostic missing(const std::string& a, const std::string& b,
                     const std::set<std::string>& carried) const;
  /// The first rule that is not its own mirror image (Element::isMirrored); null: all are.
  const MaterialRule* notMirrored(const MirrorPlane& plane) const;
  /// All answers given so far.
  const std::map<Names, PairLaw>& found() const { return found_; }
  /// Rules that no answer given so far is based on.
  std::vector<const MaterialRule*> idle() const;
  /// The two materials of a rule about a pair; none for other rules.
  std::vector<std::string> namesOf(const MaterialRule& rule) const;

 private:
  template <class Known, class Rule>
  void once(Known& known, const Rule& rule, const std::string& what);
  PairLaw mixed(const Material& a, const Material& b);
  const Material* material(const std::string& name) const;

  std::vector<std::unique_ptr<MaterialRule>> rules_;
  std::map<Names, const ContactRule*> pairs_;
  std::map<std::string, const Material*> materials_;
  const MixingRule* mixing_ = nullptr;
  std::vector<std::unique_ptr<const SetValuedForceLaw>> mixedLaws_;
  std::map<Names, PairLaw> found_;
  Diagnostics twice_;
};

}  // namespace dynamy
