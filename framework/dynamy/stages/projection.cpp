#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/stages/contact_subset.hpp>
#include <dynamy/stages/impact_detection.hpp>
#include <dynamy/stages/projection.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Most turns, and most of them that do not halve the largest violation: linear problems that
/// contradict each other from turn to turn lead further and further away.
constexpr int kMostProjections = 12, kMostIdle = 3;
/// Gaps that the way of a few violations can close take part in a projection, but only the part of the
/// scene's length that follows: a joint that is off by much more would bring in all bodies.
constexpr double kWay = 8.0, kFarthest = 0.1;
/// Most rows for which contacts are closed before their impact.
constexpr int kMostTouched = 200;
/// Share of the largest diagonal entry that is added to the diagonal: redundant rows then share.
constexpr double kRedundantRow = 1e-10;

/// Part of an overlap by which it grows in a step, at least, where a rebound does not remove it, and of
/// the scene's length which it reaches before it is repaired: that lifts bodies, and is no exact work.
constexpr double kGrows = 0.01, kCreeps = 1e-3;
/// Part of its way in a step by which a body that slides round closes a contact, at most: more is an
/// impact.
constexpr double kSlides = 0.1;

/// Normal impulse of remembered contact i, 0 if it had none.
double carried(const RememberedImpulses& impulses, int i) {
  if (i < 0) return 0.0;
  const int first = impulses.first[static_cast<std::size_t>(i)];
  const bool any = impulses.first[static_cast<std::size_t>(i) + 1] > first;
  return any ? impulses.Lambda[static_cast<std::size_t>(first)] : 0.0;
}

/// Normal velocity of contact i at the velocities u, and the largest of them in its systems.
struct Approach {
  double gamma = 0.0, speed = 0.0;
};
Approach approach(const ContactSet& c, int i, const Eigen::VectorXd& u) {
  const auto at = static_cast<std::size_t>(i);
  Approach out{c.chi[static_cast<std::size_t>(c.row0[at])]};
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const auto own = u.segment(s.u0, s.nu);
    out.gamma += ConstVec(c.W.data() + s.w, s.nu).dot(own);
    out.speed = std::max(out.speed, own.cwiseAbs().maxCoeff());
  }
  return out;
}

/// True: contact i has restitution.
bool rebounds(const ContactSet& c, int i) {
  double epsilon[kMostRows] = {};
  c.law[static_cast<std::size_t>(i)]->epsilon(c.dim(i), epsilon);
  return epsilon[0] > 0.0;
}

/// True: contact i, at the state x, does not remove an overlap itself. It has no restitution; or it has
/// carried in the last step and approaches all the same, as where a body slides round within a bore.
/// Such an overlap is less than the way of a step, grows, and is above kCreeps of the scene's length;
/// any other is removed by the rebound.
bool rests(const ContactSet& c, int i, const State& x, double length) {
  const auto at = static_cast<std::size_t>(i);
  if (!c.law[at]->unilateral()) return false;
  if (!rebounds(c, i)) return true;
  const Approach now = approach(c, i, x.u);
  const double overlap = -c.position[static_cast<std::size_t>(c.row0[at])];
  const double way = x.impulses.dt * now.speed, closes = -x.impulses.dt * now.gamma;
  if (!(overlap > kCreeps * length) || overlap > way || closes < kGrows * overlap ||
      closes > kSlides * way)
    return false;
  const std::vector<ContactKey>& last = x.impulses.key;  // rarely searched: no index is worth it
  const auto found = std::find(last.begin(), last.end(), c.key[at]);
  return found != last.end() && carried(x.impulses, static_cast<int>(found - last.begin())) > 0.0;
}

/// √(wᵀM⁻¹w), added up over the blocks, of the first row w of contact i.
double rootOfG(const ContactSet& c, const MassMatrix& mass, int i) {
  double root = 0.0;
  const auto at = static_cast<std::size_t>(i);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const ConstVec w(c.W.data() + s.w, s.nu);
    const ConstBlock inverse = mass.inverse(s.block);
    double G = 0.0;
    for (int j = 0; j < s.nu; ++j) G += w[j] * inverse.row(j).dot(w);
    root += std::sqrt(std::max(0.0, G));
  }
  return root;
}

}  // namespace

double largestOverlap(const ContactSet& c, const State& x, double length) {
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const double overlap =
        -c.position[static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)])];
    if (overlap > worst && rests(c, i, x, length)) worst = overlap;
  }
  return worst;
}

double largestViolation(const ContactSet& c, const State& x, double length) {
  double worst = largestOverlap(c, x, length);
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (c.law[at]->unilateral() || c.law[at]->rowKind(0) != RowKind::joint) continue;
    for (int r = c.row0[at]; r < c.row0[at + 1]; ++r)
      worst = std::max(worst, std::abs(c.position[static_cast<std::size_t>(r)]));
  }
  return worst;
}

void Projection::select(const MechanicalSystem& s, const ContactSet& all, const State& x,
                        Level level) {
  contacts_.clear();
  remembered_.build(x.impulses.key);
  // Overlaps are repaired and contacts touched at a midpoint. There joints may have errors by
  // design and do not move. Contacts that carry do not move either while others are touched.
  const bool midpoint = level == Level::overlap || level == Level::touch;
  for (int i = 0; i < all.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const SetValuedForceLaw& law = *all.law[at];
    const bool carries =
        law.unilateral() && carried(x.impulses, remembered_.find(all.key[at])) > 0.0;
    if (law.unilateral()) {
      if (level == Level::touch && (isTouched(all.key[at]) || carries)) {
        append(all, i, 1, bilateral_, contacts_);
        if (!isTouched(all.key[at])) contacts_.position.back() = 0.0;
      } else if (level != Level::velocity) {
        if (rests(all, i, x, s.limits.length)) append(all, i, 1, unilateral_, contacts_);
      } else if (carries) {
        append(all, i, all.dim(i), law, contacts_);
      }
    } else if (law.rowKind(0) == RowKind::joint ||
               (law.rowKind(0) == RowKind::rate && level == Level::velocity)) {
      append(all, i, all.dim(i), bilateral_, contacts_);
      if (midpoint) std::fill_n(contacts_.position.end() - all.dim(i), all.dim(i), 0.0);
    }
  }
  const auto n = static_cast<std::size_t>(contacts_.rows());
  problem_.contacts = &contacts_, problem_.G = &delassus_, problem_.stop = s.limits.stop;
  problem_.work = s.limits.work;
  problem_.c.assign(contacts_.position.begin(), contacts_.position.end());
  problem_.gammaA.assign(n, 0.0), problem_.cNoise.assign(n, 0.0), Lambda_.assign(n, 0.0);
}

bool Projection::solve(const Evaluation& e, InclusionSolver& solver) {
  delassus_.assemble(contacts_, e.mass);
  problem_.gammaFree = problem_.c;
  problem_.uRef = 0.0;
  for (const double c : problem_.c) problem_.uRef = std::max(problem_.uRef, std::abs(c));
  const auto n = static_cast<Eigen::Index>(Lambda_.size());
  const SolveReport solved = solver.solve(problem_, {Lambda_.data(), n});
  count(problem_, solved);
  delta_.setZero(e.h.size());
  delassus_.addVelocity(Lambda_.data(), view(delta_));
  return solved.ok();
}

bool Projection::positions(MechanicalSystem& s, InclusionSolver& solver, State& x, double tolerance,
                           int slot) {
  return repair(s, &solver, x, tolerance, slot, Level::position);
}

bool Projection::overlaps(MechanicalSystem& s, InclusionSolver& solver, State& x, double tolerance,
                          int slot) {
  return repair(s, &solver, x, tolerance, slot, Level::overlap);
}

bool Projection::touch(MechanicalSystem& s, State& x, const std::vector<ContactKey>& keys,
                       double tolerance, int slot) {
  touched_ = keys, untouched_ = x;
  if (repair(s, nullptr, x, tolerance, slot, Level::touch)) return true;
  x = untouched_;
  return false;
}

bool Projection::isTouched(ContactKey key) const {
  return std::binary_search(touched_.begin(), touched_.end(), key);
}

double Projection::largestGap(const ContactSet& c) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < c.g.size(); ++i)  // open contacts, too
    if (isTouched(c.candidateKey[i])) largest = std::max(largest, c.g[i]);
  return largest;
}

/// δ = M⁻¹W Λ with g + Wᵀδ = 0 for the rows that have to be closed or held; other contacts move
/// along. In this linear system redundant rows share; contradictory rows leave gaps.
bool Projection::close(const Evaluation& e) {
  int rows = 0;
  for (int i = 0; i < contacts_.size(); ++i)
    if (contacts_.law[static_cast<std::size_t>(i)] == &bilateral_) rows += contacts_.dim(i);
  if (rows == 0 || rows > kMostTouched) return false;
  const Eigen::Index nu = e.h.size();
  W_.setZero(nu, rows), MInvW_.resize(nu, rows);
  Eigen::VectorXd g(rows);
  int column = 0;
  for (int i = 0; i < contacts_.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (contacts_.law[at] != &bilateral_) continue;
    for (int r = 0; r < contacts_.dim(i); ++r, ++column) {
      g[column] = contacts_.position[static_cast<std::size_t>(contacts_.row0[at] + r)];
      for (int k = contacts_.segment0[at]; k < contacts_.segment0[at + 1]; ++k) {
        const Segment& segment = contacts_.segment[static_cast<std::size_t>(k)];
        const double* w =
            contacts_.W.data() + segment.w + static_cast<std::ptrdiff_t>(r) * segment.nu;
        for (int j = 0; j < segment.nu; ++j) W_(segment.u0 + j, column) += w[j];
      }
      e.mass.applyInverse({W_.col(column).data(), nu}, {MInvW_.col(column).data(), nu});
    }
  }
  // Rows of a contact touch the velocities of its own bodies alone.
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(rows, rows);
  column = 0;
  for (int i = 0; i < contacts_.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (contacts_.law[at] != &bilateral_) continue;
    const int dim = contacts_.dim(i);
    for (int k = contacts_.segment0[at]; k < contacts_.segment0[at + 1]; ++k) {
      const Segment& segment = contacts_.segment[static_cast<std::size_t>(k)];
      const double* w = contacts_.W.data() + segment.w;
      const Eigen::Map<const Eigen::MatrixXd> own(w, segment.nu, dim);
      for (int c = 0; c < rows; ++c)
        for (int r = 0; r < dim; ++r)
          G(column + r, c) += own.col(r).dot(MInvW_.col(c).segment(segment.u0, segment.nu));
    }
    column += dim;
  }
  G.diagonal().array() += kRedundantRow * G.diagonal().maxCoeff();
  delta_ = MInvW_ * -G.ldlt().solve(g);
  return true;
}

bool Projection::repair(MechanicalSystem& s, InclusionSolver* solver, State& x, double tolerance,
                        int slot, Level level) {
  double reach = 0.0;  // gaps up to this take part
  if (level == Level::touch)
    for (const double g : s.slot(0).contacts.position) reach = std::max(reach, 2.0 * g);
  const auto violation = [&] {
    const ContactSet& c = s.evaluate(x, {.slot = slot, .reach = reach}).contacts;
    if (level == Level::touch)
      return std::max(largestOverlap(c, x, s.limits.length), largestGap(c));
    return level == Level::overlap ? largestOverlap(c, x, s.limits.length)
                                   : largestViolation(c, x, s.limits.length);
  };
  double worst = violation(), least = worst, goal = worst;
  int idle = 0;
  Effort effort = s.limits.effort;
  if (worst > tolerance) start_ = x;
  const auto giveUp = [&] {  // with what came nearest
    if (worst > least || !std::isfinite(worst)) x = start_;
    return false;
  };
  for (int turn = 0; worst > tolerance; ++turn) {
    if (turn == kMostProjections || idle == kMostIdle || !std::isfinite(worst)) return giveUp();
    const double way = std::min(kWay * worst, kFarthest * s.limits.length);
    const Evaluation& e = s.evaluate(x, {.slot = slot, .reach = std::max(reach, way)});
    select(s, e.contacts, x, level);
    problem_.effort = effort;
    const bool solved = level == Level::touch ? close(e) : solve(e, *solver);
    const int most = effort == Effort::little ? 0 : 2;
    if (!solved && (level == Level::touch || turn > most)) return giveUp();
    // The next turn corrects the rest.
    if (!solved) effort = std::max(effort, Effort::retried);
    if (worst <= least) start_ = x, least = worst;
    delta_ /= kDisplacementTime;
    const double t = x.t;
    s.move(x, delta_, kDisplacementTime);
    x.t = t;
    const double before = worst;
    worst = violation();
    if (level == Level::touch && !(worst < 0.5 * before)) return giveUp();
    if (!solved && !(worst < before)) return giveUp();  // contacts and joints contradict each other
    idle = worst < 0.5 * goal ? 0 : idle + 1;
    if (idle == 0) goal = worst;
  }
  return true;
}

bool Projection::offVelocities(const State& x) {
  const ContactSet& c = contacts_;
  c.gamma(view(x.u), {problem_.c.data(), static_cast<Eigen::Index>(problem_.c.size())});
  bool off = false;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int r = 0; r < c.dim(i); ++r) {
      const auto row = static_cast<std::size_t>(c.row0[at] + r);
      double sum = std::abs(c.chi[row]);
      for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
        const Segment& segment = c.segment[static_cast<std::size_t>(k)];
        const double* w = c.W.data() + segment.w + static_cast<std::ptrdiff_t>(r) * segment.nu;
        for (int j = 0; j < segment.nu; ++j) sum += std::abs(w[j] * x.u[segment.u0 + j]);
      }
      problem_.cNoise[row] = 8.0 * std::numeric_limits<double>::epsilon() * sum;
      off = off || std::abs(problem_.c[row]) > problem_.cNoise[row];
    }
  }
  return off;
}

double Projection::closing(const ContactSet& all, int i, double gamma, double dt) {
  const double g = all.position[static_cast<std::size_t>(all.row0[static_cast<std::size_t>(i)])];
  return -gamma - std::max(0.0, g) / dt;
}

std::optional<SolveReport> Projection::impact(const MechanicalSystem& s, InclusionSolver& solver,
                                              State& x, double dt, Jump& jump) {
  const Evaluation& e = s.slot(0);
  const ContactSet& all = e.contacts;
  // Forces change velocities by δ = M⁻¹hΔt. They change γ_N of a contact by no more than the
  // largest number in δ, which may be the rate of a small part, and by no more than √(wᵀM⁻¹w)
  // √(δᵀMδ), which joints reduce.
  const double largest = largestChange(s, dt);
  change_.resize(e.h.size());
  e.mass.applyInverse(view(e.h), view(change_));
  const double norm = dt * std::sqrt(std::max(0.0, e.h.dot(change_)));
  double least = 0.0;
  delta_.resize(all.rows());
  all.gamma(view(std::as_const(x.u)), view(delta_));
  bool any = false;
  contacts_.clear();
  for (int i = 0; i < all.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const SetValuedForceLaw& law = *all.law[at];
    if (!law.unilateral() && !holds(law.rowKind(0))) continue;
    // A contact with restitution takes part once it is closed.
    const double g = all.position[static_cast<std::size_t>(all.row0[at])];
    if (law.unilateral() && rebounds(all, i) && g > s.gTol()) continue;
    append(all, i, all.dim(i), law, contacts_);
    const double closes = law.unilateral() ? closing(all, i, delta_[all.row0[at]], dt) : 0.0;
    if (closes <= 0.0) continue;
    const double explained = kImpactSteps * std::min(largest, norm * rootOfG(all, e.mass, i));
    least = std::max(least, explained);
    any = any || closes > explained;
  }
  if (!any) return std::nullopt;
  const auto n = static_cast<std::size_t>(contacts_.rows());
  problem_.contacts = &contacts_, problem_.G = &delassus_, problem_.stop = s.limits.stop;
  problem_.work = s.limits.work;
  problem_.effort = Effort::retried;  // the scheme tries again with half the step
  problem_.c.assign(n, 0.0), problem_.gammaA.assign(n, 0.0), problem_.cNoise.assign(n, 0.0);
  Lambda_.assign(n, 0.0);
  offVelocities(x);
  problem_.gammaFree = problem_.gammaA = problem_.c;
  problem_.uRef = least;
  for (int i = 0; i < contacts_.size(); ++i) {
    const auto first = static_cast<std::size_t>(contacts_.row0[static_cast<std::size_t>(i)]);
    if (!problem_.law(i).unilateral()) continue;
    problem_.uRef = std::max(problem_.uRef, -problem_.gammaA[first]);
    const double g = contacts_.position[first];
    if (g > s.gTol()) problem_.gammaFree[first] += g / dt;
  }
  delassus_.assemble(contacts_, e.mass);
  const SolveReport solved =
      s.parts().impactLaw->solve(problem_, solver, {Lambda_.data(), static_cast<Eigen::Index>(n)});
  delassus_.addVelocity(Lambda_.data(), view(x.u));
  works(x, jump);
  return solved;
}

/// Works of the impact that has just led to x.u: ΣΛγ̄ with γ̄ = ½(γ⁻ + γ⁺).
void Projection::works(const State& x, Jump& jump) {
  jump.u = x.u;
  StepWorks& w = jump.works = {};
  w.given = true;
  contacts_.gamma(view(x.u), {problem_.c.data(), static_cast<Eigen::Index>(problem_.c.size())});
  for (int i = 0; i < contacts_.size(); ++i)
    for (int r = 0; r < contacts_.dim(i); ++r) {
      const auto row = static_cast<std::size_t>(problem_.row0(i) + r);
      w.book(problem_.law(i).rowKind(r), Lambda_[row],
             0.5 * (problem_.gammaA[row] + problem_.c[row]), contacts_.chi[row]);
    }
}

const double* Projection::percussions(ContactKey key) const {
  const auto at = std::find(contacts_.key.begin(), contacts_.key.end(), key);
  if (at == contacts_.key.end()) return nullptr;
  return Lambda_.data() + contacts_.row0[static_cast<std::size_t>(at - contacts_.key.begin())];
}

bool Projection::velocities(MechanicalSystem& s, InclusionSolver& solver, State& x, int slot) {
  const Evaluation& e = s.evaluate(x, {.slot = slot});
  select(s, e.contacts, x, Level::velocity);
  if (contacts_.size() == 0 || !offVelocities(x)) return true;
  problem_.effort = s.limits.effort;
  const bool ok = solve(e, solver);
  x.u += delta_;
  return ok;
}

}  // namespace dynamy
