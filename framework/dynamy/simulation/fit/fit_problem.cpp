#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/simulation/fit/fit_problem.hpp>
#include <utility>

namespace dynamy {
namespace {

constexpr double kOfRange = 0.01;  ///< typical change of a parameter between two bounds
/// Smallest standard deviation of residuals, in tolerances of the largest measured value.
constexpr double kLeastSigma = 1.0;

/// A typical change of a parameter: what differences are parts of.
double sizeOf(const WantedParameter& p, double start) {
  const double range = kOfRange * (p.upper - p.lower);
  double size = std::abs(start);
  if (std::isfinite(p.priorSigma)) size = std::max(size, p.priorSigma);
  if (size == 0.0 && std::isfinite(range)) size = range;
  return size > 0.0 ? size : 1.0;
}

FitProblem::Unknown unknownOf(const WantedParameter& p, int index, int run, double start) {
  if (start < p.lower || start > p.upper)
    throw ModelError(fmt::format("the search for {} begins at {:g}, outside of {:g} … {:g}", p.name,
                                 start, p.lower, p.upper),
                     "let it begin elsewhere: --set " + p.name + "=…");
  return {.parameter = index, .run = run, .start = start, .size = sizeOf(p, start)};
}

}  // namespace

FitProblem::FitProblem(const FitRequest& request) : request_(request) {
  of_.resize(request.runs.size());
  const auto add = [this](const WantedParameter& p, int index, int run, double start) {
    unknowns_.push_back(unknownOf(p, index, run, start));
    if (std::isfinite(p.priorSigma)) priors_.push_back(size() - 1);
  };
  const int parameters = static_cast<int>(request.parameters.size());
  for (int i = 0; i < parameters; ++i)
    if (const WantedParameter& p = request.parameters[static_cast<std::size_t>(i)]; !p.each) {
      add(p, i, -1, p.start);
      for (std::vector<int>& of : of_) of.push_back(size() - 1);
    }
  for (std::size_t k = 0; k < request.runs.size(); ++k) {
    const MeasuredRun& run = request.runs[k];
    for (int i = 0; i < parameters; ++i) {
      const WantedParameter& p = request.parameters[static_cast<std::size_t>(i)];
      if (!p.each) continue;
      double start = p.start;
      for (const auto& [name, value] : run.own)
        if (name == p.name) start = value;
      add(p, i, static_cast<int>(k), start);
      of_[k].push_back(size() - 1);
    }
    std::vector<Varied> sizes;
    for (const int i : of_[k]) {
      const Unknown& u = unknowns_[static_cast<std::size_t>(i)];
      sizes.emplace_back(request.parameters[static_cast<std::size_t>(u.parameter)].name, u.size);
    }
    runs_.emplace_back(run, std::move(sizes), request.tolerance);
    measurements_ += static_cast<int>(run.data.size());
    for (const MeasuredValue& m : run.data) {
      Noise& n = noise_[m.signal];
      n.least = std::max(n.least, kLeastSigma * request.tolerance * std::abs(m.value));
      n.known += std::isnan(m.sigma) ? 0.0 : m.sigma * m.sigma;
      n.count += std::isnan(m.sigma) ? 1 : 0, ++n.all;
      n.sigma = std::max(n.sigma, std::abs(m.value));  // to begin with
    }
  }
  for (auto& [signal, n] : noise_)
    if (n.sigma == 0.0) n.sigma = 1.0;
}

Eigen::VectorXd FitProblem::start() const {
  Eigen::VectorXd x(size());
  for (int i = 0; i < size(); ++i) x[i] = unknowns_[static_cast<std::size_t>(i)].start;
  return x;
}

double FitProblem::sigma(const MeasuredValue& m) const {
  return std::isnan(m.sigma) ? noise_.at(m.signal).sigma : m.sigma;
}

bool FitProblem::evaluate(int run, const double* x, double* r, double* J) {
  RunResiduals& residuals = runs_[static_cast<std::size_t>(run)];
  const std::vector<MeasuredValue>& data = residuals.run().data;
  const std::size_t columns = of_[static_cast<std::size_t>(run)].size();
  try {
    const std::vector<double>& v = residuals.values(x);
    for (std::size_t k = 0; k < data.size(); ++k) r[k] = (v[k] - data[k].value) / sigma(data[k]);
    if (J == nullptr) return true;
    const Eigen::MatrixXd& d = residuals.derivatives(x);
    for (std::size_t k = 0; k < data.size(); ++k)
      for (std::size_t i = 0; i < columns; ++i)
        J[k * columns + i] =
            d(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) / sigma(data[k]);
    return true;
  } catch (const ModelError&) {
    residuals.countEnded();  // the optimiser tries a shorter step
    return false;
  }
}

LeastSquares FitProblem::leastSquares() {
  LeastSquares out;
  out.iterations = request_.iterations;
  out.lower.resize(size()), out.upper.resize(size());
  for (int i = 0; i < size(); ++i) {
    const auto parameter = unknowns_[static_cast<std::size_t>(i)].parameter;
    const WantedParameter& p = request_.parameters[static_cast<std::size_t>(parameter)];
    out.lower[i] = p.lower, out.upper[i] = p.upper;
  }
  for (int k = 0; k < static_cast<int>(runs_.size()); ++k)
    out.blocks.push_back(
        {.of = of_[static_cast<std::size_t>(k)],
         .residuals = static_cast<int>(request_.runs[static_cast<std::size_t>(k)].data.size()),
         .evaluate = [this, k](const double* x, double* r, double* J) {
           return evaluate(k, x, r, J);
         }});
  for (const int i : priors_) {
    const auto parameter = unknowns_[static_cast<std::size_t>(i)].parameter;
    const WantedParameter& p = request_.parameters[static_cast<std::size_t>(parameter)];
    out.blocks.push_back({.of = {i}, .residuals = 1, .evaluate = [&p](auto* x, auto* r, auto* J) {
                            *r = (*x - p.priorMean) / p.priorSigma;
                            if (J != nullptr) *J = 1.0 / p.priorSigma;
                            return true;
                          }});
  }
  return out;
}

std::vector<double> FitProblem::ofRun(int run, const Eigen::VectorXd& x) const {
  std::vector<double> out;
  for (const int i : of_[static_cast<std::size_t>(run)]) out.push_back(x[i]);
  return out;
}

Eigen::VectorXd FitProblem::residuals(const Eigen::VectorXd& x) {
  Eigen::VectorXd out(measurements_ + static_cast<int>(priors_.size()));
  int row = 0;
  for (int k = 0; k < static_cast<int>(runs_.size()); ++k) {
    RunResiduals& run = runs_[static_cast<std::size_t>(k)];
    const std::vector<double>& v = run.values(ofRun(k, x).data());
    for (std::size_t j = 0; j < v.size(); ++j) {
      const MeasuredValue& m = run.run().data[j];
      out[row++] = (v[j] - m.value) / sigma(m);
    }
  }
  for (const int i : priors_) {
    const auto parameter = unknowns_[static_cast<std::size_t>(i)].parameter;
    const WantedParameter& p = request_.parameters[static_cast<std::size_t>(parameter)];
    out[row++] = (x[i] - p.priorMean) / p.priorSigma;
  }
  return out;
}

Eigen::MatrixXd FitProblem::jacobian(const Eigen::VectorXd& x, double wide) {
  Eigen::MatrixXd out =
      Eigen::MatrixXd::Zero(measurements_ + static_cast<int>(priors_.size()), size());
  int row = 0;
  for (int k = 0; k < static_cast<int>(runs_.size()); ++k) {
    RunResiduals& run = runs_[static_cast<std::size_t>(k)];
    const std::vector<int>& of = of_[static_cast<std::size_t>(k)];
    const Eigen::MatrixXd& d = run.derivatives(ofRun(k, x).data(), wide);
    for (int j = 0; j < d.rows(); ++j, ++row)
      for (int i = 0; i < d.cols(); ++i)
        out(row, of[static_cast<std::size_t>(i)]) =
            d(j, i) / sigma(run.run().data[static_cast<std::size_t>(j)]);
  }
  for (const int i : priors_) {
    const auto parameter = unknowns_[static_cast<std::size_t>(i)].parameter;
    out(row++, i) = 1.0 / request_.parameters[static_cast<std::size_t>(parameter)].priorSigma;
  }
  return out;
}

double FitProblem::rounding(int unknown) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    const std::vector<MeasuredValue>& data = runs_[k].run().data;
    for (std::size_t i = 0; i < of_[k].size(); ++i)
      for (std::size_t j = 0; of_[k][i] == unknown && j < data.size(); ++j) {
        const double part = runs_[k].rounding(j, i) / sigma(data[j]);
        sum += part * part;
      }
  }
  return std::sqrt(sum);
}

bool FitProblem::estimates() const {
  return std::any_of(noise_.begin(), noise_.end(),
                     [](const auto& n) { return n.second.count > 0; });
}

double FitProblem::estimateSigma(const Eigen::VectorXd& x, int unknowns) {
  std::map<std::string, double> sums;
  const Eigen::VectorXd r = residuals(x);
  int row = 0, count = 0;
  for (const RunResiduals& run : runs_)
    for (const MeasuredValue& m : run.run().data) {
      const double off = r[row++] * sigma(m);
      if (std::isnan(m.sigma)) sums[m.signal] += off * off, ++count;
    }
  // The unknowns take a share of the freedom of all measurements.
  const double part = std::max(1.0 - unknowns / static_cast<double>(measurements_), 1.0 / count);
  double most = 0.0;
  for (const auto& [signal, sum] : sums) {
    Noise& n = noise_.at(signal);
    const double next = std::max(std::sqrt(sum / (n.count * part)), n.least);
    most = std::max(most, std::abs(next / n.sigma - 1.0));
    n.sigma = next;
  }
  return most;
}

std::vector<FittedSignal> FitProblem::signals() const {
  std::vector<FittedSignal> out;
  for (const auto& [signal, n] : noise_) {
    const bool estimated = n.count > 0;
    out.push_back({.signal = signal,
                   .sigma = estimated ? n.sigma : std::sqrt(n.known / n.all),
                   .estimated = estimated,
                   .count = n.all});
  }
  return out;
}

}  // namespace dynamy
