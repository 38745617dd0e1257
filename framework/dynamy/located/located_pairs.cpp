// LocatedDormandPrince: contacts that come and go with the features of bodies (theory 50.9).
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cstdint>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/located/switching/borne_by_joints.hpp>

namespace dynamy {
namespace {

constexpr double kOverlap = 1e-3;  ///< of tol L: overlaps that are left as they are
constexpr double kPassing = 10.0;  ///< of tol L: overlaps inside a step, which end before it does
constexpr std::uintmax_t kLooks = 12;  ///< evaluations to find where two bodies are nearest
constexpr int kNearestBits = 20;
constexpr double kHalfWay = 0.5;     ///< part of a sample interval that each sample looks ahead
constexpr double kNotAtAll = 0.25;   ///< part of the path to retry if bodies meet at its start
constexpr double kAtMeeting = 1e-3;  ///< of T: shorter steps up to a meeting are not taken
constexpr double kShorter = 0.5;     ///< factor on a step in which bodies sink into one another
/// Drift of joints between two projections, and more, as a part of L.
constexpr double kDrifted = 1e-10;

/// Part of a path before a contact that is noted first at sample j of the path.
double clearBefore(int j) {
  return std::max((static_cast<double>(j) - kHalfWay) / SwitchSearch::kSamples, kNotAtAll);
}

}  // namespace

double LocatedDormandPrince::leftOverlap() const {
  return kOverlap * norm_.tolerance() * norm_.length();
}

bool LocatedDormandPrince::leaveToJoints(MechanicalSystem& s) {
  borne_.clear();
  const bool jointed = std::any_of(phase_.held.begin(), phase_.held.end(), [&](const Held& h) {
    const int i = probe_.find(h.key);
    return i >= 0 && !probe_.law(i).unilateral() && probe_.law(i).rowKind(0) == RowKind::joint;
  });
  if (!jointed) return true;
  const double drifted = std::max(kDrifted * norm_.length(), leftOverlap());
  asked_ = phaseKeys_;
  for (int i = 0; i < probe_.size(); ++i)
    if (probe_.law(i).unilateral() && std::abs(probe_.gap(i)) <= drifted &&
        phase_.find(probe_.key(i)) == nullptr)
      asked_.push_back(probe_.key(i));
  if (asked_.size() == phaseKeys_.size()) return true;
  std::sort(asked_.begin(), asked_.end());
  s.hold(asked_);
  s.evaluate(from_.x, 1);
  s.hold(phaseKeys_);
  borneByJoints(s.slot(1), borne_);
  if (borne_.empty()) return true;
  search_.borne(borne_, kPassing * norm_.tolerance() * norm_.length());
  return search_.watch(probe_, phase_, from_.x);
}

bool LocatedDormandPrince::widen() {
  clear_ = 1.0;
  if (!probe_.gathers()) return true;
  const double deep = startOverlap_ + kPassing * norm_.tolerance() * norm_.length();
  trial_.x.memory = from_.x.memory;
  // Each sample looks ahead half of the way to the next one.
  const double ahead = 0.5 * path_.length() / SwitchSearch::kSamples;
  constexpr int n = SwitchSearch::kSamples;
  const auto depth = [&](double theta) {
    path_.at(theta, trial_.x);
    probe_.widen(trial_.x, ahead);
    if (theta > 0.0 && probe_.overlap() > deep) passing_ = std::min(passing_, theta);
    return probe_.overlap();
  };
  std::array<double, n + 1> depths{};
  int fresh = -1;
  for (int j = 0; j <= n; ++j) {
    depths[static_cast<std::size_t>(j)] = depth(static_cast<double>(j) / n);
    if (fresh < 0 && probe_.notesFresh()) fresh = j;
    if (!probe_.meets()) continue;
    clear_ = clearBefore(j);
    return false;
  }
  // Bodies may come near between two samples and part again: find the nearest place.
  for (std::size_t j = 1; j < n; ++j) {
    const double here = depths[j], fall = std::max(here - depths[j - 1], here - depths[j + 1]);
    if (here < depths[j - 1] || here <= depths[j + 1] || here > deep || here + fall < 0.0) continue;
    std::uintmax_t looks = kLooks;
    boost::math::tools::brent_find_minima([&](double theta) { return -depth(theta); },
                                          static_cast<double>(j - 1) / n,
                                          static_cast<double>(j + 1) / n, kNearestBits, looks);
  }
  if (probe_.settle(from_.x) && search_.watch(probe_, phase_, from_.x)) return true;
  clear_ = clearBefore(std::max(fresh, 0));  // a contact on the path is not reported at its start
  return false;
}

LocatedDormandPrince::Tried LocatedDormandPrince::shortOfMeeting(double h, StepReport& report) {
  H_ = h * clear_;
  if (H_ > kAtMeeting * norm_.time()) {
    ++report.counts.rejected;
    return Tried::rejected;
  }
  lose(probe_.meets() ? probe_.met() : probe_.unfollowed());
  return Tried::failed;
}

bool LocatedDormandPrince::sinks(const State& x) {
  if (!probe_.comesAndGoes()) return false;
  probe_.widen(x, 0.0);
  const double most = startOverlap_ + leftOverlap();
  return probe_.overlap() > most;
}

bool LocatedDormandPrince::takeShorter(const MechanicalSystem& s, double h,
                                       const std::array<double, 5>& works, StepReport& report) {
  ++report.counts.rejected;
  works_ = works, phase_.held = startHeld_, H_ = kShorter * h;
  book(s, &StepEffort::rejected, report);
  return true;
}

}  // namespace dynamy
