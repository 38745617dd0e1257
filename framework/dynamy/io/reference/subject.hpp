/// Search in the declarations by subject: "friction" → all types about friction.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// The first sentence of a description without its dot, as `dynamy list` shows it. It ends before
/// ": " if at least three words precede it, because an equation usually follows.
std::string firstSentence(std::string_view about);

/// Types that match `word`: by their kind, a part of their name, or a word of their first sentence.
/// Upper case and plural forms match, too.
std::vector<const RegisteredType*> typesOnSubject(const Registry& registry, std::string_view word);

/// One line, such as "<UnilateralCoulomb> mu: coefficient of friction", for each type that has the
/// attribute `word`, or an attribute that other programs call so (core/other_words); "" if none
/// has.
std::string attributesOnSubject(const Registry& registry, std::string_view word);

}  // namespace dynamy
