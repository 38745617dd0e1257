/// What is wrong in the text of an expression, and where.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace dynamy {

/// Raised while an expression is compiled, never while it is evaluated. what() is one line without
/// place and without hint, since the caller knows the file and the attribute around the text.
class ExpressionError final : public std::runtime_error {
 public:
  ExpressionError(const std::string& message, std::size_t offset, std::size_t length,
                  std::string suggestion = "")
      : std::runtime_error(message),
        offset_(offset),
        length_(length),
        suggestion_(std::move(suggestion)) {}

  std::string message() const { return what(); }
  std::size_t offset() const { return offset_; }  ///< first wrong byte of the text
  std::size_t length() const { return length_; }  ///< wrong bytes; 0 at the end of the text
  const std::string& suggestion() const { return suggestion_; }  ///< nearest known word or ""

  /// Message, hint, the text and a line with carets under the wrong part, three lines.
  std::string report(std::string_view text) const;

 private:
  std::size_t offset_;
  std::size_t length_;
  std::string suggestion_;
};

}  // namespace dynamy
