#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/schemes/joints/condensed_contacts.hpp>
#include <dynamy/stages/contact_subset.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Slip below this multiple of its rounding does not count as driven.
constexpr double kDriving = 1e3;
/// Joints hold a contact if they leave less than this part of wᵀM⁻¹w: positions agree to 1e-10
/// lengths or so, and K has 1e-10 on the diagonal of the joints' rows.
constexpr double kHeld = 1e-8;

/// Column of contact i's row r, as nu numbers.
void column(const ContactSet& c, int i, int r, Eigen::VectorXd& w) {
  w.setZero();
  const auto at = static_cast<std::size_t>(i);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    for (int j = 0; j < s.nu; ++j)
      w[s.u0 + j] = c.W[static_cast<std::size_t>(s.w + static_cast<std::ptrdiff_t>(r) * s.nu + j)];
  }
}

/// wᵀM⁻¹w of the normal of contact i.
double freeG(const ContactSet& c, const MassMatrix& mass, int i) {
  double G = 0.0;
  for (int k = c.segment0[static_cast<std::size_t>(i)];
       k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const ConstVec w(c.W.data() + s.w, s.nu);
    const ConstBlock inverse = mass.inverse(s.block);
    for (int j = 0; j < s.nu; ++j) G += w[j] * inverse.row(j).dot(w);
  }
  return G;
}

}  // namespace

void CoupledContacts::list(const std::vector<ContactResponse>& responses, int n) {
  for (std::vector<int>& of : ofPart_) of.clear();
  for (int i = 0; i < n; ++i)
    for (const int p : responses[static_cast<std::size_t>(i)].parts) {
      if (static_cast<std::size_t>(p) >= ofPart_.size())
        ofPart_.resize(static_cast<std::size_t>(p) + 1);
      ofPart_[static_cast<std::size_t>(p)].push_back(i);
    }
}

const std::vector<int>& CoupledContacts::with(int i, const ContactResponse& response) {
  coupled_.assign(1, i);
  for (const int p : response.parts) {
    const std::vector<int>& of = ofPart_[static_cast<std::size_t>(p)];
    coupled_.insert(coupled_.end(), of.begin(), of.end());
  }
  std::sort(coupled_.begin(), coupled_.end());
  coupled_.erase(std::unique(coupled_.begin(), coupled_.end()), coupled_.end());
  return coupled_;
}

void CondensedContacts::begin(const MechanicalSystem& s, const State& x, double dt) {
  contacts_.clear(), Lambda_.clear(), closed_.clear(), asked_.clear();
  const ContactSet& all = s.slot(0).contacts;
  for (int i = 0; i < all.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (all.position[static_cast<std::size_t>(all.row0[at])] <= s.gTol())
      closed_.push_back(all.key[at]);
  }
  std::sort(closed_.begin(), closed_.end());
  last_ = x.impulses;
  ofLast_.build(last_.key);
  const double scale = last_.dt > 0.0 ? dt / last_.dt : 0.0;
  for (double& L : last_.Lambda) L *= scale;
  dt_ = dt;
  for (std::size_t i = 0; i < last_.key.size(); ++i)
    if (last_.first[i + 1] > last_.first[i] &&
        last_.Lambda[static_cast<std::size_t>(last_.first[i])] > 0.0)
      asked_.push_back(last_.key[i]);
  std::sort(asked_.begin(), asked_.end());
  impulse_.setZero(x.u.size());
}

bool CondensedContacts::asks(const MechanicalSystem& s, int i) const {
  const ContactSet& all = s.slot(0).contacts;
  const auto at = static_cast<std::size_t>(i);
  return !all.law[at]->unilateral() ||
         !(all.position[static_cast<std::size_t>(all.row0[at])] > s.gTol()) ||
         !staysOpen(all, i, view(uE_), dt_) ||
         std::binary_search(asked_.begin(), asked_.end(), all.key[at]);
}

bool CondensedContacts::misses(const MechanicalSystem& s, const State& xA,
                               const Eigen::VectorXd& v) {
  if (few_) return false;
  const ContactSet& all = s.slot(0).contacts;
  uE_ = 2.0 * v - xA.u;
  for (int i = 0; i < all.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double g = all.position[static_cast<std::size_t>(all.row0[at])];
    if (all.law[at]->unilateral() && g > s.gTol() &&
        g / dt_ + gapRate(all, i, view(std::as_const(uE_))).gamma < 0.0 &&
        !std::binary_search(asked_.begin(), asked_.end(), all.key[at]))
      return true;
  }
  return false;
}

double CondensedContacts::start(ContactKey key, int row) const {
  const int found = ofLast_.find(key);
  if (found < 0) return 0.0;
  const auto i = static_cast<std::size_t>(found);
  const int at = last_.first[i] + row;
  return at < last_.first[i + 1] ? last_.Lambda[static_cast<std::size_t>(at)] : 0.0;
}

void CondensedContacts::select(const MechanicalSystem& s, const State& xA, const Eigen::VectorXd& v,
                               double dt) {
  if (contacts_.size() > 0) {  // impulses of the last turn
    last_.key = contacts_.key, last_.first = contacts_.row0, last_.Lambda = Lambda_;
    std::swap(ofLast_, ofPresent_);
  }
  const ContactSet& all = s.slot(0).contacts;
  contacts_.clear();
  few_ = !worthLeavingOut(all.size(), all.size());
  if (!few_) {
    uE_ = 2.0 * v - xA.u;
    int aside = 0;
    for (int i = 0; i < all.size(); ++i) aside += asks(s, i) ? 0 : 1;
    few_ = !worthLeavingOut(aside, all.size());
  }
  for (int i = 0; i < all.size(); ++i) {
    const SetValuedForceLaw& law = *all.law[static_cast<std::size_t>(i)];
    if ((law.unilateral() || law.rowKind(0) != RowKind::joint) && (few_ || asks(s, i)))
      append(all, i, all.dim(i), law, contacts_);
  }
  if (!few_) {
    asked_.insert(asked_.end(), contacts_.key.begin(), contacts_.key.end());
    std::sort(asked_.begin(), asked_.end());
    asked_.erase(std::unique(asked_.begin(), asked_.end()), asked_.end());
  }
  ofPresent_.build(contacts_.key);
  const auto n = static_cast<std::size_t>(contacts_.rows());
  Lambda_.assign(n, 0.0);
  impulse_.setZero(xA.u.size()), w_.resize(xA.u.size());
  for (int i = 0; i < contacts_.size(); ++i)
    for (int r = 0; r < contacts_.dim(i); ++r) {
      const auto row = static_cast<std::size_t>(contacts_.row0[static_cast<std::size_t>(i)] + r);
      Lambda_[row] = start(contacts_.key[static_cast<std::size_t>(i)], r);
      column(contacts_, i, r, w_);
      impulse_ += Lambda_[row] * w_;
    }
  problem_.contacts = &contacts_, problem_.G = &delassus_, problem_.dt = dt;
  problem_.stop = s.limits.stop, problem_.work = s.limits.work;
  problem_.gammaA.assign(n, 0.0), problem_.gammaFree.assign(n, 0.0), problem_.c.assign(n, 0.0);
  problem_.cNoise.assign(n, 0.0);
  if (n > 0) contacts_.gamma(view(xA.u), {problem_.gammaA.data(), contacts_.rows()});
}

double CondensedContacts::aim(int i, double gTol) const {
  const auto at = static_cast<std::size_t>(i);
  const auto first = static_cast<std::size_t>(contacts_.row0[at]);
  double epsilon[kMostRows] = {};
  problem_.law(i).epsilon(problem_.dim(i), epsilon);
  const double position = contacts_.position[first], g = position > gTol ? position : 0.0;
  const double begin = problem_.gammaA[first];
  if (epsilon[0] > 0.0 && begin < 0.0 &&
      !std::binary_search(closed_.begin(), closed_.end(), contacts_.key[at]))
    return g / dt_ + 4.0 * (std::abs(problem_.gammaFree[first]) + std::abs(begin));
  return g / dt_ + (1.0 - epsilon[0]) * std::max(0.0, begin);
}

/// Adds the aims of the contacts and sets the scales of the problem.
void CondensedContacts::pose(const MechanicalSystem& s) {
  // Where all contacts open or wait, they require nothing above rounding: forces set the scale.
  double uRef = std::max(std::numeric_limits<double>::min(), largestChange(s, dt_));
  for (int i = 0; i < contacts_.size(); ++i) {
    const auto first = static_cast<std::size_t>(contacts_.row0[static_cast<std::size_t>(i)]);
    if (problem_.law(i).unilateral()) problem_.gammaFree[first] += aim(i, s.gTol());
    const bool rate = problem_.law(i).rowKind(0) == RowKind::rate;
    if (rate || std::binary_search(meanSlip_.begin(), meanSlip_.end(),
                                   contacts_.key[static_cast<std::size_t>(i)]))
      for (std::size_t r = first + (rate ? 0 : 1);
           r < first + static_cast<std::size_t>(contacts_.dim(i)); ++r)
        problem_.gammaFree[r] += problem_.gammaA[r];
    uRef = std::max(uRef, -problem_.gammaFree[first]);
  }
  problem_.uRef = uRef, problem_.corrected = Corrected::inIteration;
  for (int i = 0; i < contacts_.size(); ++i)
    if (held_[static_cast<std::size_t>(i)] > 0.0) {
      const auto first = problem_.gammaFree.begin() + contacts_.row0[static_cast<std::size_t>(i)];
      std::fill(first, first + contacts_.dim(i), 0.0), *first = uRef;
    }
  for (double& noise : problem_.cNoise)
    noise = 16.0 * std::numeric_limits<double>::epsilon() * uE_.cwiseAbs().maxCoeff();
}

/// Finds contacts at places that joints hold, such as a corner on a hinge: no force along the
/// normal moves them, wᵀK⁻¹w vanishes against wᵀM⁻¹w. Their gap is that of the joint, which carries
/// the load in their place: they get no force. If they had to open by their overlap from rounding,
/// there would be no solution with the joint.
void CondensedContacts::findHeld(const MechanicalSystem& s, const JointNewton& newton) {
  held_.assign(static_cast<std::size_t>(contacts_.size()), 0.0);
  for (int i = 0; i < contacts_.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!problem_.law(i).unilateral()) continue;
    const double free = freeG(contacts_, s.slot(0).mass, i);
    if (std::abs(newton.along(contacts_, i, 0, response_[at], 0)) <= kHeld * free) held_[at] = free;
  }
}

/// G from the responses to all rows; the effect G old_ of the old impulses is subtracted from
/// γ_free.
BlockRows CondensedContacts::condensed(const JointNewton& newton) {
  BlockRows G = delassus_.release();
  G.clear();
  coupled_.list(response_, contacts_.size());
  for (int i = 0; i < contacts_.size(); ++i) {
    const bool held = held_[static_cast<std::size_t>(i)] > 0.0;
    for (const int j : coupled_.with(i, response_[static_cast<std::size_t>(i)])) {
      if (held && i != j) continue;
      const ContactResponse& response = response_[static_cast<std::size_t>(j)];
      const auto value0 = static_cast<std::ptrdiff_t>(G.value.size());
      for (int r = 0; r < contacts_.dim(i); ++r)
        for (int m = 0; m < contacts_.dim(j); ++m) {
          const int row = contacts_.row0[static_cast<std::size_t>(i)] + r,
                    other = contacts_.row0[static_cast<std::size_t>(j)] + m;
          const double value = (2.0 + (r == 0 ? gapSlope_[static_cast<std::size_t>(i)] : 0.0)) *
                               newton.along(contacts_, i, r, response, m);
          G.value.push_back(value);
          problem_.gammaFree[static_cast<std::size_t>(row)] -=
              value * old_[static_cast<std::size_t>(other)];
        }
      const auto first = G.value.begin() + value0;
      if (held) {
        std::fill(first, G.value.end(), 0.0);
        for (int r = 0; r < contacts_.dim(i); ++r)
          G.value[static_cast<std::size_t>(value0 + r * (contacts_.dim(i) + 1))] =
              held_[static_cast<std::size_t>(i)];
      } else if (held_[static_cast<std::size_t>(j)] > 0.0) {
        std::fill(first, G.value.end(), 0.0);
      }
      if (i != j && std::all_of(first, G.value.end(), [](double x) { return x == 0.0; })) {
        G.value.erase(first, G.value.end());
        continue;
      }
      G.column.push_back(j), G.value0.push_back(value0);
    }
    G.first.push_back(static_cast<int>(G.column.size()));
  }
  return G;
}

/// Gaps move with the midpoint: γ_N^E + g/Δt gains Wᵀδ/2 where g counts.
void CondensedContacts::follow(const MechanicalSystem& s, const Eigen::VectorXd& dv) {
  gapSlope_.assign(static_cast<std::size_t>(contacts_.size()), 0.0);
  for (int i = 0; i < contacts_.size(); ++i) {
    const auto at = static_cast<std::size_t>(i),
               first = static_cast<std::size_t>(contacts_.row0[at]);
    if (!problem_.law(i).unilateral() || !(contacts_.position[first] > s.gTol())) continue;
    gapSlope_[at] = 0.5;
    for (int k = contacts_.segment0[at]; k < contacts_.segment0[at + 1]; ++k) {
      const Segment& segment = contacts_.segment[static_cast<std::size_t>(k)];
      for (int j = 0; j < segment.nu; ++j)
        problem_.gammaFree[first] +=
            0.5 * contacts_.W[static_cast<std::size_t>(segment.w + j)] * dv[segment.u0 + j];
    }
  }
}

SolveReport CondensedContacts::solve(const MechanicalSystem& s, InclusionSolver& solver,
                                     const State& xA, JointNewton& newton, Effort effort) {
  const int n = contacts_.rows();
  if (n == 0) return {};
  uE_ = 2.0 * (newton.equations.v + newton.dv) - xA.u;
  contacts_.gamma(view(std::as_const(uE_)), {problem_.gammaFree.data(), n});
  // G, row by row of blocks.
  const auto size = static_cast<std::size_t>(contacts_.size());
  follow(s, newton.dv);
  response_.resize(std::max(response_.size(), size));
  for (std::size_t i = 0; i < size; ++i)
    newton.respond(contacts_, static_cast<int>(i), response_[i]);
  findHeld(s, newton);
  old_ = Lambda_;
  delassus_.given(contacts_, condensed(newton));
  pose(s);
  problem_.effort = effort;
  const SolveReport report =
      s.parts().impactLaw->solve(problem_, solver, {Lambda_.data(), static_cast<Eigen::Index>(n)});
  for (std::size_t i = 0; i < size; ++i)
    for (int r = 0; r < contacts_.dim(static_cast<int>(i)); ++r) {
      const auto row = static_cast<std::size_t>(contacts_.row0[i] + r);
      if (Lambda_[row] != old_[row]) newton.add(response_[i], r, Lambda_[row] - old_[row]);
    }
  impulse_.setZero();
  for (int i = 0; i < contacts_.size(); ++i)
    for (int r = 0; r < contacts_.dim(i); ++r) {
      column(contacts_, i, r, w_);
      impulse_ +=
          Lambda_[static_cast<std::size_t>(contacts_.row0[static_cast<std::size_t>(i)] + r)] * w_;
    }
  return report;
}

bool CondensedContacts::frictionDrives(const Eigen::VectorXd& v, const State& xA) {
  meanSlip_.clear();
  uE_ = 2.0 * v - xA.u;
  std::vector<double>& gammaE = problem_.c;  // c is no longer used in this step
  if (contacts_.size() > 0)
    contacts_.gamma(view(std::as_const(uE_)), {gammaE.data(), contacts_.rows()});
  for (int i = 0; i < contacts_.size(); ++i) {
    if (!problem_.law(i).unilateral()) continue;
    const auto at = static_cast<std::size_t>(i);
    double work = 0.0, speed = 0.0, noise = 0.0;
    for (auto r = static_cast<std::size_t>(contacts_.row0[at]) + 1;
         r < static_cast<std::size_t>(contacts_.row0[at + 1]); ++r) {
      work += 0.5 * Lambda_[r] * (problem_.gammaA[r] + gammaE[r]);
      speed = std::max(speed, std::abs(problem_.gammaA[r]) + std::abs(gammaE[r]));
      noise = std::max(noise, problem_.cNoise[r]);
    }
    if (work > 0.0 && speed > kDriving * noise) meanSlip_.push_back(contacts_.key[at]);
  }
  std::sort(meanSlip_.begin(), meanSlip_.end());
  return !meanSlip_.empty();
}

const double* CondensedContacts::of(ContactKey key) const {
  const int i = ofPresent_.find(key);
  return i < 0 ? nullptr : Lambda_.data() + contacts_.row0[static_cast<std::size_t>(i)];
}

}  // namespace dynamy
