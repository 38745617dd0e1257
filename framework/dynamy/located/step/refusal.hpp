/// Refusal: why a located step cannot be taken.
#pragma once
#include <cstdint>
#include <dynamy/core/types.hpp>
#include <string>

namespace dynamy {

struct [[nodiscard]] Refusal {
  enum class Kind : std::uint8_t {
    none,    ///< the step was taken
    fault,   ///< no force satisfies the phase, or an element reports a wrong bias
    stalled  ///< no status of the contacts lasts; steps in time go past it
  };
  Kind kind = Kind::none;
  std::string why;        ///< a sentence for the report
  bool lost = false;      ///< stalled because a contact comes or goes that cannot be followed
  bool passable = false;  ///< steps in time can go past; else a force is singular
  explicit operator bool() const { return kind != Kind::none; }
};

}  // namespace dynamy
