/// Saver: writes the checkpoints of a run.
#pragma once
#include "run/run_job.hpp"

namespace dynamy::app {

class Saver {
 public:
  /// All outlive it.
  Saver(const RunFolder& folder, const RunChoice& choice, const Model& model,
        RunRecording& recording);
  ~Saver();
  Saver(const Saver&) = delete;
  Saver& operator=(const Saver&) = delete;
  /// `simulation`: the bytes of Simulation::checkpoint at t [s]. Throws nothing: a checkpoint that
  /// cannot be written is in fault(), the older ones stay, and the run goes on.
  void save(const std::string& simulation, double t, bool lasting);
  /// Of a run that has ended.
  void saveLast(const Simulation& simulation);
  /// Why the last one could not be written; empty: it could.
  const std::string& fault() const { return fault_; }

 private:
  void release();
  const RunFolder& folder_;
  RunRecording& recording_;
  Checkpoint next_;
  bool any_ = false;
  std::string fault_;
};

}  // namespace dynamy::app
