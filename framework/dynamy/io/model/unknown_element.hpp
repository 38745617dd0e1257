/// Which element was meant by a tag that nobody knows.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// The hint of an unknown element where `allowed` may stand: "did you mean <Box>?" or "in dynamY a
/// hinge is <Revolute>", with the section if it belongs into another one; "" if nothing is near. In
/// this order: the same name in another case, the word of another program, the nearest of
/// `allowed`, the nearest of all types.
std::string meantElement(std::string_view tag, const std::vector<std::string>& allowed,
                         const Registry& registry, const Vocabulary& vocabulary);

/// The hint for a file whose root is not <dynamy>: the format of another program; "" if unknown.
std::string meantFormat(const std::string& root);

}  // namespace dynamy
