#pragma once
/// \file
/// Errors with a place: what is wrong in a model, in which line, and what was probably meant.
///
///   models/bad.xml:7:9: error: <Sphere>: unknown attribute "raduis" — did you mean "radius"?
///       7 |     <Sphere raduis="0.1"/>
///         |             ^~~~~~
///
/// The shape is that of a compiler's message, so that editors jump to it without a plug-in.
/// Rejected: an exception that carries the text alone, because a reader that meets ten mistakes has
/// to collect ten of them, and a program with `--json` has to take the text apart again.

#include <cstddef>
#include <source_location>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy {

/// A piece of a text file. Lines and columns count from 1; 0 means unknown.
/// Columns and lengths count characters (Unicode code points); a tab is one character.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  int length = 1;

  /// Not an aggregate: inside of another aggregate, GCC 12 takes parts of it for uninitialized.
  // NOLINTNEXTLINE(google-explicit-constructor): {file, line} is a place wherever one is asked for
  Place(std::string inFile = {}, int atLine = 0, int atColumn = 0, int ofLength = 1)
      : file(std::move(inFile)), line(atLine), column(atColumn), length(ofLength) {}

  /// `file:line:column`, without the parts that are unknown; "" if nothing is known.
  std::string format() const;
  friend bool operator==(const Place&, const Place&) = default;
};

/// A second place that belongs to an error, e.g. the first of two equal names.
struct Note {
  Place place = {};
  std::string text = {};
  std::string sourceLine = {};
};

/// One error of a model, a plug-in or a file.
struct Diagnostic {
  Place place = {};
  std::string element = {};  ///< e.g. `Sphere` or `RigidBody name="b"`, printed in < >; may be ""
  std::string text = {};     ///< what is wrong: lower case, no full stop
  std::string hint = {};     ///< what to do, printed after a dash; may be ""
  std::string sourceLine = {};  ///< line `place.line` of the file, without its end; may be ""
  std::vector<Note> notes = {};

  /// The text of a compiler's message: header, line with caret, notes. No line end at the end.
  std::string format() const;
};

/// A model, a plug-in or a file is wrong. Thrown while loading, never inside a step.
class ModelError : public std::runtime_error {
 public:
  explicit ModelError(std::vector<Diagnostic> diagnostics);
  explicit ModelError(Diagnostic diagnostic);
  /// An error without a place, e.g. from a model that is built in C++.
  explicit ModelError(std::string text, std::string hint = {});

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// Collects the errors of a file, so that all of them are shown and not the first alone.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic);
  /// Takes over the errors of a part that failed on its own.
  void add(const ModelError& error);

  bool empty() const { return items_.empty(); }
  std::size_t size() const { return items_.size(); }
  const std::vector<Diagnostic>& items() const { return items_; }

  /// All errors, each once: sorted by file (in the order in which files were met), line and column.
  std::vector<Diagnostic> sorted() const;
  /// \throws ModelError with sorted(), if there is any error.
  void throwIfAny() const;

 private:
  std::vector<Diagnostic> items_;
};

/// All messages, one below the other; beyond the first 100 only their number is stated.
std::string format(const std::vector<Diagnostic>& diagnostics);

/// `did you mean "name"?`, or "" for an empty name: the hint of an unknown name.
std::string didYouMean(std::string_view name);

[[noreturn]] void throwExpectation(const char* what, const std::source_location& where);

/// Precondition on a programmer's call, e.g. `expects(dt > 0, "dt is positive")`.
/// Not for mistakes in models (ModelError) and not inside a step (assert).
/// \throws std::logic_error `file.cpp:12: expected: dt is positive (in 'void f(double)')`
inline void expects(bool holds, const char* what,
                    const std::source_location& where = std::source_location::current()) {
  if (!holds) throwExpectation(what, where);
}

}  // namespace dynamy
