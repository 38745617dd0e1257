// Masses on vertical lines (stage_fixture.hpp) with rods between them and contacts.
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "unit/stages/stage_fixture.hpp"

namespace dynamy::fixture {

/// Joints q_a − q_b = length, without jointForces: Newton's method takes differences.
struct Rod {
  int a, b;
  double length;
};
class Rods final : public NonSmoothElement {
 public:
  explicit Rods(std::vector<Rod> all) : all_(std::move(all)) {}
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    std::uint64_t id = 0;
    for (const Rod& rod : all_) {
      const ConstVec q = k.q(system_);
      auto rows = sink.add(id++, q[rod.a] - q[rod.b] - rod.length, law_, 1);
      rows.segment(BlockPlace{rod.a, rod.a, 1})(0, 0) = 1.0;
      rows.segment(BlockPlace{rod.b, rod.b, 1})(0, 0) = -1.0;
    }
  }

 private:
  std::vector<Rod> all_;
  Bilateral law_;
  SystemHandle system_;
};

/// Element 0: contacts of the masses; element 1: rods.
struct LinkedMasses {
  LinkedMasses(const Eigen::VectorXd& m, const Eigen::VectorXd& q, const Eigen::VectorXd& u,
               std::vector<Rod> links, std::vector<Pair> pairs = {}, double epsilon = 0.0,
               Masses::Force force = {})
      : masses(m, q, u, force ? std::move(force) : Masses::weight(m)),
        stack(std::move(pairs), epsilon),
        rods(std::move(links)),
        topology({&masses}) {
    SystemParts parts;
    parts.topology = &topology, parts.impactLaw = &law;
    parts.contacts = {&stack, &rods};
    stack.connect(topology), rods.connect(topology);
    system = std::make_unique<MechanicalSystem>(parts, 2);
    system->gTol(1e-12);
    x.q = q, x.u = u;
  }
  Masses masses;
  Stack stack;
  Rods rods;
  Topology topology;
  NewtonImpact law;
  std::unique_ptr<MechanicalSystem> system;
  ProxGaussSeidel solver;
  State x;
};

}  // namespace dynamy::fixture
