/// The functions an expression may call.
#pragma once

#include <dynamy/core/expression/expression_graph.hpp>
#include <span>
#include <string>
#include <string_view>

namespace dynamy {

struct ExpressionFunction {
  std::string_view name;
  int minArguments;
  int maxArguments;  ///< kAnyNumber: no limit
  ExpressionGraph::Node (*build)(ExpressionGraph& graph,
                                 std::span<const ExpressionGraph::Node> arguments);
};

inline constexpr int kAnyNumber = 1 << 30;

/// The function, or nullptr.
const ExpressionFunction* findFunction(std::string_view name);

/// All names, for "did you mean".
std::span<const std::string> functionNames();

}  // namespace dynamy
