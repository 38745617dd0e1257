#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/force_set.hpp>

namespace dynamy {
namespace {

constexpr int kMostGauge = 50;    ///< most Newton steps
constexpr double kGauge = 1e-13;  ///< relative size of the last Newton step

/// Coefficient of the disc that row `row` of a law of discs belongs to.
double discSize(const NormalTimesReservoir& law, int dim, int row) {
  double axis[kMostRows] = {};
  axis[row - 1] = 1.0;
  return law.support({.dim = dim, .dt = 1.0}, dim - 1, axis);
}

/// A reservoir: its widths along the rows are S_B(e_r).
bool reservoirSet(const SetValuedForceLaw& law, const LawInput& in, ForceSet& out) {
  out.set = law.reservoir();
  const int dim = in.dim;
  if (out.set == nullptr || dim < 2 || dim > kMostRows) return false;
  out.form = ForceSet::Form::reservoir, out.upper = 0.0;
  for (int r = 0; r < dim - 1; ++r) {
    double axis[kMostRows] = {};
    axis[r] = 1.0;
    out.weight[static_cast<std::size_t>(r)] = out.set->support(in, dim - 1, axis);
    // Only widths of tangential rows are forces over Λ_N; a spin row comes last.
    if (r < 2) out.upper = std::max(out.upper, out.weight[static_cast<std::size_t>(r)]);
  }
  for (double& w : out.weight) w = out.upper > 0.0 ? w / out.upper : 1.0;
  return out.upper > 0.0;
}

double norm(std::span<const double> x) {
  return ConstVec(x.data(), static_cast<Eigen::Index>(x.size())).norm();
}

}  // namespace

double ForceSet::speed(int rows, const double* gamma) const {
  double square = 0.0;
  for (int r = 0; r < rows; ++r) {
    const double v = weight[static_cast<std::size_t>(r)] * gamma[r];
    square += v * v;
  }
  return std::sqrt(square);
}

double ForceSet::gauge(int k, const double* x, const double* gamma) const {
  // Smallest N with x ∈ N B: S_B(y) where ½ S_B² − x·y is smallest, x = S_B(y) ∇S_B(y).
  const LawInput in{.dim = k + 1, .dt = 1.0, .gammaA = gamma};
  using Square =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostRows - 1, kMostRows - 1>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows - 1, 1>;
  Column y(k), g(k), step(k), trial(k);
  Square H(k, k);
  const ConstVec asked(x, k);
  for (int r = 0; r < k; ++r) {
    const double width = upper * weight[static_cast<std::size_t>(r)];
    y[r] = x[r] / (width * width);
  }
  const auto value = [&](const Column& at) {
    const double S = set->support(in, k, at.data());
    return 0.5 * S * S - asked.dot(at);
  };
  double S = 0.0;
  for (int turn = 0; turn < kMostGauge; ++turn) {
    S = set->support(in, k, y.data(), g.data(), H.data());
    if (!(S > 0.0)) return S;
    H = g * g.transpose() + S * H;
    step = H.ldlt().solve(asked - S * g);
    if (step.norm() <= kGauge * y.norm()) break;
    const double f = value(y);
    double part = 1.0;
    for (trial = y + step; part > 1e-3 && value(trial) > f; trial = y + part * step) part *= 0.5;
    y = trial;
  }
  return set->support(in, k, y.data());
}

bool ForceSet::margin(bool slips, std::span<const double> lambda, double normal,
                      const double* gamma, double& distance) const {
  switch (form) {
    case Form::joint:
      return false;
    case Form::normal:
      distance = lambda[0] - lower;
      return true;
    case Form::cone:
      distance = lambda[0];
      if (!slips) distance = std::min(distance, upper * distance - norm(lambda.subspan(1)));
      return true;
    case Form::disc:
      if (slips) return false;
      distance = normal - norm(lambda) / upper;
      return true;
    case Form::reservoir:
      distance = lambda[0];
      if (!slips)
        distance = std::min(distance, upper * (distance - gauge(static_cast<int>(lambda.size()) - 1,
                                                                lambda.data() + 1, gamma)));
      return true;
    case Form::given:
    case Form::notch:
      if (slips) return false;
      distance =
          lambda.size() > 1 ? upper - norm(lambda) : std::min(upper - lambda[0], lambda[0] - lower);
      return true;
  }
  return false;
}

bool forceSet(const SetValuedForceLaw& law, const LawInput& in, ForceSet& out, int first) {
  using Form = ForceSet::Form;
  if (const NormalTimesReservoir* discs = law.discs(); discs != nullptr && in.dim > 1) {
    if (in.dim > kMostRows) return false;
    out.upper = discSize(*discs, in.dim, std::max(first, 1));
    out.form = first > 0 ? Form::disc : out.upper > 0.0 ? Form::cone : Form::normal;
    return true;
  }
  if (NotchedForce f; law.notched(in, f)) {
    // A slip with the sign of x has the force of that side, continued smoothly past x = 0.
    const double x = in.position[0];
    out.form = Form::notch, out.lower = f.above - f.cAbove * x, out.upper = f.below - f.cBelow * x;
    return true;
  }
  const SimpleSet set = law.simpleSet(in);
  out.lower = set.lower, out.upper = set.upper;
  switch (set.shape) {
    case SimpleSet::Shape::all:
      out.form = Form::joint;
      return true;
    case SimpleSet::Shape::interval:
      out.form = law.unilateral() ? Form::normal : Form::given;
      return in.dim == 1;
    case SimpleSet::Shape::ball:
      out.form = Form::given, out.lower = -set.upper;
      return true;
    case SimpleSet::Shape::friction:
      out.form = Form::cone;
      return true;
    default:
      return reservoirSet(law, in, out);
  }
}

bool slipForceSet(const SetValuedForceLaw& law, LawInput in, const Held& h, double* slip,
                  ForceSet& out) {
  const int t = law.rowKind(0) == RowKind::normal ? 1 : 0;
  if (h.slips) in.gammaA = slip, in.rest = 0.0;
  const double v = h.sign * slip[t];
  if (!h.slips || h.first > 0 || in.dim - t != 1 || v > Held::kLeastSlip)
    return forceSet(law, in, out, h.first);
  slip[t] = h.sign * Held::kLeastSlip;
  if (!forceSet(law, in, out, h.first)) return false;
  if (v > -Held::kLeastSlip || out.form == ForceSet::Form::notch) return true;
  // a(−v) = 4 a(0) − 6 a(v) + 4 a(2v) − a(3v)
  constexpr double kWeight[4] = {4.0, -6.0, 4.0, -1.0};
  out.lower *= kWeight[0], out.upper *= kWeight[0];
  for (int k = 1; k < 4; ++k) {
    ForceSet far;
    slip[t] = -k * h.sign * v;
    if (!forceSet(law, in, far, h.first)) return false;
    out.lower += kWeight[k] * far.lower, out.upper += kWeight[k] * far.upper;
  }
  return true;
}

void statusParts(const SetValuedForceLaw& law, int dim, std::vector<std::array<int, 2>>& out) {
  out.clear();
  const NormalTimesReservoir* discs = law.discs();
  if (discs == nullptr || dim < 2 || dim > kMostRows) {
    out.push_back({0, dim});
    return;
  }
  // Rows without a coefficient take no force at all.
  for (int row = 1; row < dim; row = law.groupEnd(row, dim)) {
    const int end = law.groupEnd(row, dim), first = row == 1 ? 0 : row;
    const bool any = discSize(*discs, dim, row) > 0.0;
    if (any || first == 0) out.push_back({first, any ? end - first : 1});
  }
}

bool hasNotch(const SetValuedForceLaw& law, int dim) {
  NotchedForce unused;
  return law.notched({.dim = dim, .dt = 1.0}, unused);
}

}  // namespace dynamy
