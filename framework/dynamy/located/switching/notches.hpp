/// Sets on a displacement x. Beside x = 0 the force is known. Where x passes 0 with a speed the
/// force jumps. Rest at x = 0 is decided like stick (theory 50.4).
#pragma once
#include <dynamy/located/switching/ongoing_event.hpp>

namespace dynamy {

/// True: contact i has a set on its displacement.
bool notched(const ContactSet& c, std::size_t i);
/// Displacements below this count as zero [m].
double notchMiddle(const ErrorNorm& norm);
/// Sign of the displacement of contact i, or where it is zero, of its velocity `gamma`; 0: at rest
/// at x = 0, or the set depends on no displacement.
double notchSide(const ContactSet& c, std::size_t i, const double* gamma, const OngoingEvent& at);
/// Sets displacements that rest at x = 0 to exactly zero. `gamma`: of all rows of `c`.
void restInNotches(ContactSet& c, const Eigen::VectorXd& gamma, const OngoingEvent& at);

}  // namespace dynamy
