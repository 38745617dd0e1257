/// Search in the declarations by subject: "friction" → all types about friction.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// The first sentence of a description without its dot, as `dynamy list` shows it. It ends before
/// ": " if at least three words stand there, because what follows is an equation as a rule.
std::string firstSentence(std::string_view about);

/// Types whose kind, a part of whose name, or a word of whose first sentence is `word`, in any case
/// and number.
std::vector<const RegisteredType*> typesOnSubject(const Registry& registry, std::string_view word);

/// "<UnilateralCoulomb> mu: coefficient of friction", a line for each type that has the attribute
/// `word` or what others call so (core/other_words); "" if none has.
std::string attributesOnSubject(const Registry& registry, std::string_view word);

}  // namespace dynamy
