#include "live/hand.hpp"

#include <dynamy/io/plugin/registry.hpp>

namespace dynamy::app {
namespace {

constexpr const char* kHand = "Hand";

}  // namespace

void Hand::declare(Attributes& a) {
  a.about("Spring by which a person pulls a body of a running model.");
}

void Hand::connect(Topology& topology) {
  memory_ = topology.memory(*this, std::vector<double>(kNumbers, 0.0));
  // Most of the time the hand holds nothing: it must not make all systems one island.
  topology.noting().begin(nullptr);
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& system = topology.system(static_cast<int>(i));
    if (system.nu == 0) continue;
    for (int id = 0; id < topology.systems()[i]->frames(); ++id) {
      frames_.emplace_back(static_cast<int>(i), id);
      handles_.push_back(topology.frame(system, id));
    }
  }
}

void Hand::addTo(const Kinematics& k, ForceSink& sink) const {
  const ConstVec m = k.memory(memory_);
  const int held = static_cast<int>(m[0]) - 1;
  if (held < 0 || held >= static_cast<int>(handles_.size())) return;
  if (k.leavesOut(frames_[static_cast<std::size_t>(held)].first)) return;
  const Frame& frame = k.frame(handles_[static_cast<std::size_t>(held)]);
  if (frame.absent) return;
  const Vec3 rho_I = frame.A_IK * Vec3(m[1], m[2], m[3]);
  const Vec3 r_PT = Vec3(m[4], m[5], m[6]) - frame.r_OS_I - rho_I;
  sink.force(frame, rho_I, m[7] * r_PT - m[8] * frame.velocity(rho_I));
}

std::array<double, Hand::kNumbers> Hand::numbers(const Grip& g) {
  return {g.frame + 1.0, g.point[0],  g.point[1],  g.point[2], g.target[0],
          g.target[1],   g.target[2], g.stiffness, g.damping};
}

double Hand::massAt(const Model& model, const State& x, const Grip& grip) const {
  const Topology& topology = model.topology();
  Kinematics kinematics;
  MassMatrix mass;
  mass.resize(topology);
  kinematics.evaluate(topology, x.t, view(x.q), view(x.u), view(x.memory));
  mass.evaluate(topology, x.t, view(x.q));
  const Frame& frame = kinematics.frame(handles_.at(static_cast<std::size_t>(grip.frame)));
  Eigen::VectorXd h(x.u.size()), none(x.u.size()), uDot(x.u.size());
  int moving = 0;
  double inverse = 0.0;
  for (int i = 0; i < 3; ++i) {
    h.setZero(), none.setZero();
    ForceSink sink(view(h), view(none));
    sink.force(frame, frame.A_IK * grip.point, Vec3::Unit(i));
    mass.applyInverse(view(std::as_const(h)), view(uDot));
    const double along = h.dot(uDot);
    if (along > 0.0) inverse += along, ++moving;
  }
  return moving > 0 ? moving / inverse : 0.0;
}

const Hand* handOf(const Model& model) {
  for (const auto& f : model.forces())
    if (f->type() == kHand) return static_cast<const Hand*>(f.get());
  return nullptr;
}

void addHands(Registry& registry) {
  registry.addCompletion([](Model& model) {
    if (handOf(model) == nullptr)
      model.add(std::make_unique<Hand>(Parameters::of<Hand>(kHand, "", {})));
  });
}

}  // namespace dynamy::app
