// A sledge of 1 kg over a floor z = 0: q = (x, z). Its force is given; contacts with the floor are
// equal, so that more than one is redundant.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/located/phase/phase_request.hpp>
#include <dynamy/solver/prox_solvers.hpp>
#include <dynamy/stages/mechanical_system.hpp>
#include <functional>
#include <memory>

namespace dynamy::fixture {

class Sledge final : public PartialMechanicalSystem {
 public:
  using Force = std::function<Eigen::Vector2d(double t, ConstVec q, ConstVec u)>;
  Sledge(const Eigen::Vector2d& q, const Eigen::Vector2d& u, Force force)
      : q_(q), u_(u), force_(std::move(force)) {}
  Blocks blocks() const override { return {.nq = 2, .nu = 2, .capacity = 1, .constantMass = true}; }
  void initialState(Vec q, Vec u) const override { q = q_, u = u_; }
  void M(double, ConstVec, MassBlocks M) const override { M[0].setIdentity(); }
  void h(double t, ConstVec q, ConstVec u, Vec h) const override { h = force_(t, q, u); }

 private:
  Eigen::Vector2d q_, u_;
  Force force_;
};

/// Contacts 0 … count − 1: g = z, γ = (ż, ẋ).
class Floor final : public NonSmoothElement {
 public:
  Floor(const SetValuedForceLaw& law, int count) : law_(law), count_(count) {}
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    for (int id = 0; id < count_; ++id) {
      auto rows = sink.add(static_cast<std::uint64_t>(id), k.q(system_)[1], law_, 2);
      if (!rows) continue;
      Block W = rows.segment(BlockPlace{0, 0, 2});
      W(0, 1) = 1.0;
      if (rows.dim() > 1) W(1, 0) = 1.0;
    }
  }

 private:
  const SetValuedForceLaw& law_;
  int count_;
  SystemHandle system_;
};

struct SledgeScene {
  static constexpr double kG = 10.0;  // [m/s²]
  /// A force F along x beside the weight.
  static Sledge::Force pull(double F) {
    return [F](double, ConstVec, ConstVec) { return Eigen::Vector2d(F, -kG); };
  }
  SledgeScene(const Eigen::Vector2d& q, const Eigen::Vector2d& u, Sledge::Force force, double mu,
              double epsilonN = 0.0, int contacts = 1)
      : sledge(q, u, std::move(force)),
        law(epsilonN, 0.0, mu),
        floor(law, contacts),
        topology({&sledge}) {
    floor.connect(topology);
    SystemParts parts;
    parts.topology = &topology, parts.contacts = {&floor}, parts.impactLaw = &impact;
    system = std::make_unique<MechanicalSystem>(parts, 2);
    system->gTol(1e-12);
    x.q = q, x.u = u;
  }
  /// With the bias of the rows, as located runs request it; of the contacts `held` alone, ascending.
  const Evaluation& evaluate(const State& at, int slot = 0) {
    return system->evaluate(at, {.slot = slot, .bias = true});
  }
  const Evaluation& evaluate(const State& at, std::span<const ContactKey> held, int slot = 0) {
    return system->evaluate(at, PhaseRequest{}.holding(held, slot));
  }
  ContactKey key(int i = 0) const { return contactKey(0, static_cast<std::uint64_t>(i)); }
  Sledge sledge;
  UnilateralCoulomb law;
  Floor floor;
  Topology topology;
  NewtonImpact impact;
  std::unique_ptr<MechanicalSystem> system;
  ProxGaussSeidel solver;
  State x;
};

/// Gravity and friction of scenes with it, and the rounding of its forces and accelerations:
/// numbers of size 10 through a solve of up to four unknowns.
inline constexpr double kSledgeG = SledgeScene::kG, kSledgeMu = 0.5, kSledgeRounding = 1e-13;
/// The solver's default tolerance of 1e-10, relative to numbers of size 1 to 10.
inline constexpr double kSolved = 1e-8;

}  // namespace dynamy::fixture
