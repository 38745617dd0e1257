/// Reads the text of one expression into a graph. Grammar, weakest operator first:
///   expression = or [ "?" expression ":" expression ]
///   or         = and { "||" and }              and   = relation { "&&" relation }
///   relation   = sum [ ( "<" | "<=" | ">" | ">=" | "==" | "!=" ) sum ]
///   sum        = product { ( "+" | "-" ) product }
///   product    = unary { ( "*" | "/" ) unary }
///   unary      = ( "-" | "+" | "!" ) unary | power
///   power      = primary [ "^" unary ]         (so −x^2 = −(x^2) and 2^3^2 = 2^9)
///   primary    = number [ unit ] | name | name "(" expression { "," expression } ")"
///              | "(" expression ")"
#pragma once

#include <dynamy/core/expression/expression_graph.hpp>
#include <dynamy/core/expression/symbol_table.hpp>
#include <string_view>

namespace dynamy {

/// Values that parts made of constants alone may have: 1/0 is not finite.
enum class ConstantParts { any, finite };

/// The node of the expression's value. Raises ExpressionError, with ConstantParts::finite also for
/// a constant part that the value needs and that is infinite or not a number.
ExpressionGraph::Node parseExpression(std::string_view text, const SymbolTable& symbols,
                                      ExpressionGraph& graph,
                                      ConstantParts parts = ConstantParts::any);

}  // namespace dynamy
