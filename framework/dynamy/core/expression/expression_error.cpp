#include <algorithm>
#include <dynamy/core/error.hpp>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/core/utf8.hpp>

namespace dynamy {

std::string ExpressionError::report(std::string_view text) const {
  std::string line = message();
  if (!suggestion_.empty()) line += " — " + didYouMean(suggestion_);
  const std::size_t begin = std::min(offset_, text.size());
  const std::size_t blanks = static_cast<std::size_t>(characterCount(text.substr(0, begin)));
  const std::size_t carets = std::max<std::size_t>(
      1, static_cast<std::size_t>(characterCount(text.substr(begin, length_))));
  return line + "\n" + std::string(text) + "\n" + std::string(blanks, ' ') +
         std::string(carets, '^');
}

}  // namespace dynamy
