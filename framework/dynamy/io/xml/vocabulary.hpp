/// Vocabulary: the words of the model file that are no element types (`<systems>`, `<parameter>`,
/// …). They are declared like elements, so that reader, describe and schema use the same
/// declarations.
#pragma once
#include <dynamy/core/declared/attributes.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Version of the file format: `<dynamy version="1">`.
inline constexpr int kModelVersion = 1;

/// Largest number of turns of all replicates of a model together; a population is better for more.
inline constexpr int kMostTurns = 100000;
/// Largest number of elements in all turns together.
inline constexpr std::size_t kMostReplicated = 1000000;
/// Largest number of files that a model includes, and their deepest nesting.
inline constexpr std::size_t kMostIncludes = 1000, kDeepestInclude = 32;
/// Largest number of names in `<record signals>`.
inline constexpr std::size_t kMostSignalNames = 10000;
/// Largest size of all files of a model together, in bytes.
inline constexpr std::size_t kMostText = 64000000;

/// One word of the format.
struct Word {
  std::string name;
  Attributes attributes;
  std::vector<std::string> children = {};  ///< words that may stand inside
  std::vector<Kind> kinds = {};            ///< element types of these kinds may stand inside
  bool text = false;                       ///< holds text for people
};

class Vocabulary {
 public:
  Vocabulary();
  const Word* find(std::string_view name) const;
  const std::vector<Word>& words() const { return words_; }

 private:
  std::vector<Word> words_;
};

/// Section for elements of this kind: "forces", "systems", …; "" if they stand inside of other
/// elements.
std::string_view sectionOf(Kind kind);
/// The name of a kind with its article: "a force", "an impact".
std::string kindWithArticle(Kind kind);

}  // namespace dynamy
