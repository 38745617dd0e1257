#include <algorithm>
#include <dynamy/stages/sweep.hpp>
#include <tuple>

namespace dynamy {
namespace {

constexpr int kMostPieces = 4096;
/// Work of the places at one end of a piece, in evaluations of all velocities.
constexpr double kPlaces = 0.5;
/// Slot 0 holds velocities of the beginning or of the end of the step, depending on the scheme.
/// Velocities at one end that are larger than at the other by this factor are examined separately …
constexpr double kFactor = 2.0;
/// … if they lead further than this many g_tol.
constexpr double kNoWay = 1e6;
/// A body is at a contact at gaps below this many g_tol.
constexpr double kNearBody = 1e3;
/// Of the largest velocity: a contact that closes faster is that of a fast body.
constexpr double kComparable = 0.1;
/// Of the step: a time too short to matter.
constexpr double kMoment = 1e-9;

/// Pieces that the path of a step of length dt needs for the fastest body; 0: nothing is fast.
int mostPieces(const MechanicalSystem& s, const Kinematics& k, double dt) {
  int n = 0;
  for (const NonSmoothElement* e : s.parts().contacts) n = std::max(n, e->piecesToSweep(k, dt));
  return n;
}

/// A gap law that looks beyond the end of the step may brake a fast body far from the contact.
/// Returns the middle of the step then, so that the halves come nearer to the contact.
Passing braked(const MechanicalSystem& s, const State& a, double dt) {
  const ContactSet& c = s.slot(0).contacts;
  const ImpactProblem& p = s.problem();
  if (p.contacts != &c || a.u.size() == 0) return {};
  const double fast = kComparable * a.u.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < c.law.size(); ++i) {
    const int row = c.row0[i];
    const auto r = static_cast<std::size_t>(row);
    if (c.law[i]->unilateral() && c.position[r] > kNearBody * s.gTol() && -p.gammaA[r] > fast &&
        p.Lambda(row) > 0.0)
      return {0.5 * dt, kMoment * dt, c.key[i]};
  }
  return {};
}

}  // namespace

Passing Sweep::look(const MechanicalSystem& s, const OneStep& scheme, const State& a,
                    const State& b) {
  const int n = std::min(pieces(s, a, b), kMostPieces);
  if (n == 0) return {};
  const double dt = b.t - a.t;
  path_.begin(dt, s.gTol(), s.parts().topology->requestedFrames().size());
  at_ = a;
  for (int k = 0; k <= n; ++k) {
    scheme.interpolate(s, a, b, static_cast<double>(k) / n, at_);
    evaluate(s, k == 0 ? a : k == n ? b : at_);
    path_.add(kinematics_);
  }
  if (const Passing p = search(s)) return p;
  // A scheme that sees contacts at the end of the step stops a body at the beginning of the step:
  // the second path continues with the velocities at the beginning.
  if (const Passing p = straight(s, a, dt, n)) return p;
  return braked(s, a, dt);
}

Passing Sweep::ahead(const MechanicalSystem& s, const State& a, double dt) {
  evaluate(s, a);
  const int n = std::min(mostPieces(s, kinematics_, dt), kMostPieces);
  return n > 0 ? straight(s, a, dt, n) : Passing{};
}

Passing Sweep::straight(const MechanicalSystem& s, const State& a, double dt, int pieces) {
  path_.begin(dt, s.gTol(), s.parts().topology->requestedFrames().size());
  at_ = a;
  for (int k = 0; k <= pieces; ++k) {
    evaluate(s, at_);
    path_.add(kinematics_);
    s.move(at_, a.u, dt / pieces);
  }
  return search(s);
}

Passing Sweep::search(const MechanicalSystem& s) {
  ++paths_;
  work_ += kPlaces * path_.pieces() * s.parts().topology->nu();
  Passing first;
  for (std::size_t i = 0; i < s.parts().contacts.size(); ++i) {
    const Passing p = s.parts().contacts[i]->firstPassing(path_, static_cast<int>(i));
    work_ += p.work;
    if (p.t < first.t) first = p;
  }
  return first;
}

int Sweep::pieces(const MechanicalSystem& s, const State& a, const State& b) {
  const double dt = b.t - a.t;
  int n = mostPieces(s, s.slot(0).kinematics, dt);
  const auto largest = [](const Eigen::VectorXd& u) {
    return u.size() > 0 ? u.cwiseAbs().maxCoeff() : 0.0;
  };
  const double uA = largest(a.u), uE = largest(b.u);
  for (const auto& [x, own, other] : {std::tuple{&a, uA, uE}, std::tuple{&b, uE, uA}}) {
    if (own <= kFactor * other || own * dt <= kNoWay * s.gTol()) continue;
    evaluate(s, *x);
    n = std::max(n, mostPieces(s, kinematics_, dt));
  }
  return n;
}

void Sweep::evaluate(const MechanicalSystem& s, const State& x) {
  if (!ready_) kinematics_.resize(*s.parts().topology), ready_ = true;
  kinematics_.evaluate(*s.parts().topology, x.t, view(x.q), view(x.u), view(x.memory),
                       s.parts().subset);
}

}  // namespace dynamy
