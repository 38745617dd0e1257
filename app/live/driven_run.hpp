/// DrivenRun: a run that is changed between its steps, by a person (live_run) or by the list of what
/// a person did before (repeated_run). Both call the same functions in the same order, so that they
/// have the same motion, bit for bit.
///
/// An input and the hand are numbers of the state, and are set there. A parameter belongs to the
/// model, which nothing changes: the model is loaded again with the new value and goes on from the
/// present state. Rejected: to change attributes of elements that run, because elements compute much
/// from their attributes once, when they are made.
#pragma once
#include <dynamy/io/run_files/run_folder.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <map>
#include <memory>
#include <optional>

#include "live/hand.hpp"
#include "live/inputs_file.hpp"
#include "program.hpp"
#include "run/run_job.hpp"

namespace dynamy::app {

class DrivenRun {
 public:
  /// Loads the model of `choice`, with a hand, and takes the folder. Throws ModelError, FileError.
  DrivenRun(Program& program, RunChoice choice, const std::filesystem::path& folder);

  /// Writes run.json and records the state at the start.
  void start(const RunShow& show);
  /// Takes the next step. False: the run has ended.
  bool step();
  /// Carries out an action between two steps and notes it in the file inputs.csv. Returns why it
  /// cannot be done; empty: it is done.
  std::string apply(Action action);
  /// The action by which the hand holds `point` of the drawn frame number `drawn`, softer or harder
  /// by `strength`. No value: this frame cannot be held.
  std::optional<Action> grab(int drawn, const Vec3& point, const Vec3& target, double strength);
  /// Writes what is recorded, so that others can read it.
  void flush() { recording_->flush(); }
  /// Writes the files of a run that has ended and prints its result. Returns the exit status, which
  /// is 128 + `signal` if a signal ended it.
  int conclude(const RunShow& show, int signal = 0);

  const Model& model() const { return *model_; }
  const RunFolder& folder() const { return folder_; }
  const RunChoice& choice() const { return choice_; }
  const RunReport& report() const { return simulation_->report(); }
  double t() const { return simulation_->state().t; }
  long steps() const { return steps_; }
  long actions() const { return inputs_.actions(); }
  /// Values of all parameters, and of all <Input>, at present.
  std::map<std::string, double> parameters() const;
  std::map<std::string, double> inputs() const;

 private:
  std::string change(const std::string& parameter, double value);
  std::string setInput(const std::string& name, double value);
  void hold(const Grip& grip);
  RunShow shown(const RunShow& show) const;

  Program& program_;
  RunChoice first_, choice_;  // at the start; at present
  std::unique_ptr<Model> model_;
  RunFolder folder_;
  std::unique_ptr<RunRecording> recording_;
  std::unique_ptr<Simulation> simulation_;
  int threads_ = 1;
  InputsFile inputs_;
  Grip grip_;
  long steps_ = 0;
};

}  // namespace dynamy::app
