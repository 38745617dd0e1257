/// Reference of all types as Markdown pages, one per kind of element, made from the declarations in
/// the registry; doc/reference holds the pages of the standard elements.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <string>
#include <vector>

namespace dynamy {

struct ReferencePage {
  std::string file;  ///< "law.md"
  std::string text;
};

/// index.md, a page for each kind that has types, and model_file.md with the words of the format.
std::vector<ReferencePage> referencePages(const Registry& registry);

}  // namespace dynamy
