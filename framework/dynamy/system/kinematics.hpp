/// Kinematics: t, q, u and the frames of one evaluation; what contacts and forces see. Each frame
/// is evaluated once.
#pragma once
#include <dynamy/system/topology.hpp>

namespace dynamy {

class Kinematics {
 public:
  /// Reserves room for all frames asked for in `topology`; no allocation later.
  void resize(const Topology& topology);
  /// Points at q, u, memory and evaluates all frames. `q`, `u` and `memory` must outlive the use.
  /// Reserves the room itself if nobody has.
  void evaluate(const Topology& topology, double t, ConstVec q, ConstVec u,
                ConstVec memory = {nullptr, 0});

  double t() const { return t_; }
  ConstVec q(const SystemHandle& s) const { return {q_ + s.q0, s.nq}; }
  ConstVec u(const SystemHandle& s) const { return {u_ + s.u0, s.nu}; }
  /// Numbers an element reserved in State::memory.
  ConstVec memory(MemoryHandle m) const { return {memory_ + m.first, m.size}; }
  const Frame& frame(FrameHandle f) const { return frames_[static_cast<std::size_t>(f.index)]; }

 private:
  double t_ = 0.0;
  const double* q_ = nullptr;
  const double* u_ = nullptr;
  const double* memory_ = nullptr;
  std::vector<Frame> frames_;
  std::vector<double> jacobians_;
};

}  // namespace dynamy
