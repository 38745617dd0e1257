// Settings of the schemes that locate switches.
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/located_gragg.hpp>
#include <dynamy/located/phase/gragg_tableau.hpp>

namespace dynamy {
namespace {

constexpr double kLoose = 1e-2;  ///< from this tolerance up the method of order 5 is used

}  // namespace

LocatedDormandPrince::LocatedDormandPrince(const Parameters& x)
    : OneStep(x),
      stiff_(x["stiff"].text == "never"    ? Stiff::never
             : x["stiff"].text == "always" ? Stiff::always
                                           : Stiff::automatic) {}

LocatedDormandPrince::LocatedDormandPrince(const Parameters& x, const ButcherTableau& table)
    : LocatedDormandPrince(x) {
  given_ = table_ = &table;
}

void LocatedDormandPrince::declareStiff(Attributes& a) {
  a.choice("stiff", {"automatic", "never", "always"}, "automatic",
           "steps by the implicit Radau IIA method of order 5, for fast forces that are damped: "
           "automatic turns to it where the bound of stability limits explicit steps, and back");
}

void LocatedDormandPrince::declare(Attributes& a) {
  a.about(
      "Steps by tolerance: Dormand and Prince's explicit method of order 8 (5 at loose tolerances, "
      "and where the motion is simple) between switches, which are located; impacts and new "
      "contact "
      "states by inclusions. The scheme of every run with a tolerance.");
  declareStiff(a);
  a.example("<simulation until=\"1\" tolerance=\"1e-6\"><LocatedDormandPrince/></simulation>");
}

void LocatedDormandPrince::aim(const Accuracy& accuracy) {
  accuracy_ = accuracy;
  table_ = given_ ? given_ : accuracy.tolerance >= kLoose ? &dormandPrince5() : &dormandPrince8();
  ready_ = false;
}

LocatedGragg::LocatedGragg(const Parameters& x)
    : LocatedDormandPrince(x, graggTableau(std::stoi(x["order"].text))) {
  if (x["constraint"].text == "velocity") halfExplicit(order() / 2);
}

void LocatedGragg::declare(Attributes& a) {
  a.about(
      "Steps by tolerance as those of LocatedDormandPrince, with Gragg's extrapolated midpoint "
      "rule in the smooth phases; for comparison of methods.");
  a.choice("order", {"2", "4", "6", "8"}, "8", "twice the number of columns");
  a.choice("constraint", {"acceleration", "velocity"}, "acceleration",
           "where closed contacts and joints are held: on accelerations, or half-explicitly on "
           "velocities at the new position of each sub-step, which needs no bias of elements");
  declareStiff(a);
  a.example("<simulation until=\"1\" tolerance=\"1e-6\"><LocatedGragg order=\"6\"/></simulation>");
}

}  // namespace dynamy
