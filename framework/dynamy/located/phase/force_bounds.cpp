#include <cmath>
#include <dynamy/located/phase/force_bounds.hpp>

namespace dynamy {

int normalRow(const std::vector<Held>& held, const HeldRows& rows, std::size_t i) {
  while (i > 0 && held[i].first > 0) --i;
  return rows.row0(i);
}

std::vector<ForceBound> forceBounds(const std::vector<Held>& held, const HeldRows& rows,
                                    std::size_t i) {
  using Form = ForceSet::Form;
  const ForceSet& set = rows.set(i);
  const int first = rows.row0(i), dim = rows.dim(i);
  const bool sticks = !held[i].slips;
  switch (set.form) {
    case Form::joint:
      break;
    case Form::normal:
      return {{first, 1.0, -set.lower, 0, {}}};
    case Form::cone:
    case Form::reservoir: {
      std::vector<ForceBound> out{{first, 1.0, 0.0, 0, {}}};
      if (!sticks || dim == 1) return out;
      Eigen::VectorXd weights = Eigen::VectorXd::Ones(dim - 1);
      for (int r = 0; r < dim - 1 && set.form == Form::reservoir; ++r)
        weights[r] /= set.weight[static_cast<std::size_t>(r)];
      out.push_back({first, set.upper, 0.0, first + 1, weights});
      return out;
    }
    case Form::disc:
      if (!sticks) break;
      return {{normalRow(held, rows, i), 1.0, 0.0, first,
               Eigen::VectorXd::Constant(dim, 1.0 / set.upper)}};
    case Form::given:
    case Form::notch:
      if (!sticks) break;
      if (dim > 1) return {{-1, 0.0, set.upper, first, Eigen::VectorXd::Ones(dim)}};
      std::vector<ForceBound> out;
      if (std::isfinite(set.upper)) out.push_back({first, -1.0, set.upper, 0, {}});
      if (std::isfinite(set.lower)) out.push_back({first, 1.0, -set.lower, 0, {}});
      return out;
  }
  return {};
}

}  // namespace dynamy
