#include <algorithm>
#include <dynamy/core/declared/two_names.hpp>
#include <dynamy_elements/frame_pair.hpp>

namespace dynamy {

StartKinematics::StartKinematics(const Topology& topology) {
  place(topology);
  kinematics_.evaluate(topology, 0.0, {q_.data(), q_.size()}, {u_.data(), u_.size()});
}

StartKinematics::StartKinematics(const Topology& topology, const std::vector<FrameHandle>& frames) {
  place(topology);
  kinematics_.resize(topology, &frames);
  kinematics_.evaluate(topology, 0.0, {q_.data(), q_.size()}, {u_.data(), u_.size()}, {nullptr, 0},
                       nullptr, frames);
}

void StartKinematics::place(const Topology& topology) {
  q_.setZero(topology.nq()), u_.setZero(topology.nu());
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (s.nq + s.nu > 0)
      topology.systems()[i]->initialState(slice(q_, s.q0, s.nq), slice(u_, s.u0, s.nu));
  }
}

namespace {

/// Do both frames belong to one rigid body: is v_B = v_A + Ω × r_AB for all u?
bool belongToOneBody(const Frame& a, const Frame& b) {
  if (a.block < 0 || a.block != b.block || a.u0 != b.u0) return false;
  const Vec3 r = b.r_OS_I - a.r_OS_I;
  double off = 0.0, size = 0.0;
  for (int j = 0; j < a.nu(); ++j) {
    const Vec3 turn = a.J_R_I.col(j), way = a.J_S_I.col(j) + turn.cross(r);
    off = std::max({off, (b.J_R_I.col(j) - turn).norm(), (b.J_S_I.col(j) - way).norm()});
    size = std::max({size, turn.norm() * (1.0 + r.norm()), way.norm()});
  }
  return off <= 1e-12 * size;  // rounding of one or two rotations
}

}  // namespace

void FramePair::declare(Attributes& a) {
  Attribute& between = a.add(AttributeType::names, "between", std::nullopt,
                             "frames A and B: a system, or system.frame");
  between.referenceKind = "frame";
}

FramePair::FramePair(const Parameters& x) {
  const auto [a, b] = twoNames(x["between"], "two frames",
                               "write between=\"A B\", two bodies, or the <Ground> and a body");
  a_ = a, b_ = b;
}

void FramePair::find(Topology& topology, const Element& asking) {
  A = topology.frame(a_, asking);
  B = topology.frame(b_, asking);
}

void FramePair::belong(Topology& topology, const Element& asking) const {
  for (const std::string& name : {a_, b_}) {
    std::vector<std::string> known;
    if (const int system = topology.names().find(name, known).first; system >= 0)
      topology.noting().note(system);
    else
      topology.frame(name, asking);  // throws, with the nearest name
  }
}

void FramePair::connect(Topology& topology, const Element& asking) {
  find(topology, asking);
  const Blocks a = blocksOf(topology, A), b = blocksOf(topology, B);
  const auto one = [&] {
    const StartKinematics start(topology, {A, B});
    return belongToOneBody(start.frame(A), start.frame(B));
  };
  // Bodies of a tree that are fixed to each other are still two bodies: nothing moves between them.
  const auto [systemA, idA] = topology.requestedFrames()[static_cast<std::size_t>(A.index)];
  const auto [systemB, idB] = topology.requestedFrames()[static_cast<std::size_t>(B.index)];
  const bool sameNamed = topology.names().body(systemA, idA) == topology.names().body(systemB, idB);
  if (A.index == B.index || (systemA == systemB && sameNamed && one()))
    throw ModelError(a_ == b_ ? "between names \"" + a_ + "\" twice"
                              : "\"" + a_ + "\" and \"" + b_ + "\" belong to one body",
                     "nothing can act between a body and itself; name two bodies, or a body and "
                     "the ground");
  if (a.nu == 0 && b.nu == 0)
    throw ModelError("\"" + a_ + "\" and \"" + b_ + "\" both stand still or move as given",
                     "one of the two has to be a body with velocities of its own");
  planeNormal = commonPlane(a, b);
}

Blocks blocksOf(const Topology& topology, FrameHandle frame) {
  const int system = topology.requestedFrames()[static_cast<std::size_t>(frame.index)].first;
  return topology.systems()[static_cast<std::size_t>(system)]->blocks();
}

void requireMoving(const Topology& topology, FrameHandle frame, const std::string& name) {
  if (blocksOf(topology, frame).nu > 0) return;
  throw ModelError(
      "a force has no effect on \"" + name + "\", which stands still or moves as given",
      "name a body with velocities of its own");
}

Vec3 commonPlane(const Blocks& a, const Blocks& b) {
  if (a.nu == 0) return b.planeNormal;
  if (b.nu == 0) return a.planeNormal;
  // The normals are unit vectors: the cross product of parallel ones is a rounding error.
  const bool parallel = a.planeNormal.cross(b.planeNormal).norm() < 1e-12;
  return parallel && !b.planeNormal.isZero(0.0) ? a.planeNormal : Vec3(Vec3::Zero());
}

}  // namespace dynamy
