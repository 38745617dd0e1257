/// Saver: writes the checkpoints of a run.
#pragma once
#include "run/run_job.hpp"

namespace dynamy::app {

class Saver {
 public:
  /// The arguments must outlive the Saver.
  Saver(const RunFolder& folder, const RunChoice& choice, const Model& model,
        RunRecording& recording);
  ~Saver();
  Saver(const Saver&) = delete;
  Saver& operator=(const Saver&) = delete;
  /// Writes a checkpoint; `simulation`: the bytes of Simulation::checkpoint at t [s]. `lasting`: it
  /// shall survive a loss of power. Throws nothing: if a checkpoint cannot be written, fault() has
  /// the reason, the older ones stay, and the run continues.
  void save(const std::string& simulation, double t, bool lasting);
  /// Writes the last checkpoint, that of a run that has ended.
  void saveLast(const Simulation& simulation);
  /// Why the last checkpoint could not be written; empty: it was written.
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
