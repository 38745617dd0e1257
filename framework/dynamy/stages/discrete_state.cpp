#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/stages/discrete_state.hpp>

namespace dynamy {
namespace {

constexpr double kBoundOfHalfKey = 4294967296.0;  ///< 2³², above both halves of a key
constexpr double kMostValue = 3.0 * 256.0;        ///< above all values, with three per status

/// Sign (1: +, 2: −) of the only friction row of a contact or one-row law; 0 where slip has several
/// rows.
int slipSign(const SetValuedForceLaw& law, int dim, const double* Lambda) {
  const int row = dim - 1, others = law.rowKind(0) == RowKind::normal ? 1 : 0;
  if (dim - others != 1 || !yields(law.rowKind(row))) return 0;
  return Lambda[row] > 0.0 ? 1 : Lambda[row] < 0.0 ? 2 : 0;
}

}  // namespace

void DiscreteState::read(const MechanicalSystem& s, const State& x) {
  const ImpactProblem& p = s.problem();
  const ContactSet& c = *p.contacts;
  known_ = true;
  work_.clear();
  gammaE_.resize(static_cast<std::size_t>(c.rows()));
  c.gamma(view(x.u), {gammaE_.data(), static_cast<Eigen::Index>(c.rows())});
  for (int i = 0; i < c.size(); ++i) {
    const SetValuedForceLaw& law = p.law(i);
    const int dim = p.dim(i), first = p.row0(i);
    if (dim == 0 || dim > kMostRows) continue;
    std::array<double, kMostRows> epsilon{}, Lambda{}, argument{};
    law.epsilon(dim, epsilon.data());
    const double r = 1.0 / contactLambda(p.G->diagonalBlock(i), dim);
    for (int k = 0; k < dim; ++k) {
      const auto at = static_cast<std::size_t>(k), row = static_cast<std::size_t>(first + k);
      Lambda[at] = p.Lambda(first + k);
      argument[at] = Lambda[at] - r * (gammaE_[row] + epsilon[at] * p.gammaA[row]);
    }
    const Status status = law.status(p.input(i), argument.data());
    if (status == Status::open || status == Status::separating) continue;
    const int sign = status == Status::slip ? slipSign(law, dim, Lambda.data()) : 0;
    work_.push_back({c.key[static_cast<std::size_t>(i)], 3 * static_cast<int>(status) + sign});
  }
  const auto less = [](const Entry& a, const Entry& b) { return a.key < b.key; };
  std::sort(work_.begin(), work_.end(), less);
  key_.clear(), value_.clear();
  for (const Entry& e : work_) key_.push_back(e.key), value_.push_back(e.value);
}

void DiscreteState::store(Eigen::VectorXd& data, Eigen::Index first) const {
  data[first++] = known_ ? 1.0 : 0.0;
  data[first++] = static_cast<double>(key_.size());
  for (std::size_t i = 0; i < key_.size(); ++i) {
    data[first++] = static_cast<double>(key_[i].value >> 32);
    data[first++] = static_cast<double>(key_[i].value & 0xffffffffU);
    data[first++] = value_[i];
  }
}

bool DiscreteState::restore(const Eigen::VectorXd& data, Eigen::Index first) {
  forget();
  if (first + 2 > data.size()) return false;
  const bool known = data[first++] > 0.0;
  const double count = data[first++], room = static_cast<double>(data.size() - first) / 3.0;
  if (!(count >= 0.0 && count <= room) || count != std::floor(count)) return false;
  const auto bounded = [](double x, double most) { return x >= 0.0 && x < most; };
  for (auto left = static_cast<long>(count); left > 0; --left, first += 3) {
    if (!bounded(data[first], kBoundOfHalfKey) || !bounded(data[first + 1], kBoundOfHalfKey) ||
        !bounded(data[first + 2], kMostValue)) {
      forget();
      return false;
    }
    key_.push_back({(static_cast<std::uint64_t>(data[first]) << 32) |
                    static_cast<std::uint64_t>(data[first + 1])});
    value_.push_back(static_cast<int>(data[first + 2]));
  }
  known_ = known;
  return true;
}

}  // namespace dynamy
