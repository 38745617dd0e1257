/// Vocabulary: the words of the model file that are no element types (`<systems>`, `<parameter>`,
/// …). They are declared as elements are, so that reader, describe and schema know them alike.
#pragma once
#include <dynamy/core/declared/attributes.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Version of the file format: `<dynamy version="1">`.
inline constexpr int kModelVersion = 1;

/// Turns of all replicates of a model together; more are better a population.
inline constexpr int kMostTurns = 100000;
/// Elements of all turns together.
inline constexpr std::size_t kMostReplicated = 1000000;
/// Files that a model includes, and how deep.
inline constexpr std::size_t kMostIncludes = 1000, kDeepestInclude = 32;
/// Names that `<record signals>` lists.
inline constexpr std::size_t kMostSignalNames = 10000;
/// Bytes of all files of a model together.
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

/// Where an element of this kind belongs: "forces", "systems", …; "" if it stands inside of others.
std::string_view sectionOf(Kind kind);
/// "a force", "an impact".
std::string kindWithArticle(Kind kind);

}  // namespace dynamy
