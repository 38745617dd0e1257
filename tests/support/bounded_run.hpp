/// BoundedRun: a model, from a text or a file, run by the program's own loop within a bound of work,
/// with its rows and events in memory.
#pragma once
#include <build_paths.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/solver/automatic.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <support/known_defect.hpp>
#include <vector>

namespace dynamy {

/// What the run says that ends because a bound of its test is reached.
inline constexpr const char* kUsedUp = "the work that this test allows is used up";

/// The default solver; throws when it is called after `most` iterations.
class SolveBudget final : public InclusionSolver {
 public:
  explicit SolveBudget(long most) : left_(most) {}
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override {
    if (left_ <= 0) throw std::runtime_error(kUsedUp);
    const SolveReport report = solver_.solve(problem, Lambda);
    left_ -= report.iterations;
    return report;
  }

 private:
  Automatic solver_;
  long left_;
};

struct RunSetup {
  Overrides set = {};
  double tolerance = 0.0;         ///< in place of what the model says, 0: as it says
  double step = 0.0;              ///< the same [s]
  double until = 0.0;             ///< the same [s]
  std::string signals = {};       ///< recorded, in place of what the model says
  double every = 0.0;             ///< sample time [s], 0: as the model says
  long steps = 1'000'000;         ///< the run is stopped after so many
  long evaluations = 10'000'000;  ///< the same
  long iterations = 0;            ///< the run fails after so many of the solver; 0: any number
  std::optional<JointCoordinates> coordinates = {};
  bool reduce = false;  ///< as LoadOptions
};

class BoundedRun {
 public:
  /// `what`: a file in the source tree, or a text that begins with '<'. Throws ModelError.
  explicit BoundedRun(const std::string& what, const RunSetup& setup = {})
      : plugins_({DYNAMY_BINARY_DIR "/lib/dynamy"}), limit_(setup.steps, setup.evaluations) {
    registerFramework(registry_);
    plugins_.load(kStandardElements, {}, registry_);
    LoadOptions options;
    options.set = setup.set, options.build = false, options.coordinates = setup.coordinates;
    options.reduce = setup.reduce;
    const std::filesystem::path root = DYNAMY_SOURCE_DIR;
    model_ = std::make_unique<Model>(
        what.starts_with('<')
            ? loadModelText(what, "scene.xml", registry_, plugins_, options, root / "models")
            : loadModel(root / what, registry_, plugins_, options));
    if (!setup.signals.empty()) model_->record.signals = words(setup.signals);
    model_->record.places.assign(model_->record.signals.size(), Place());
    if (setup.every > 0.0) model_->record.every = setup.every;
    model_->record.framesPerSecond = 0.0;
    if (setup.until > 0.0) model_->simulation.until = setup.until;
    model_->build();
    if (setup.tolerance > 0.0) model_->askTolerance(setup.tolerance);
    if (setup.step > 0.0) model_->askStep(setup.step);
    if (setup.iterations > 0) model_->solver(std::make_unique<SolveBudget>(setup.iterations));
    simulation_ = std::make_unique<Simulation>(*model_);
    limit_.holdFor(*simulation_);
    simulation_->record(sink_);
  }
  const RunReport& run() { return simulation_->run(); }

  const RunReport& report() const { return simulation_->report(); }
  const State& state() const { return simulation_->state(); }
  Simulation& simulation() { return *simulation_; }
  Model& model() { return *model_; }
  long newtonSteps() const { return limit_.newtonSteps(); }
  bool finished() const { return report().ended == RunReport::Ended::finished; }
  const std::vector<double>& times() const { return sink_.t; }
  /// Value `column` of row `row`, as recorded.
  double value(std::size_t row, std::size_t column = 0) const { return sink_.rows[row][column]; }
  double last(std::size_t column = 0) const { return sink_.rows.back()[column]; }
  /// Impacts of the contact called `name`.
  std::vector<ContactEvent> impacts(const std::string& name) const {
    std::vector<ContactEvent> out;
    for (const ContactEvent& e : sink_.events)
      if (e.impact && contactName(*model_, e.key) == name) out.push_back(e);
    return out;
  }
  const std::vector<ContactEvent>& events() const { return sink_.events; }

 private:
  struct Sink final : RecordSink {
    void row(double at, std::span<const double> values) override {
      t.push_back(at), rows.emplace_back(values.begin(), values.end());
    }
    void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
    void event(const ContactEvent& e) override { events.push_back(e); }
    std::vector<double> t;
    std::vector<std::vector<double>> rows;
    std::vector<ContactEvent> events;
  };
  static std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      out.push_back(text.substr(at, end - at)), at = end + 1;
    }
    return out;
  }
  Registry registry_;
  PluginLoader plugins_;
  std::unique_ptr<Model> model_;
  Sink sink_;
  WorkLimit limit_;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace dynamy
