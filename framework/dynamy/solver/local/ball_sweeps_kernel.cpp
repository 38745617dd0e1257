#include <algorithm>
#include <cmath>
#include <dynamy/solver/local/ball_sweeps.hpp>

namespace dynamy {
namespace {

/// Contacts of balls from which packing pays, and from which they are divided into parts.
constexpr int kFew = 100, kUncut = 6000;
/// Most parts, and least contacts of a part: contacts between parts run on one thread.
constexpr int kMostParts = 8, kLeastContacts = 3000;
/// Relative rounding of unit vectors and their products.
constexpr double kSweepNoise = 1e-10;

double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool opposite(const double* a, const double* b) {
  return a[0] == -b[0] && a[1] == -b[1] && a[2] == -b[2];
}

/// The two numbers of M⁻¹ of a ball; false: the body is no ball.
bool isotropic(const MassMatrix& mass, const Segment& s, double& m, double& j) {
  const double* inverse = s.nu == 6 ? mass.inverseDiagonal(s.block) : nullptr;
  if (!inverse) return false;
  m = inverse[0], j = inverse[3];
  return inverse[1] == m && inverse[2] == m && inverse[4] == j && inverse[5] == j;
}

}  // namespace

bool BallSweeps::pack(const InclusionProblem& p, int i, Contact& out) {
  const ContactSet& c = *p.contacts;
  if (p.dim(i) != 3) return false;
  const SimpleSet set = p.law(i).simpleSet(p.input(i));
  if (set.shape != SimpleSet::Shape::friction) return false;
  const double* G = p.G->diagonalBlock(i);
  const double off =
      std::max({std::abs(G[1]), std::abs(G[2]), std::abs(G[5]), std::abs(G[4] - G[8])});
  if (!(G[0] > 0.0 && G[4] > 0.0 && off <= kSweepNoise * (G[0] + G[4]))) return false;
  out.rN = 1.0 / G[0], out.rT = 1.0 / G[4], out.mu = set.upper, out.row = p.row0(i);
  const auto at = static_cast<std::size_t>(i);
  const int first = c.segment0[at], count = c.segment0[at + 1] - first;
  if (count < 1 || count > 2) return false;
  // A contact with one segment has only B; its other side is the ground.
  const Segment* segment = c.segment.data() + first;
  const Segment& B = segment[count - 1];
  const MassMatrix& mass = p.G->mass();
  if (!isotropic(mass, B, out.mb, out.jb)) return false;
  const double* W = c.W.data() + B.w;
  std::copy(W, W + 3, out.n), std::copy(W + 6, W + 9, out.t), std::copy(W + 12, W + 15, out.s);
  std::copy(W + 9, W + 12, out.tb), std::copy(W + 15, W + 18, out.sb);
  const double small = kSweepNoise * std::sqrt(dot(out.tb, out.tb));
  if (!(std::sqrt(dot(W + 3, W + 3)) <= small)) return false;
  out.ub = B.u0;
  out.ua = -1, out.ma = out.ja = 0.0;
  std::fill_n(out.ta, 3, 0.0), std::fill_n(out.sa, 3, 0.0);
  if (count == 1) return true;
  const Segment& A = segment[0];
  if (A.block == B.block || !isotropic(mass, A, out.ma, out.ja)) return false;
  W = c.W.data() + A.w;
  std::copy(W + 9, W + 12, out.ta), std::copy(W + 15, W + 18, out.sa);
  out.ua = A.u0;
  return opposite(W, out.n) && opposite(W + 6, out.t) && opposite(W + 12, out.s) &&
         std::sqrt(dot(W + 3, W + 3)) <= kSweepNoise * std::sqrt(dot(out.ta, out.ta));
}

int BallSweeps::partOf(const Contact& c, int velocities) const {
  const int parts = static_cast<int>(first_.size()) - 2;
  const auto of = [&](int u) {
    return static_cast<int>(static_cast<std::int64_t>(u) * parts / velocities);
  };
  const int b = of(c.ub);
  return c.ua < 0 || of(c.ua) == b ? b : parts;
}

bool BallSweeps::prepare(const InclusionProblem& p) {
  contacts_.clear();
  if (p.size() < kFew || !p.G->hasBodies() || !p.G->sweepVelocities()) return false;
  given_.clear(), rest_.clear();
  for (int i = 0; i < p.size(); ++i)
    if (Contact c; pack(p, i, c))
      given_.push_back(c);
    else
      rest_.push_back(i);
  const int size = static_cast<int>(given_.size());
  if (size < kFew) return false;
  // Sort contacts by part and keep their order within each part.
  const MassMatrix& mass = p.G->mass();
  const int velocities = mass.u0(mass.blocks() - 1) + mass.nu(mass.blocks() - 1);
  const int parts = size < kUncut ? 1 : std::min(kMostParts, size / kLeastContacts);
  first_.assign(static_cast<std::size_t>(parts) + 2, 0);
  for (const Contact& c : given_) ++first_[static_cast<std::size_t>(partOf(c, velocities)) + 1];
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  contacts_.resize(given_.size());
  // Filling backwards moves first_ from the end of each part to its begin.
  for (auto c = given_.rbegin(); c != given_.rend(); ++c)
    contacts_[static_cast<std::size_t>(
        --first_[static_cast<std::size_t>(partOf(*c, velocities)) + 1])] = *c;
  for (std::size_t k = 0; k + 1 < first_.size(); ++k) first_[k] = first_[k + 1];
  first_.back() = static_cast<int>(contacts_.size());
  return true;
}

void BallSweeps::solve(const Contact& c, const double* free, double* Lambda, double* v) const {
  double ground[6] = {};
  double* const a = c.ua < 0 ? ground : v + c.ua;
  double* const b = v + c.ub;
  const double dv[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const double N = std::max(0.0, Lambda[0] - c.rN * (free[0] + dot(c.n, dv)));
  double T = Lambda[1] - c.rT * (free[1] + dot(c.t, dv) + dot(c.tb, b + 3) + dot(c.ta, a + 3));
  double S = Lambda[2] - c.rT * (free[2] + dot(c.s, dv) + dot(c.sb, b + 3) + dot(c.sa, a + 3));
  const double limit = c.mu * N, square = T * T + S * S;
  if (square > limit * limit) {
    const double part = limit / std::sqrt(square);
    T *= part, S *= part;
  }
  const double dN = N - Lambda[0], dT = T - Lambda[1], dS = S - Lambda[2];
  Lambda[0] = N, Lambda[1] = T, Lambda[2] = S;
  for (int k = 0; k < 3; ++k) {
    const double impulse = c.n[k] * dN + c.t[k] * dT + c.s[k] * dS;
    b[k] += c.mb * impulse, a[k] -= c.ma * impulse;
    b[3 + k] += c.jb * (c.tb[k] * dT + c.sb[k] * dS);
    a[3 + k] += c.ja * (c.ta[k] * dT + c.sa[k] * dS);
  }
}

void BallSweeps::sweep(const InclusionProblem& p, double* Lambda) {
  double* v = p.G->sweepVelocities();
  const auto part = [&](int k) {
    for (int i = first_[static_cast<std::size_t>(k)]; i < first_[static_cast<std::size_t>(k) + 1];
         ++i) {
      const Contact& c = contacts_[static_cast<std::size_t>(i)];
      solve(c, p.c.data() + c.row, Lambda + c.row, v);
    }
  };
  const int parts = static_cast<int>(first_.size()) - 2;
  if (p.workers && parts > 1)
    p.workers->run(parts, part);
  else
    for (int k = 0; k < parts; ++k) part(k);
  part(parts);
}

}  // namespace dynamy
