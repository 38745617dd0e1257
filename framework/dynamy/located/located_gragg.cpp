#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/located_gragg.hpp>
#include <dynamy/located/phase/gragg_tableau.hpp>

namespace dynamy {
namespace {

LocatedSettings settingsOf(const Parameters& x) {
  LocatedSettings settings;
  settings.stiff = LocatedDormandPrince::stiffOf(x);
  settings.method = &graggTableau(std::stoi(x["order"].text));
  if (x["constraint"].text == "velocity") settings.columns = settings.method->order / 2;
  return settings;
}

}  // namespace

LocatedGragg::LocatedGragg(const Parameters& x) : LocatedDormandPrince(x, settingsOf(x)) {}

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
