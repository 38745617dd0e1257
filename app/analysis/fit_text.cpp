#include "analysis/fit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/fit_facts.hpp"

namespace dynamy::app {

std::string fitNumber(double x, double sigma) {
  if (!std::isfinite(x)) return x < 0.0 ? "−∞" : "∞";
  if (!(sigma > 0.0) || x == 0.0) return fmt::format("{:.6g}", x);
  const double digits = std::ceil(std::log10(std::abs(x) / sigma)) + 2.0;
  return fmt::format("{:.{}g}", x, static_cast<int>(std::clamp(digits, 2.0, 12.0)));
}

std::vector<FitCorrelation> correlations(const Fit& f, double least) {
  std::vector<FitCorrelation> out;
  for (std::size_t i = 0; i < f.parameters.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const FittedParameter &a = f.parameters[k], &b = f.parameters[i];
      if (!a.identifiable || !b.identifiable) continue;
      const double c = f.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) /
                       (a.sigma * b.sigma);
      if (std::abs(c) >= least) out.push_back({fittedName(f, a), fittedName(f, b), c});
    }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  return out;
}

std::string intervalWords(const FittedParameter& p) {
  if (!p.identifiable) return "not identifiable";
  std::string out = p.interval == FittedParameter::Interval::gaussian ? "gaussian" : "profile";
  if (p.atBound) out += ", at its bound";
  return out;
}

std::vector<std::string> fitRemarks(const Fit& f) {
  constexpr double kUnlikely = 3.3;  // standard deviations: one in a thousand
  std::vector<std::string> out = f.unknown;
  const bool given = std::none_of(f.signals.begin(), f.signals.end(),
                                  [](const FittedSignal& s) { return s.estimated; });
  if (given && f.chi2 - f.freedom > kUnlikely * std::sqrt(2.0 * f.freedom))
    out.push_back(
        "χ² is larger than the standard deviations allow: the model lacks something, or they are "
        "too small; so are the intervals");
  int reordered = 0, across = 0, ended = 0, other = 0;
  for (const FittedRun& r : f.runs) {
    reordered += r.effort.reordered > 0, across += r.effort.across > 0;
    ended += r.effort.ended > 0, other += r.otherOrder;
  }
  const auto count = [&](int n, const char* text) {
    if (n > 0) out.push_back(fmt::format("in {} of {} runs {}", n, f.runs.size(), text));
  };
  count(reordered, "the order of switches changed during the search");
  count(across,
        "a switch was so near a measurement or another switch that derivatives are "
        "differences across it");
  count(ended, "some values of the parameters let the run end early; they were avoided");
  count(other, "switches come in another order within the intervals");
  if (!f.converged) out.push_back("the search ended before it converged: " + f.why);
  return out;
}

std::string fitText(const std::string& model, const Fit& f) {
  std::size_t width = 0;
  for (const FittedParameter& p : f.parameters) width = std::max(width, fittedName(f, p).size());
  std::string out = fmt::format("{}: {} measurements in {} run{}\n", model, f.points.size(),
                                f.runs.size(), f.runs.size() == 1 ? "" : "s");
  for (const FittedParameter& p : f.parameters) {
    out += fmt::format("   {:<{}}", fittedName(f, p), width);
    if (p.identifiable)
      out += fmt::format(" {:>12}   95 %: {} … {}, {}\n", fitNumber(p.value, p.sigma),
                         fitNumber(p.low, p.sigma), fitNumber(p.high, p.sigma), intervalWords(p));
    else
      out += " is not identifiable\n";
  }
  out += fmt::format(" χ² = {:.6g} with {} degrees of freedom\n", f.chi2, f.freedom);
  for (const FittedSignal& s : f.signals)
    out += fmt::format(" {}: standard deviation {:.4g}{}\n", s.signal, s.sigma,
                       s.estimated ? ", that of the residuals" : "");
  for (const FitCorrelation& c : correlations(f, 0.9))
    out += fmt::format(" correlation of {} and {}: {:.3f}\n", c.a, c.b, c.value);
  for (const std::string& remark : fitRemarks(f)) out += ' ' + remark + '\n';
  long runs = 0;
  for (const FittedRun& r : f.runs) runs += r.effort.runs;
  return out + fmt::format(" {} iterations, {} motions; tolerance {:g}\n", f.iterations, runs,
                           f.tolerance);
}

}  // namespace dynamy::app
