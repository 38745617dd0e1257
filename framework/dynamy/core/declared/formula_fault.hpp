/// Errors of attributes that hold formulas, with the same hints for all elements.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/expression/expression_error.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// The hint for a formula that cannot be compiled: the nearest name, or how to declare one.
std::string formulaHint(const ExpressionError& error);

/// The error of one formula of a value.
ModelError formulaFault(const ParameterValue& value, const ValuePart& formula,
                        const ExpressionError& error);

/// The `count` formulas of a value, which ";" separates.
/// \throws ModelError for another number of formulas
std::vector<ValuePart> formulasOf(const ParameterValue& value, int count);

}  // namespace dynamy
