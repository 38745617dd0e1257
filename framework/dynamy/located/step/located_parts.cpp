#include <fmt/format.h>

#include <dynamy/contact/contact_name.hpp>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/located_parts.hpp>

namespace dynamy {
namespace {

/// Why a contact that comes, or goes while it is held, cannot be followed.
std::string whyUnfollowed(const SystemParts& parts, ContactKey key) {
  if (key == kNoContact) return std::string(ContactProbe::kUnfollowed);
  const auto number = static_cast<std::size_t>(key.value >> 40);
  const NonSmoothElement& e = *parts.contacts[number];
  // Contacts of shapes have no type of their own.
  const std::string cause =
      e.type().empty()
          ? "which features of two bodies could touch (corners over faces, rims over edges, faces "
            "of a mesh that are nearest to a ball) is another list after every motion"
          : "<" + e.type() + "> reports it at some positions only";
  return fmt::format(
      "contact {} comes and goes: {}, and its gap cannot be followed; give a step instead of the "
      "tolerance",
      contactName(e, number, contactNumber(key)), cause);
}

}  // namespace

double LocatedParts::leftOverlap() const {
  return MeetingConstants::left * norm.tolerance() * norm.length();
}

double LocatedParts::passingOverlap() const {
  return MeetingConstants::passing * norm.tolerance() * norm.length();
}

double LocatedParts::flatHeight() const {
  return std::max(MeetingConstants::flat * norm.tolerance(), MeetingConstants::leastFlat) *
         norm.length();
}

double LocatedParts::work(const MechanicalSystem& s, long evaluations) const {
  const FrozenPhase& phase = motion.phase;
  const double n = static_cast<double>(s.slot(0).h.size()),
               m = phase.held.empty() ? 0.0 : phase.rows().size();
  return static_cast<double>(evaluations) * (WorkConstants::each + n + m) +
         phase.cubes / WorkConstants::rowsCubed +
         WorkConstants::perGap * static_cast<double>(probe.looks.gaps) + probe.looks.searched;
}

void LocatedStep::book(long StepEffort::*what) {
  report.counts.effort.*what += s.evaluations() - booked;
  booked = s.evaluations();
}

Refusal LocatedStep::evaluate(PhasePoint& p, bool alone) {
  parts.search.forget(p.x.t);
  if (parts.motion.evaluate(s, p, alone)) return {};
  return fault();
}

Refusal LocatedStep::fault() {
  const FrozenPhase& phase = parts.motion.phase;
  return fault(phase.fault(), phase.lost());
}

Refusal LocatedStep::fault(std::string_view why, ContactKey at) {
  if (why == PhaseFault::kLost) return lose(at);
  if (why == ContactProbe::kUnfollowed) return unfollowed();
  if (why != PhaseFault::kOtherSet) return {Refusal::Kind::fault, std::string(why)};
  lastSwitched = at, otherSet = true;
  return {Refusal::Kind::stalled, std::string(why)};
}

Refusal LocatedStep::lose(ContactKey at) {
  // The features that touch are known only after a search of contacts as in steps in time.
  const double around = MeetingConstants::around * parts.norm.length();
  if (const ContactKey found = parts.probe.lookAround(from.x, around, at); found != kNoContact)
    at = found;
  lastSwitched = at;
  return {Refusal::Kind::stalled, whyUnfollowed(s.parts(), at), true};
}

Refusal LocatedStep::stall() const {
  return {Refusal::Kind::stalled,
          parts.settings.events.passesAccumulations
              ? "the steps have become too short: no status of the contacts lasts"
              : "events follow each other without end (an accumulation of impacts, or slip in "
                "space that ends): this scheme has no way past"};
}

}  // namespace dynamy
