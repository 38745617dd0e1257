/// Words of other programs and of textbooks, and the names that dynamY has for them: hints in
/// messages.
///
/// One table for elements, one for attributes, one for units, one for functions. They hold words of URDF and SDF,
/// MJCF, Chrono, Drake, Bullet, Simscape and Siconos that a newcomer may write. A word is compared
/// without case and without "_", "-" and ":". A test checks that every name of dynamY in the tables
/// exists (tests/unit/elements/other_words_test.cpp). Rejected: a declaration of such words by each
/// element, because most of these words belong to no single element, and because the reader would
/// have to search all types for one word.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// One row of a table. `words` and `ours` are separated by blanks.
struct OtherWord {
  std::string_view words;           ///< as others write it, in lower case, without "_", "-" and ":"
  std::string_view ours;            ///< of attributes and units: our names, the best first; else ""
  std::string_view hint;            ///< "a hinge is <Revolute>"; "{}": the name of ours that fits
  std::string_view elsewhere = {};  ///< of attributes: the hint where none of `ours` fits
};

std::span<const OtherWord> otherElements();
std::span<const OtherWord> otherAttributes();
std::span<const OtherWord> otherUnits();
std::span<const OtherWord> otherFunctions();

/// "in dynamY a hinge is <Revolute>" for the element <Hinge> of others; "" if it is in no table.
std::string elementOfOthers(std::string_view word);
/// The same for the last words of a name, which say what it is: "LinearMotor", "Belt_Drive".
std::string elementByLastWord(std::string_view word);
/// The word in lower case without a number at its end and without the kind that others add:
/// "distance" for "DistanceJoint", "box" for "BoxCollider", "rungekutta" for "RungeKutta4".
std::string withoutKind(std::string_view word);

/// Meaning of an attribute that is written in the words of another program.
struct AttributeOfOthers {
  std::string name;  ///< the name in `known` that is meant, "" if none of them fits
  std::string hint;  ///< "in dynamY the stiffness is stiffness="…""; "" if it is in no table
};
/// `known`: the attributes that the element has.
AttributeOfOthers attributeOfOthers(std::string_view word, std::span<const std::string> known);

/// "ball.vz" for the signal "ball.zdot" of others, if it is among `known`; "" otherwise.
std::string signalOfOthers(std::string_view name, std::span<const std::string> known);

/// The unit in dynamY: "deg" for "degrees", also with a divisor: "deg/s" for "degrees/sec"; "" if
/// unknown.
std::string unitOfOthers(std::string_view word);
/// "log" for the function "ln" of others, or an expression that does its work, as an example; "" if
/// it is in no table.
std::string functionOfOthers(std::string_view word);
/// "1lb is 0.45359237kg": the hint of a unit that dynamY does not have; "" if it is in no table.
std::string unitInOurs(std::string_view word);
/// "0.45359237kg": how much one such unit is; "" if it is in no table.
std::string amountInOurs(std::string_view word);

}  // namespace dynamy
