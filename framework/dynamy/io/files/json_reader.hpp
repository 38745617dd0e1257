#pragma once
/// \file
/// Reads JSON that this program wrote, the facts of a run and of a sweep, into a tree of values.
/// Missing members read as null, so that facts of an older version can be shown, too. Objects keep
/// the order of their members; duplicate names and numbers beyond double are not detected.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

class JsonValue {
 public:
  enum class Type { null, boolean, number, text, array, object };
  Type type = Type::null;
  bool flag = false;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not a number, or null
  std::string text;
  std::vector<std::string> names;  ///< of an object: names of `items`
  std::vector<JsonValue> items;    ///< of an array or object

  /// Member of an object; a null value if there is none.
  const JsonValue& operator[](std::string_view name) const;
  explicit operator bool() const { return type != Type::null; }
  /// The number, cut to a whole one, if it lies in [least, most]; nothing if not, or if it is none.
  /// |most| ≤ 2⁵³.
  std::optional<long> whole(long least, long most) const;
};

/// The value in `text`. \throws FileError "file:line:column: what was expected"
JsonValue readJson(std::string_view text, const std::string& file);

}  // namespace dynamy
