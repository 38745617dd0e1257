#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/held_rows.hpp>
#include <numeric>

namespace dynamy {
namespace {

/// Larger mass blocks, of trees, apply M⁻¹ themselves with less work.
constexpr int kSmallBlock = 6;

/// W column `row` += row `of` of contact `at`.
void addRow(const ContactSet& c, int at, int of, Eigen::MatrixXd& W, int row) {
  const auto i = static_cast<std::size_t>(at);
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(of) * s.nu;
    for (int j = 0; j < s.nu; ++j) W(s.u0 + j, row) += w[j];
  }
}

/// y = M⁻¹w, where w is not zero on these mass blocks alone; elsewhere y is left as it is.
void applyInverse(const MassMatrix& mass, std::span<const HeldRows::Moved> blocks, ConstVec w,
                  Vec y) {
  const auto isSmall = [](const HeldRows::Moved& p) { return p.nu <= kSmallBlock; };
  if (!std::all_of(blocks.begin(), blocks.end(), isSmall)) {
    mass.applyInverse(w, y);
    return;
  }
  for (const HeldRows::Moved& p : blocks) {
    if (const double* d = mass.inverseDiagonal(p.block)) {
      for (int i = 0; i < p.nu; ++i) y[p.u0 + i] = d[i] * w[p.u0 + i];
      continue;
    }
    const ConstBlock inverse = mass.inverse(p.block);
    for (int i = 0; i < p.nu; ++i) {
      double sum = 0.0;
      for (int j = 0; j < p.nu; ++j) sum += inverse(i, j) * w[p.u0 + j];
      y[p.u0 + i] = sum;
    }
  }
}

}  // namespace

int countRows(const std::vector<Held>& held, const Evaluation& e) {
  int n = 0;
  for (const Held& h : held) {
    const auto at = std::find(e.contacts.key.begin(), e.contacts.key.end(), h.key);
    if (h.rows > 0)
      n += h.rows;
    else if (at != e.contacts.key.end())
      n += e.contacts.dim(static_cast<int>(at - e.contacts.key.begin()));
  }
  return n;
}

bool HeldRows::read(const std::vector<Held>& held, const Evaluation& e, const Eigen::VectorXd& u,
                    PhaseFault& fault) {
  const ContactSet& c = e.contacts;
  const std::size_t n = held.size();
  index_.resize(n), sets_.resize(n), row0_.assign(n + 1, 0);
  std::size_t cursor = 0;
  for (std::size_t i = 0; i < n; ++i) {  // contacts come in the same order, with others between
    while (cursor < c.key.size() && c.key[cursor] != held[i].key) ++cursor;
    // A checkpoint may name a part that the contact does not have.
    const bool other =
        cursor < c.key.size() && held[i].first + held[i].rows > c.dim(static_cast<int>(cursor));
    if (cursor == c.key.size() || other) {
      fault.why = PhaseFault::kLost, fault.contact = held[i].key;
      return false;
    }
    index_[i] = static_cast<int>(cursor);
    row0_[i + 1] = row0_[i] + (held[i].rows > 0 ? held[i].rows : c.dim(index_[i]));
  }
  const int rows = row0_.back();
  Eigen::MatrixXd& W = present_.R;
  clear(u.size(), rows);
  gamma_.resize(rows), present_.r.resize(rows), position_.resize(rows), chi_.resize(rows);
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(index_[i]);
    for (int r = 0; r < dim(i); ++r) {
      const int row = row0_[i] + r, of = held[i].first + r;
      const auto from = static_cast<std::size_t>(c.row0[at] + of);
      addRow(c, index_[i], of, W, row);
      for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
        const Segment& s = c.segment[static_cast<std::size_t>(k)];
        moved_.push_back({s.block, s.u0, s.nu});
      }
      moved0_.push_back(static_cast<int>(moved_.size()));
      present_.r[row] = c.bias.size() > from ? c.bias[from] : 0.0;
      position_[row] = c.position[from];
      chi_[row] = c.chi[from];
      gamma_[row] = along(row, u) + c.chi[from];
      applyInverse(e.mass, moved(row), {W.col(row).data(), u.size()},
                   {MInvW_.col(row).data(), u.size()});
    }
  }
  return true;
}

/// Makes W and M⁻¹W zero, of which only the entries that are in use are not.
void HeldRows::clear(Eigen::Index velocities, int rows) {
  Eigen::MatrixXd& W = present_.R;
  if (W.rows() != velocities || W.cols() != rows) {
    W.setZero(velocities, rows), MInvW_.setZero(velocities, rows);
  } else {
    for (int row = 0; row < rows && row + 1 < static_cast<int>(moved0_.size()); ++row)
      for (const Moved& p : moved(row)) {
        W.col(row).segment(p.u0, p.nu).setZero();
        MInvW_.col(row).segment(p.u0, p.nu).setZero();
      }
  }
  moved_.clear(), moved0_.assign(1, 0);
}

bool HeldRows::readSets(const std::vector<Held>& held, const Evaluation& e, PhaseFault& fault) {
  for (std::size_t i = 0; i < held.size(); ++i) {
    const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(index_[i])];
    ForceSet& set = sets_[i] = {};
    double slip[kMostRows] = {};
    const bool fits = dim(i) <= kMostRows;
    for (int r = 0; fits && r < dim(i); ++r) slip[r] = gamma_[row0_[i] + r];
    const LawInput in = e.contacts.input(index_[i], 1.0, nullptr);
    const bool whole = held[i].rows == 0 && law.discs() != nullptr && dim(i) > 1;
    if (!fits || whole || !slipForceSet(law, in, held[i], slip, set)) {
      fault.why = "the smooth phases of <" + law.type() +
                  "> have no closed form here (it tells no shape of its set): give a step "
                  "and another scheme";
      return false;
    }
    const double bound = held[i].sign > 0.0 ? set.lower : set.upper;
    const bool given = set.form == ForceSet::Form::given && dim(i) == 1;
    if (!held[i].slips || !(set.form == ForceSet::Form::joint || (given && std::isinf(bound))))
      continue;
    fault.why = PhaseFault::kOtherSet, fault.contact = held[i].key;
    return false;
  }
  return true;
}

bool HeldRows::readNext(const std::vector<Held>& held, const ContactSet& next,
                        const Eigen::VectorXd& before, double tau, AccelerationRows& out,
                        PhaseFault& fault) const {
  out.R.setZero(before.size(), size());
  out.r.resize(size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    // The same contacts were requested at both positions, in the same order.
    const int at = index_[i];
    if (at >= next.size() || next.key[static_cast<std::size_t>(at)] != held[i].key) {
      fault.why = PhaseFault::kLost, fault.contact = held[i].key;
      return false;
    }
    for (int r = 0; r < dim(i); ++r) {
      const int row = row0_[i] + r, of = held[i].first + r;
      addRow(next, at, of, out.R, row);
      const auto from = static_cast<std::size_t>(next.row0[static_cast<std::size_t>(at)] + of);
      out.r[row] = (out.R.col(row).dot(before) + next.chi[from]) / tau;
    }
  }
  return true;
}

void RowsOfBlocks::list(const HeldRows& rows, const std::vector<int>& kept) {
  std::fill(first_.begin(), first_.end(), -1);
  entries_.clear(), rows_ = kept.size();
  for (int k = static_cast<int>(kept.size()) - 1; k >= 0; --k)
    for (const HeldRows::Moved& p : rows.moved(kept[static_cast<std::size_t>(k)])) {
      const auto block = static_cast<std::size_t>(p.block);
      if (block >= first_.size()) first_.resize(block + 1, -1);
      entries_.push_back({k, first_[block]});
      first_[block] = static_cast<int>(entries_.size()) - 1;
    }
}

void RowsOfBlocks::group(std::vector<int>& out) const {
  out.resize(rows_);
  std::iota(out.begin(), out.end(), 0);
  const auto root = [&](int k) {
    while (out[static_cast<std::size_t>(k)] != k) k = out[static_cast<std::size_t>(k)];
    return k;
  };
  for (const int head : first_)
    for (int at = head; at >= 0; at = entries_[static_cast<std::size_t>(at)].next) {
      const int a = root(entries_[static_cast<std::size_t>(head)].k),
                b = root(entries_[static_cast<std::size_t>(at)].k);
      out[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  for (int& k : out) k = root(k);
}

}  // namespace dynamy
