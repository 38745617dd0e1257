#include <algorithm>
#include <cmath>
#include <dynamy/simulation/fit/measured_run.hpp>

namespace dynamy {
namespace {

/// Derivatives by runs that follow the one at the parameter; empty: there are none, or one of the
/// two values beside it is no value of the model.
std::vector<double> followed(RunDifferences& runs, const Varied& parameter, double size) {
  if (!std::isnan(runs.steppedFrom())) return {};
  try {
    return runs.by(parameter, size, 1);
  } catch (const ModelError&) {
    return {};
  }
}

}  // namespace

RunResiduals::RunResiduals(const MeasuredRun& run, std::vector<Varied> parameters, double tolerance)
    : run_(run), parameters_(std::move(parameters)), tolerance_(tolerance) {
  for (const MeasuredValue& m : run.data) of_.push_back({m.signal, m.t});
}

void RunResiduals::place(const double* x) {
  const Eigen::Map<const Eigen::VectorXd> at(x, static_cast<Eigen::Index>(parameters_.size()));
  if (differences_ && at == at_) return;
  at_ = at, known_ = false;
  differences_.reset();
  differences_ = std::make_unique<RunDifferences>(
      [this](const std::vector<Varied>& changed, const MotionSequence* like) {
        std::vector<Varied> all;
        for (std::size_t i = 0; i < parameters_.size(); ++i)
          all.emplace_back(parameters_[i].first, at_[static_cast<Eigen::Index>(i)]);
        for (const auto& [name, value] : changed)
          for (Varied& v : all)
            if (v.first == name) v.second = value;
        Model model = run_.make(all);
        model.checks.clear();
        double& until = model.simulation.until;
        until = 0.0;
        for (const SignalAt& s : of_) until = std::max(until, s.t);
        ++effort_.runs;
        if (!run_.start) return followedRun(model, of_, tolerance_, {.like = like});
        const State start = run_.start(model);
        return followedRun(model, of_, tolerance_, {.like = like, .from = &start});
      });
}

const std::vector<double>& RunResiduals::values(const double* x) {
  place(x);
  return differences_->nominal().values;
}

const Eigen::MatrixXd& RunResiduals::derivatives(const double* x, double wide) {
  place(x);
  if (known_ && wide == 1.0) return derivatives_;
  usedAcross_ = false;
  derivatives_.resize(static_cast<Eigen::Index>(of_.size()),
                      static_cast<Eigen::Index>(parameters_.size()));
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const Varied parameter(parameters_[i].first, at_[column]);
    const double size = wide * std::max(parameters_[i].second, std::abs(parameter.second));
    std::vector<double> d = followed(*differences_, parameter, size);
    if (d.empty()) d = differences_->across(parameter, size), usedAcross_ = true;
    derivatives_.col(column) =
        Eigen::Map<const Eigen::VectorXd>(d.data(), static_cast<Eigen::Index>(d.size()));
  }
  known_ = wide == 1.0;
  if (!known_) return derivatives_;
  ++effort_.evaluations;
  effort_.across += usedAcross_ ? 1 : 0;
  Order now = order();
  if (effort_.evaluations > 1 && now != before_) ++effort_.reordered;
  before_ = std::move(now);
  return derivatives_;
}

double RunResiduals::rounding(std::size_t measurement, std::size_t parameter) const {
  const double size =
      std::max(parameters_[parameter].second, std::abs(at_[static_cast<Eigen::Index>(parameter)]));
  return RunDifferences::kRounding * std::abs(differences_->nominal().values[measurement]) /
         (RunDifferences::kDelta * size);
}

RunResiduals::Order RunResiduals::order() const {
  Order out;
  for (const MotionSequence::Step& s : differences_->nominal().sequence.steps) {
    for (const ContactKey& key : s.impacts) out.emplace_back(key, -1);
    for (const HeldStatus& h : s.statuses) out.emplace_back(h.key, static_cast<int>(h.status));
  }
  return out;
}

}  // namespace dynamy
