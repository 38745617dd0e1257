// How far each shape sees others, and which near pairs cannot meet within the step (theory 38.3).
#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/shape_contacts.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Of the thickness of a shape among many: how far it is seen in any case.
constexpr double kAtRest = 0.05;
/// How often a turn is passed on at most.
constexpr int kTurns = 8;

double restReach(const TouchingShape& s) {
  return std::isfinite(s.thickness) ? kAtRest * s.thickness : 0.0;
}

}  // namespace

/// Few shapes are seen early, so that their gaps can be followed. Of many, each is seen as far as
/// it goes while the fastest goes as far as is asked for: a reach τ max |u| is τ (|v| + l |Ω|) for
/// it.
void ShapeContacts::lookAhead(const Kinematics& k, const ContactRequest& request) const {
  const std::vector<TouchingShape>& shapes = shapes_[0];
  const double all = std::max(request.gTol, 0.0);
  tau_ = 0.0;
  if (!namedPairs_.empty() || request.refresh) {
    // Contacts that are to count as closed are looked for at any distance.
    const double further = request.refresh ? std::numeric_limits<double>::infinity() : 0.5 * all;
    for (std::size_t i = 0; i < shapes.size(); ++i) reach_[i] = early_[i] + further;
    return;
  }
  double fastest = 0.0;
  for (const TouchingShape& s : shapes) {
    const Frame& f = k.frame(s.frame);
    fastest = std::max(fastest, f.v_S_I.norm() + f.Omega_I.norm());
  }
  const double tau = fastest > 0.0 ? all / fastest : 0.0;
  if (all > kAtRest * thinnest_) tau_ = tau;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const TouchingShape& s = shapes[i];
    const Frame& f = k.frame(s.frame);
    const double arm = s.p_K.norm() + (s.kind == TouchingShape::Kind::ball ? 0.0 : s.bound);
    const double w = f.v_S_I.norm() + (std::isfinite(arm) ? arm : 0.0) * f.Omega_I.norm();
    reach_[i] = std::min(tau * w, all) + restReach(s);
  }
}

/// Balls that move side by side meet nothing, however fast they are. In the time τ two of them go
/// τ |v_j − v_i|; w_i, into turned_, is how far a shape may be thrown off its course:
///
///   w_i = max_j (τ |v_j − v_i| − g_ij),   then   w_i ← max(w_i, w_j − g_ij)
///
/// since one that is off its course by w_j moves the next one by what their gap leaves of it. Pairs
/// with g_ij > τ |v_j − v_i| + w_i + w_j are left out. Other shapes count with all of their reach.
void ShapeContacts::followTurns(const Kinematics& k,
                                const std::vector<BroadPhase::Pair>& near) const {
  const std::vector<TouchingShape>& shapes = shapes_[0];
  gap_.resize(near.size()), way_.resize(near.size());
  for (std::size_t n = 0; n < near.size(); ++n) {
    const auto i = static_cast<std::size_t>(near[n].first),
               j = static_cast<std::size_t>(near[n].second);
    const BroadPhase::Ball &a = balls_[i], &b = balls_[j];
    gap_[n] = (b.c - a.c).norm() - (a.radius - reach_[i]) - (b.radius - reach_[j]);
    way_[n] = reach_[i] + reach_[j];
    if (shapes[i].isBall() && shapes[j].isBall())
      way_[n] = std::min(
          way_[n], tau_ * (k.frame(shapes[j].frame).v_S_I - k.frame(shapes[i].frame).v_S_I).norm());
    for (const std::size_t m : {i, j}) turned_[m] = std::max(turned_[m], way_[n] - gap_[n]);
  }
  bool again = true;
  for (int pass = 0; pass < kTurns && again; ++pass) {
    again = false;
    for (std::size_t n = 0; n < near.size(); ++n) {
      double &a = turned_[static_cast<std::size_t>(near[n].first)],
             &b = turned_[static_cast<std::size_t>(near[n].second)];
      const double gap = std::max(gap_[n], 0.0);
      if (b < a - gap) b = a - gap, again = true;
      if (a < b - gap) a = b - gap, again = true;
    }
  }
  for (std::size_t n = 0; n < near.size(); ++n)
    for (const int m : {near[n].first, near[n].second})
      way_[n] +=
          turned_[static_cast<std::size_t>(m)] + restReach(shapes[static_cast<std::size_t>(m)]);
}

}  // namespace dynamy
