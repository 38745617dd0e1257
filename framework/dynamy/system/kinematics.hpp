/// Kinematics: t, q, u and the frames of one evaluation, which contacts and forces read. Each frame
/// is evaluated once.
#pragma once
#include <dynamy/system/system_subset.hpp>
#include <span>

namespace dynamy {

class Kinematics {
 public:
  /// Reserves room for all frames requested in `topology`; no allocation later.
  void resize(const Topology& topology);
  /// Keeps views of `q`, `u` and `memory`, which must outlive their use, and evaluates all frames,
  /// or those of a subset: the others are absent, or stay where they rest. Calls resize() if that was not done.
  void evaluate(const Topology& topology, double t, ConstVec q, ConstVec u,
                ConstVec memory = {nullptr, 0}, const SystemSubset* subset = nullptr);

  /// As above, but evaluates `frames` alone: the others stay as they are.
  void evaluate(const Topology& topology, double t, ConstVec q, ConstVec u, ConstVec memory,
                const SystemSubset* subset, std::span<const FrameHandle> frames);

  double t() const { return t_; }
  /// True: the system takes no part in this evaluation, see SystemSubset.
  bool leavesOut(int system) const { return some_ != nullptr && some_->leavesOut(system); }
  /// Another number whenever other systems take part; 0: all do.
  std::uint64_t stamp() const { return subset_; }
  ConstVec q(const SystemHandle& s) const { return {q_ + s.q0, s.nq}; }
  ConstVec u(const SystemHandle& s) const { return {u_ + s.u0, s.nu}; }
  ConstVec q(int first, int n) const { return {q_ + first, n}; }
  ConstVec u(int first, int n) const { return {u_ + first, n}; }
  /// Numbers that an element reserved in State::memory.
  ConstVec memory(MemoryHandle m) const { return {memory_ + m.first, m.size}; }
  /// A signal that an element requested by Topology::signal(), at this t, q, u and memory.
  double signal(SignalHandle h) const { return signals_->value(h, *this); }
  int frames() const { return static_cast<int>(frames_.size()); }
  const Frame& frame(FrameHandle f) const { return frames_[static_cast<std::size_t>(f.index)]; }

 private:
  void begin(const Topology& topology, double t, ConstVec q, ConstVec u, ConstVec memory,
             const SystemSubset* subset);
  void placeOthers(const Topology& topology);
  void evaluateFrame(const Topology& topology, std::size_t i);
  double t_ = 0.0;
  const double* q_ = nullptr;
  const double* u_ = nullptr;
  const double* memory_ = nullptr;
  const ReadSignals* signals_ = nullptr;
  std::vector<Frame> frames_;
  std::vector<double> jacobians_;
  const SystemSubset* some_ = nullptr;
  std::uint64_t subset_ = 0;  // stamp of the subset whose frames are present; 0: all are
};

}  // namespace dynamy
