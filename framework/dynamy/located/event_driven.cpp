#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/event_driven.hpp>

namespace dynamy {

EventDriven::EventDriven() { plain(dormandPrince5()); }

EventDriven::EventDriven(const Parameters& x) : LocatedDormandPrince(x) { plain(dormandPrince5()); }

void EventDriven::declare(Attributes& a) {
  a.about(
      "The event-driven scheme of the textbooks: Dormand and Prince's method of order 5 between "
      "events, which are found by roots; there the impact law and one inclusion on the level of "
      "accelerations. It stalls where impacts accumulate; for comparison.");
  declareStiff(a);
  a.example("<simulation until=\"1\" tolerance=\"1e-6\"><EventDriven/></simulation>");
}

}  // namespace dynamy
