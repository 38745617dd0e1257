/// The most rows that one contact may have: normal, two of sliding, three of rolling and drilling,
/// two of a contour.
///
/// Laws and solvers keep the numbers of one contact on the stack, in arrays of this size.
/// ContactSink::add refuses a contact with more rows; a joint with more is cut into several
/// contacts. Rejected: storage that grows, because it would slow down every innermost loop.
#pragma once

namespace dynamy {

inline constexpr int kMostRows = 8;

}  // namespace dynamy
