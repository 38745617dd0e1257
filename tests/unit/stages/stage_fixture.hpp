// Small systems and contacts for tests of stages and schemes.
#pragma once
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/schemes/moreau_midpoint.hpp>
#include <dynamy/solver/prox_solvers.hpp>
#include <functional>

namespace dynamy::fixture {

/// Masses on vertical lines: q heights, u velocities, h by a function (default: weight).
class Masses final : public PartialMechanicalSystem {
 public:
  using Force = std::function<void(double t, ConstVec q, ConstVec u, Vec h)>;
  Masses(Eigen::VectorXd m, Eigen::VectorXd q, Eigen::VectorXd u, Force force)
      : m_(std::move(m)), q_(std::move(q)), u_(std::move(u)), force_(std::move(force)) {}
  static Force weight(const Eigen::VectorXd& m) {
    return [m](double, ConstVec, ConstVec, Vec h) { h = -9.81 * m; };
  }
  Blocks blocks() const override {
    return {.nq = 1, .nu = 1, .capacity = static_cast<int>(m_.size()), .constantMass = true};
  }
  void initialState(Vec q, Vec u) const override { q = q_, u = u_; }
  void M(double, ConstVec, MassBlocks M) const override {
    for (int b = 0; b < M.capacity(); ++b) M[b](0, 0) = m_[b];
  }
  void h(double t, ConstVec q, ConstVec u, Vec h) const override { force_(t, q, u, h); }

 private:
  Eigen::VectorXd m_, q_, u_;
  Force force_;
};

/// Contacts g = q_a − q_b (b = −1: the ground at 0) of system 0, numbered by `id`, in this order.
struct Pair {
  std::uint64_t id;
  int a, b;
};
class Stack final : public NonSmoothElement {
 public:
  Stack(std::vector<Pair> all, double epsilon) : pairs(std::move(all)), law_(epsilon) {}
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    for (const Pair& p : pairs) {
      const double g = k.q(system_)[p.a] - (p.b < 0 ? 0.0 : k.q(system_)[p.b]);
      auto rows = sink.add(p.id, g, law_, 1);
      if (!rows) continue;
      rows.segment(BlockPlace{p.a, p.a, 1})(0, 0) = 1.0;
      if (p.b >= 0) rows.segment(BlockPlace{p.b, p.b, 1})(0, 0) = -1.0;
    }
  }
  std::vector<Pair> pairs;

 private:
  Unilateral law_;
  SystemHandle system_;
};

/// System, contacts and state, ready for steps.
struct Scene {
  Scene(const Eigen::VectorXd& m, const Eigen::VectorXd& q, const Eigen::VectorXd& u,
        std::vector<Pair> pairs = {}, double epsilon = 0.0, Masses::Force force = {})
      : masses(m, q, u, force ? std::move(force) : Masses::weight(m)),
        stack(std::move(pairs), epsilon),
        topology({&masses}) {
    stack.connect(topology);
    parts.topology = &topology;
    parts.contacts = {&stack};
    parts.impactLaw = &law;
    system = std::make_unique<MechanicalSystem>(parts);
    system->gTol(1e-12);
    x.q = q, x.u = u;
  }
  StepReport step(double dt) { return scheme.step(*system, solver, x, dt); }
  Masses masses;
  Stack stack;
  Topology topology;
  NewtonImpact law;
  SystemParts parts;
  std::unique_ptr<MechanicalSystem> system;
  MoreauMidpoint scheme;
  ProxGaussSeidel solver;
  State x;
};

}  // namespace dynamy::fixture
