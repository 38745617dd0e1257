#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/formula_fault.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>
#include <dynamy_elements/contacts/shapes/contour_shape.hpp>
#include <numbers>

namespace dynamy {
namespace {

constexpr int kPoints = 720;

std::vector<double> fromFormula(const Parameters& x, const ParameterValue& value) {
  SymbolTable symbols;
  for (const auto& [name, number] : x.symbols) symbols.constant(name, number);
  symbols.variable("phi");
  std::vector<double> out;
  try {
    Expression r = Expression::compile(value.text, symbols);
    for (int i = 0; i < kPoints; ++i) {
      const double phi = kTwoPi * i / kPoints;
      out.push_back(r.value(&phi));
    }
  } catch (const ExpressionError& error) {
    throw formulaFault(value, {value.text, 0}, error);
  }
  return out;
}

}  // namespace

void ContourShape::declare(Attributes& a) {
  a.about(
      "Closed smooth curve r(phi) about the shape's z axis, a cam: touches circles and points "
      "where "
      "bodies move in its plane, and half spaces if it is convex. A periodic spline of degree 5 "
      "through "
      "720 points, or through the radii that are given.");
  a.add(AttributeType::expression, "r", std::nullopt, "radius as a formula of phi")
      .in(Unit::length)
      .mayBeAbsent();
  a.vector("radii", Unit::length, 0, "", "radii at equal angles from phi = 0 on, eight or more")
      .mayBeAbsent();
  a.example("<Contour r=\"0.05 + 0.01*cos(phi)\" material=\"steel\"/>");
}

ContourShape::ContourShape(const Parameters& x) : Shape(x) {
  const ParameterValue &formula = x["r"], &radii = x["radii"];
  if (formula.given == radii.given)
    throw(formula.given ? radii : formula)
        .fault("a contour is given by either r or radii", "give one of the two", 0,
               (formula.given ? radii : formula).text.size());
  const ParameterValue& given = formula.given ? formula : radii;
  radii_ = formula.given ? fromFormula(x, formula) : radii.numbers;
  if (radii_.size() < 8)
    throw given.fault("eight radii or more are needed", "here are " + std::to_string(radii_.size()),
                      0, given.text.size());
  for (std::size_t i = 0; i < radii_.size(); ++i)
    if (!(radii_[i] > 0.0))
      throw given.fault(
          "radii must be positive",
          "at phi = " +
              numberText(kTwoPi * static_cast<double>(i) / static_cast<double>(radii_.size())) +
              " r is " + numberText(radii_[i]),
          0, given.text.size());
}

ShapeGeometry ContourShape::geometry() const {
  ShapeGeometry g{ShapeType::contour, {}, {}, colour()};
  for (std::size_t i = 0; i < radii_.size(); ++i) {
    const double phi = kTwoPi * static_cast<double>(i) / static_cast<double>(radii_.size());
    g.points.emplace_back(radii_[i] * std::cos(phi), radii_[i] * std::sin(phi), 0.0);
  }
  return g;
}

}  // namespace dynamy
