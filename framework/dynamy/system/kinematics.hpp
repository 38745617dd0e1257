/// Kinematics: t, q, u and the frames of one evaluation, which contacts and forces read. Each frame
/// is evaluated once.
#pragma once
#include <dynamy/system/system_subset.hpp>
#include <span>

namespace dynamy {

class Kinematics {
 public:
  /// Reserves room for all frames requested in `topology`, or for `only` these, of which alone it can
  /// be asked then; no allocation later.
  void resize(const Topology& topology, const std::vector<FrameHandle>* only = nullptr);
  /// Keeps views of `q`, `u` and `memory`, which must outlive their use, and evaluates all frames,
  /// or those of a subset: the others are absent, or stay where they rest. Calls resize() if that
  /// was not done. Where the subset omits others, `topology`, q and u are those of its systems alone,
  /// and handles stay those of the whole model.
  void evaluate(const Topology& topology, double t, ConstVec q, ConstVec u,
                ConstVec memory = {nullptr, 0}, const SystemSubset* subset = nullptr);

  /// As above, but evaluates `frames` alone: the others stay as they are.
  void evaluate(const Topology& topology, double t, ConstVec q, ConstVec u, ConstVec memory,
                const SystemSubset* subset, std::span<const FrameHandle> frames);

  double t() const { return t_; }
  /// True: the system takes no part in this evaluation, see SystemSubset.
  bool leavesOut(int system) const { return some_ != nullptr && some_->leavesOut(system); }
  /// Where frames() are those of some systems, numbered anew; null: they have the numbers of handles.
  const OwnNumbers* numbers() const { return own_; }
  /// Another number whenever other systems take part; 0: all do.
  std::uint64_t stamp() const { return subset_; }
  ConstVec q(const SystemHandle& s) const { return {q_ + own(s).q0, s.nq}; }
  ConstVec u(const SystemHandle& s) const { return {u_ + own(s).u0, s.nu}; }
  /// Of the system with this index in the whole model.
  ConstVec q(int system) const { return {q_ + handle(system).q0, handle(system).nq}; }
  ConstVec u(int system) const { return {u_ + handle(system).u0, handle(system).nu}; }
  /// Numbers that an element reserved in State::memory.
  ConstVec memory(MemoryHandle m) const { return {memory_ + m.first, m.size}; }
  /// A signal that an element requested by Topology::signal(), at this t, q, u and memory.
  double signal(SignalHandle h) const { return topology_->signals().value(h, *this); }
  const Frame& frame(FrameHandle f) const {
    if (own_ == nullptr) return frames_[static_cast<std::size_t>(f.index)];
    const int own = own_->of(f);
    return own < 0 ? absent_ : frames_[static_cast<std::size_t>(own)];
  }
  /// Those for which there is room, in their order.
  const std::vector<Frame>& frames() const { return frames_; }

 private:
  void begin(const Topology& topology, double t, ConstVec q, ConstVec u, ConstVec memory,
             const SystemSubset* subset);
  const SystemHandle& own(const SystemHandle& s) const {
    return own_ != nullptr ? own_->handle(s.index) : s;
  }
  const SystemHandle& handle(int system) const {
    return own_ != nullptr ? own_->handle(system) : topology_->system(system);
  }
  void placeOthers(const Topology& topology);
  void evaluateFrame(const Topology& topology, std::size_t i);
  double t_ = 0.0;
  const double* q_ = nullptr;
  const double* u_ = nullptr;
  const double* memory_ = nullptr;
  const Topology* topology_ = nullptr;
  std::vector<Frame> frames_;
  Frame absent_;  // of systems for which there is no room
  std::vector<double> jacobians_;
  const SystemSubset* some_ = nullptr;
  const OwnNumbers* own_ = nullptr;
  std::uint64_t subset_ = 0;  // stamp of the subset whose frames are present; 0: all are
};

}  // namespace dynamy
