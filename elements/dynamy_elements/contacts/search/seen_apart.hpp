/// A cheap look at the gap of two shapes, before a search for it.
///
/// Any direction d tells how far two bodies are apart at least, by their furthest points along it:
///
///   |x_B − x_A| ≥ d·(f_B(−d) − f_A(d)),   f(d): furthest point of the body along d, |d| = 1
///
/// The first d leads from middle to middle. With w, the way between two points of the bodies' hulls
/// that gave d = w/|w|, the next one is the point of the line from w to f_B(−d) − f_A(d) that is
/// nearest to zero                                     [Gilbert, SIAM J. Control 4 (1966) 61]
#pragma once
#include <dynamy/system/frame.hpp>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>

namespace dynamy {

/// Six looks show that A and B, in space, are more than `reach` apart [m]. False: near, or not seen.
bool seenApart(const TouchingShape& a, const TouchingShape& b, const Frame& A, const Frame& B,
               double reach);

}  // namespace dynamy
