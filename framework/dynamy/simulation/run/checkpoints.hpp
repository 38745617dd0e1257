/// Checkpoints: the last state of a run that is known completely, as bytes, and the instants of wall
/// time at which such bytes are handed on. They are handed on every so many seconds, more rarely if
/// that takes more than a given share of the time.
#pragma once
#include <chrono>
#include <dynamy/core/archive.hpp>
#include <dynamy/system/state.hpp>
#include <functional>
#include <string>

namespace dynamy {

class Model;

class Checkpoints {
 public:
  using Clock = std::chrono::steady_clock;
  using Receiver = std::function<void(const std::string&)>;
  /// `receive` gets the bytes every `seconds` of wall time, if they and the call take no more than
  /// `share` of the time; 0 seconds: only when handOn() is called.
  void receiver(double seconds, double share, Receiver receive);
  bool hasReceiver() const { return static_cast<bool>(receive_); }
  /// Begins a run.
  void begin(Clock::time_point now) { last_ = now; }
  /// True: the next checkpoint is to be handed on.
  bool due(Clock::time_point now) const;
  /// Stores the bytes of a state.
  void keep(const std::string& bytes) { bytes_ = bytes; }
  /// Calls `write`, which keeps the present state, and hands the bytes on. There is a receiver.
  void handOn(const std::function<void()>& write);
  /// The bytes kept last; empty: none were.
  const std::string& bytes() const { return bytes_; }

 private:
  Receiver receive_;
  double every_ = 0.0, share_ = 1.0;  // [s], –
  double cost_ = 0.0;                 // of the last one [s]
  Clock::time_point last_;
  std::string bytes_;
};

/// Writes or reads all of a state.
void archiveState(Archive& a, State& x);

/// Why x, read from a checkpoint, cannot be a state of a run of a model with so many contact
/// elements; empty: it can. Indices are checked here, once, and never within a step.
std::string stateFault(const State& x, std::size_t contacts);
/// Throws ModelError if x, the state that was read from `a`, cannot be of a run of the model: by its
/// sizes, by stateFault(), or by the memory of an element, or if `a` holds more.
void refuseForeign(const Model& model, const Archive& a, const State& x);

}  // namespace dynamy
