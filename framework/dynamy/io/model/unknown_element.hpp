/// Hints for unknown tags: the element that was probably meant.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// The hint for an unknown element at a place where the elements `allowed` may stand: "did you mean
/// <Box>?" or "in dynamY a hinge is <Revolute>". It names the section if the element belongs into
/// another one; "" if no name is near. Order of the search: the same name in another case, the word
/// of another program, the nearest of `allowed`, the nearest of all types.
std::string meantElement(std::string_view tag, const std::vector<std::string>& allowed,
                         const Registry& registry, const Vocabulary& vocabulary);

/// Where an element of this type stands, as the end of a message: "; put it into <systems>", "; it
/// stands inside of <Ground>, <RigidBody>".
std::string rightPlace(const RegisteredType& type, const Registry& registry);

/// The hint for a file whose root is not <dynamy>: it names the format of another program; "" if
/// unknown.
std::string meantFormat(const std::string& root);

}  // namespace dynamy
