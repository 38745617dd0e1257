#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/located/phase/phase_fault.hpp>
#include <dynamy/located/switching/notches.hpp>
#include <dynamy/located/switching/status_decision.hpp>

namespace dynamy {
namespace {

constexpr double kDecided = 1e-8;  ///< of the velocities a decision requires: this counts as zero
constexpr double kClear = 1e3;     ///< least speed of slip in a decision over these velocities
constexpr double kFollows =
    1e-9;  ///< of a row: what others leave of it, where it follows from them

/// Row `row` of contact i, in the velocities of `blocks`; false: it acts on others, too.
bool readRow(const ContactSet& c, int i, int row, std::span<const Segment> blocks,
             Eigen::Ref<Eigen::VectorXd> out) {
  const auto at = static_cast<std::size_t>(i);
  out.setZero();
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    Eigen::Index first = 0;
    auto b = blocks.begin();
    while (b != blocks.end() && b->block != s.block) first += (b++)->nu;
    if (b == blocks.end()) return false;
    out.segment(first, s.nu) +=
        Eigen::Map<const Eigen::VectorXd>(c.W.data() + s.w + std::ptrdiff_t{row} * s.nu, s.nu);
  }
  return true;
}

/// True: the normal of contact i is a combination of rows that are held and act on the same bodies,
/// of normals and joints. It leaves only where they leave.
bool follows(const ContactSet& c, int i, const std::vector<char>& carries) {
  const auto at = static_cast<std::size_t>(i);
  const std::span<const Segment> blocks(c.segment.begin() + c.segment0[at],
                                        c.segment.begin() + c.segment0[at + 1]);
  Eigen::Index n = 0, rows = 0;
  for (const Segment& s : blocks) n += s.nu;
  Eigen::VectorXd own(n), row(n);
  readRow(c, i, 0, blocks, own);
  Eigen::MatrixXd held(n, 0);
  for (int k = 0; k < c.size(); ++k) {
    if (k == i || carries[static_cast<std::size_t>(k)] == 0) continue;
    const SetValuedForceLaw& law = *c.law[static_cast<std::size_t>(k)];
    for (int r = 0; r < c.dim(k); ++r) {
      const RowKind kind = law.rowKind(r);
      if (kind != RowKind::normal && !holds(kind)) continue;
      if (!readRow(c, k, r, blocks, row)) break;
      const double size = row.norm();
      if (!(size > 0.0)) continue;
      held.conservativeResize(n, rows + 1);
      held.col(rows++) = row / size;
    }
  }
  if (rows == 0) return false;
  PivotedQr qr(kFollows);
  qr.compute(held);
  return (held * qr.solve(own) - own).norm() <= kFollows * own.norm();
}

}  // namespace

void StatusDecision::chooseClosed(const OngoingEvent& at, double leaves) {
  const ContactSet& c = at.s.slot(0).contacts;
  gamma_.resize(c.rows());
  c.gamma(view(std::as_const(at.p.x.u)), view(gamma_));
  closed_.clear();
  gammaBefore_.resize(gamma_.size());
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    const int first = c.row0[i], d = c.dim(static_cast<int>(i));
    if (c.law[i]->unilateral() && gamma_[first] > leaves) continue;
    closed_.push_back(c.key[i]);
    gammaBefore_.segment(rows, d) = gamma_.segment(first, d);
    if (const double side = notchSide(c, i, gamma_.data() + first, at); side != 0.0)
      gammaBefore_[rows] = side * at.norm.speed();
    rows += d;
  }
  gammaBefore_.conservativeResize(rows);
  std::sort(closed_.begin(), closed_.end());
}

/// The problem of the contacts that take part at q + h_s u; null: a contact is not reported there.
ImpactProblem* StatusDecision::look(OngoingEvent& at, const Start& start) {
  MechanicalSystem& s = at.s;
  const State& x = at.p.x;
  look_ = x;
  look_.impulses = {};
  if (!start.plain) s.move(look_, x.u, start.lookAhead);
  // Without a jump accelerations continue: forces may reach a bound by the change of velocities.
  if (!start.plain && !start.jumped) look_.u += start.lookAhead * start.a;
  at.evaluate(look_, closed_, 1);
  look_.u = x.u;
  ImpactProblem& p = s.impactProblem(look_, start.lookAhead, 1);
  if (p.rows() == gammaBefore_.size()) return &p;
  const std::vector<ContactKey>& found = s.slot(1).contacts.key;
  at.result.fault = PhaseFault::kLost;
  for (const ContactKey key : closed_)
    if (std::find(found.begin(), found.end(), key) == found.end()) at.result.lost = key;
  return nullptr;
}

void StatusDecision::accelerationLevel(const OngoingEvent& at, const Start& start,
                                       InclusionProblem& p) {
  // Adds w̄ of γ̇ = Wᵀu̇ + w̄, times the unit of time, and sets the slip that a bound has released.
  const ContactSet& c = *p.contacts;
  for (std::size_t k = 0; k < p.gammaFree.size() && k < c.bias.size(); ++k)
    p.gammaFree[k] += start.lookAhead * c.bias[k];
  for (int i = 0; i < p.size() && start.released.direction != 0.0; ++i) {
    if (c.key[static_cast<std::size_t>(i)] != start.released.key) continue;
    const int t = p.law(i).rowKind(0) == RowKind::normal ? 1 : 0;
    gammaBefore_[p.row0(i) + t] = 2.0 * at.slipSpeed() * start.released.direction;
  }
}

double StatusDecision::speedOf(const InclusionProblem& p, const Block& b,
                               const Eigen::VectorXd& gamma) {
  ForceSet set;  // weights are 1 where it has none
  const int dim = p.dim(b.contact);
  forceSet(p.law(b.contact), {.dim = dim, .dt = 1.0}, set, b.first);
  return set.speed(std::min(b.slipRows, kMostRows - 1), gamma.data() + b.slip);
}

void StatusDecision::findBlocks(const InclusionProblem& p) {
  blocks_.clear();
  for (int i = 0; i < p.size(); ++i) {
    statusParts(p.law(i), p.dim(i), parts_);
    for (const auto& [first, rows] : parts_) {
      const int row = p.row0(i) + first;
      const int normal = first == 0 && p.law(i).rowKind(0) == RowKind::normal ? 1 : 0;
      const bool joint = holds(p.law(i).rowKind(first));
      blocks_.push_back({i, first, rows, row, row + normal, joint ? 0 : rows - normal});
    }
  }
}

void StatusDecision::pose(const OngoingEvent& at, const Start& start, InclusionProblem& p) {
  // Resting rows lose their residual; slips keep their direction and get a clear speed. After a
  // jump the turn of the rows is that of W over h_s, otherwise it is h_s w̄ at the end of h_s.
  const bool jumped = start.plain || start.jumped;
  const std::vector<HeldKey>& stopped = start.stopped;
  std::vector<double>& c = p.gammaFree;
  double asked = 0.0;
  findBlocks(p);
  for (Block& b : blocks_) {
    const HeldKey part{p.contacts->key[static_cast<std::size_t>(b.contact)], b.first};
    const bool stops = std::find(stopped.begin(), stopped.end(), part) != stopped.end();
    b.slips = !stops && b.slipRows > 0 && speedOf(p, b, gammaBefore_) > at.slipSpeed();
    for (int k = b.row; k < b.row + b.rows; ++k) {
      const auto row = static_cast<std::size_t>(k);
      const bool slips = b.slips && k >= b.slip;
      c[row] -= jumped ? gammaBefore_[k] : p.gammaA[row] - p.dt * p.contacts->bias[row];
      p.gammaA[row] = slips ? gammaBefore_[k] : 0.0;
      // Where nothing asks for a force, what is left is rounding, of which no slip begins.
      if (k >= b.slip && !(std::abs(c[row]) > p.cNoise[row])) c[row] = 0.0;
      if (!slips) asked = std::max(asked, std::abs(c[row]));
    }
    // Friction of this slip moves others: of that, what is smaller can no more be seen.
    ForceSet set;
    if (b.slips && forceSet(p.law(b.contact), p.input(b.contact), set, b.first) &&
        set.form == ForceSet::Form::given && std::isfinite(set.upper))
      asked = std::max(asked, kDecided * p.G->diagonalBlock(b.contact)[0] * set.upper);
  }
  if (!(asked > 0.0)) asked = 1e-12 * at.norm.speed();
  for (const Block& b : blocks_) {
    if (!b.slips) continue;
    Eigen::Map<Eigen::VectorXd> slip(c.data() + b.slip, b.slipRows);
    slip = gammaBefore_.segment(b.slip, b.slipRows);
    slip *= std::max(1.0, kClear * asked / speedOf(p, b, gammaBefore_));
  }
  p.c = c;
  p.uRef = asked;
}

void StatusDecision::decide(OngoingEvent& at, const Start& start, std::vector<Held>& held) {
  chooseClosed(at, start.leaves);
  held.clear();
  if (closed_.empty()) return;
  ImpactProblem* const posed = look(at, start);
  if (posed == nullptr) return;
  ImpactProblem& p = *posed;
  restInNotches(at.s.change(1).contacts, gammaBefore_, at);
  if (start.plain) accelerationLevel(at, start, p);
  pose(at, start, p);
  Vec Lambda = p.Lambda();
  Lambda.setZero();
  const SolveReport solved = at.solver.solve(p, Lambda);
  if (!solved.ok()) at.result.undecided = true, at.result.solved = solved;
  // ξ = GΛ + c, contact by contact.
  xi_.resize(gammaBefore_.size());
  p.G->begin(Lambda.data());
  for (int i = 0; i < p.size(); ++i) p.G->row(i, Lambda.data(), xi_.data() + p.row0(i));
  for (Eigen::Index k = 0; k < xi_.size(); ++k) xi_[k] += p.c[static_cast<std::size_t>(k)];
  readStatus(p, view(std::as_const(Lambda)), start, held);
}

void StatusDecision::readStatus(const InclusionProblem& p, ConstVec Lambda, const Start& start,
                                std::vector<Held>& held) const {
  // Closed: the percussion, as a change of velocity, exceeds the speed of leaving.
  const double decided = kDecided * p.uRef;
  std::vector<char> carries(static_cast<std::size_t>(p.size()), 1);
  const auto isUnilateral = [&](int i) { return p.law(i).rowKind(0) == RowKind::normal; };
  for (int i = 0; i < p.size(); ++i) {
    if (!isUnilateral(i)) continue;
    ForceSet set;  // of a contact that may pull
    const bool pulls = forceSet(p.law(i), p.input(i), set) && set.form == ForceSet::Form::normal;
    const double reserve = Lambda[p.row0(i)] - (pulls ? set.lower : 0.0);
    const double change = p.G->diagonalBlock(i)[0] * reserve;
    carries[static_cast<std::size_t>(i)] = change > std::max(xi_[p.row0(i)], decided) ? 1 : 0;
  }
  // A solver may leave redundant contacts without a force. They are as closed as the others.
  std::vector<char> closed = carries;
  for (int i = 0; i < p.size(); ++i)
    if (carries[static_cast<std::size_t>(i)] == 0 && std::abs(xi_[p.row0(i)]) <= decided)
      closed[static_cast<std::size_t>(i)] = follows(*p.contacts, i, carries) ? 1 : 0;
  for (const Block& b : blocks_)
    if (closed[static_cast<std::size_t>(b.contact)] != 0)
      held.push_back(status(p, Lambda, b, start));
}

Held StatusDecision::status(const InclusionProblem& p, ConstVec Lambda, const Block& b,
                            const Start& start) const {
  const SetValuedForceLaw& law = p.law(b.contact);
  Held h;
  h.key = p.contacts->key[static_cast<std::size_t>(b.contact)], h.first = b.first, h.rows = b.rows;
  for (int k = 0; k < b.rows && k < kMostRows; ++k)
    h.lambda[static_cast<std::size_t>(k)] = Lambda[b.row + k] / start.lookAhead;
  if (law.rowKind(0) == RowKind::normal && p.dim(b.contact) > 1)
    h.weight = Lambda[p.row0(b.contact)] / start.lookAhead;
  const Held* before = findHeld(start.held, HeldKey{h.key, h.first});
  if (before != nullptr) h.mutedUntil = before->mutedUntil;
  if (b.slipRows == 0) return h;
  ForceSet set;
  const bool idle = forceSet(law, p.input(b.contact), set, b.first) && set.idle();
  h.slips = b.slips || idle || speedOf(p, b, xi_) > kDecided * p.uRef;
  if (!h.slips) return h;
  const Eigen::VectorXd& slip = b.slips ? gammaBefore_ : xi_;
  h.sign = slip[b.slip] < 0.0 ? -1.0 : 1.0;
  if (b.slipRows == 1) return h;
  const double length = speedOf(p, b, slip);
  for (int k = 0; length > 0.0 && k < b.slipRows && k < kMostRows - 1; ++k)
    h.direction[static_cast<std::size_t>(k)] = slip[b.slip + k] / length;
  // A slip that is still starting keeps its turn so far; after an impact no slip is still starting.
  const bool goesOn = before != nullptr && before->starts && !start.impact;
  h.starts = !b.slips || goesOn;
  if (b.slips && h.starts) h.turned = before->turned, h.direction = before->direction;
  return h;
}

}  // namespace dynamy
