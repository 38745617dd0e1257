/// FmuInstance: one instance of an FMU: its mode, the values of its variables, and its run.
///
///   instantiated → initialization → (event ⇄) step → terminated
///
/// The model is read from the resources of the FMU when its values are first needed after
/// parameters were set. Errors are exceptions here; the C interface makes statuses of them.
#pragma once
#include <dynamy/io/model/model_loader.hpp>
#include <filesystem>
#include <memory>

#include "fmu/coupled_run.hpp"
#include "fmu/fmu_contents.hpp"

namespace dynamy::fmu {

/// A call that the standard does not allow, or a value that does not exist.
class FmuError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Mode { instantiated, initialization, event, step, terminated };

/// What the other program can do.
struct Partner {
  bool eventMode = false, earlyReturn = false;
};

/// What the other program has announced of its run.
struct Experiment {
  double tolerance = 0.0;  ///< 0: none
  double stop = -1.0;      ///< negative: none [s]
};

struct StepEnd {
  double t = 0.0;
  bool event = false, early = false;
};

class FmuInstance {
 public:
  /// `resources`: the folder of that name of the FMU; `libraries`: of its plug-ins. Throws.
  FmuInstance(const std::filesystem::path& resources, const std::filesystem::path& libraries,
              const std::string& token, Partner partner);

  void enterInitialization(double start, const Experiment& experiment);
  void exitInitialization();
  /// Changes between event mode and step mode, or ends the run.
  void enter(Mode mode);
  void reset();
  /// Outputs at the present instant become those after the event. Returns the next instant at which
  /// a block samples; infinity: none.
  double updateDiscrete();
  StepEnd step(double t, double h, const CoupledRun::OnTheWay& onTheWay);
  /// Ends the present step at this instant, or earlier; called on the way.
  void endAt(double t) { target_ = t; }

  double number(std::uint32_t reference);
  std::int64_t status(std::uint32_t reference);
  void set(std::uint32_t reference, double value);

  std::string state();
  void state(const std::string& bytes);

 private:
  const Variable& variable(std::uint32_t reference) const;
  double output(std::uint32_t reference, Role role, const std::vector<double>& from) const;
  void expect(Mode mode, const char* call) const;
  void load();
  CoupledRun& run();
  void connect(std::vector<const NamedSignal*>& signals, std::vector<SetInput>& inputs);
  void outputs();

  std::filesystem::path resources_;
  FmuContents contents_;
  Partner partner_;
  Registry registry_;
  PluginLoader plugins_;
  Mode mode_ = Mode::instantiated;
  Experiment experiment_;
  Overrides set_;                             // parameters
  std::map<std::string, double> parameters_;  // all of them
  std::vector<double> input_;                 // by reference; of inputs alone
  std::unique_ptr<Model> model_;
  double until_ = 0.0;  // of the model [s]
  std::unique_ptr<CoupledRun> run_;
  std::vector<int> place_;      // by reference: of a signal among all, of an input in the memory
  std::vector<double> values_;  // of the signals now
  std::vector<double> held_;    // of the signals at the last event, for statuses
  double target_ = 0.0;         // end of the present step [s]
  bool before_ = false;         // values are those right before an event
  bool fresh_ = false;          // values_ are of the present instant
};

}  // namespace dynamy::fmu
