#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/system/kinematics.hpp>
#include <new>

namespace dynamy {

void Kinematics::resize(const Topology& topology, const std::vector<FrameHandle>* only) {
  const auto& requested = topology.requestedFrames();
  const auto velocities = [&](FrameHandle f) {
    return topology.system(requested[static_cast<std::size_t>(f.index)].first).blockNu;
  };
  absent_.absent = absent_.outside = true;
  subset_ = 0;                                     // frames made anew are those of no subset yet
  frames_ = std::vector<Frame>(requested.size());  // a Frame that is assigned copies into its maps
  const std::size_t count = only != nullptr ? only->size() : requested.size();
  const auto frame = [&](std::size_t i) {
    return only != nullptr ? (*only)[i] : FrameHandle{static_cast<int>(i)};
  };
  std::size_t size = 0;
  for (std::size_t i = 0; i < count; ++i)
    size += 6 * static_cast<std::size_t>(velocities(frame(i)));
  jacobians_.assign(size, 0.0);
  double* next = jacobians_.data();
  for (std::size_t i = 0; i < count; ++i) {
    const FrameHandle f = frame(i);
    Frame& at = frames_[static_cast<std::size_t>(f.index)];
    const int nu = velocities(f);
    new (&at.J_S_I) Mat3X(next, 3, nu);
    new (&at.J_R_I) Mat3X(next + 3 * nu, 3, nu);
    next += 6 * nu;
  }
}

void Kinematics::begin(const Topology& topology, double t, ConstVec q, ConstVec u, ConstVec memory,
                       const SystemSubset* subset) {
  t_ = t, q_ = q.data(), u_ = u.data(), memory_ = memory.data();
  topology_ = &topology;
  if (frames_.size() != topology.requestedFrames().size()) resize(topology);
  const std::uint64_t stamp = subset ? subset->stamp() : 0;
  const bool others = subset_ != stamp;
  some_ = subset, own_ = subset ? subset->own() : nullptr, subset_ = stamp;
  if (others) placeOthers(topology);
}

void Kinematics::evaluate(const Topology& topology, double t, ConstVec q, ConstVec u,
                          ConstVec memory, const SystemSubset* subset) {
  begin(topology, t, q, u, memory, subset);
  if (subset != nullptr && own_ == nullptr)
    for (const int i : subset->frames()) evaluateFrame(topology, static_cast<std::size_t>(i));
  else
    for (std::size_t i = 0; i < frames_.size(); ++i) evaluateFrame(topology, i);
}

void Kinematics::evaluate(const Topology& topology, double t, ConstVec q, ConstVec u,
                          ConstVec memory, const SystemSubset* subset,
                          std::span<const FrameHandle> frames) {
  begin(topology, t, q, u, memory, subset);
  for (const FrameHandle f : frames) {
    const int own = own_ != nullptr ? own_->of(f) : f.index;
    if (own < 0) continue;
    const auto i = static_cast<std::size_t>(own);
    if (own_ != nullptr || !subset || !subset->leavesOut(topology.requestedFrames()[i].first))
      evaluateFrame(topology, i);
  }
}

/// Marks the frames of systems outside of the subset. Those that rest are evaluated here, once.
void Kinematics::placeOthers(const Topology& topology) {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    Frame& f = frames_[i];
    f.absent = true;
    f.outside = own_ == nullptr && leavesOut(topology.requestedFrames()[i].first);
    if (f.outside && some_->outsideRests()) evaluateFrame(topology, i);
  }
}

void Kinematics::evaluateFrame(const Topology& topology, std::size_t i) {
  const auto& [index, id] = topology.requestedFrames()[i];
  const SystemHandle& s = topology.system(index);
  Frame& f = frames_[i];
  f.block = 0, f.absent = false;
  const PartialMechanicalSystem& system = *topology.systems()[static_cast<std::size_t>(s.index)];
  named(system, [&, id = id] { system.frame(t_, {q_ + s.q0, s.nq}, {u_ + s.u0, s.nu}, id, f); });
  // A frame without a block belongs to a system without velocities, or stands still.
  const bool moves = s.blocks > 0 && f.block >= 0;
  f.u0 = moves ? s.u0 + f.block * s.blockNu : s.u0;
  f.block = moves ? s.block0 + f.block : -1;
}

}  // namespace dynamy
