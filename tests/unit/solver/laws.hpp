/// Laws for problems by hand: a joint, a contact without friction, one with mu 0.5.
#pragma once
#include <dynamy/law/standard_laws.hpp>

namespace dynamy::fixture {

inline const Bilateral kBilateral;
inline const Unilateral kUnilateral;
inline const UnilateralCoulomb kCoulomb(0.0, 0.0, 0.5);

}  // namespace dynamy::fixture
