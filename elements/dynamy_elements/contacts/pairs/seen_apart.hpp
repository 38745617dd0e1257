/// A cheap lower bound of the distance of two shapes, tried before a search for their gap.
///
/// For any direction d, the furthest points of two bodies along d bound their distance from below:
///
///   |x_B − x_A| ≥ d·(f_B(−d) − f_A(d)),   f(d): furthest point of the body along d, |d| = 1
///
/// The first d points from middle to middle. If w is the vector between two points of the bodies'
/// convex hulls that gave d = w/|w|, the next w is the point nearest to zero on the line from w to
/// f_B(−d) − f_A(d)                       [Gilbert, SIAM J. Control 4 (1966) 61]
#pragma once
#include <dynamy/system/frame.hpp>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>

namespace dynamy {

/// True: six directions are enough to show that A and B, in space, are more than `reach` apart [m].
/// False: the bodies are nearer, or six directions do not show it.
bool seenApart(const TouchingShape& a, const TouchingShape& b, const Frame& A, const Frame& B,
               double reach);

}  // namespace dynamy
