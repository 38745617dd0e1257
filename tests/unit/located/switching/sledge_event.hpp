// An event of the sledge at its present state, evaluated in slot 0 with all of its contacts.
#pragma once
#include <dynamy/located/switching/ongoing_event.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy::fixture {

/// L = 1 m, T = 1 s, tolerance 1e-6.
struct SledgeEvent {
  explicit SledgeEvent(SledgeScene& s, int contacts = 1)
      : scene(s), at{*s.system, s.solver, norm, p, result, request} {
    for (int i = 0; i < contacts; ++i) keys.push_back(s.key(i));
    p.x = s.x;
    p.a = Eigen::Vector2d(0.0, -SledgeScene::kG);
    evaluate();
  }
  void evaluate() { at.evaluate(p.x, keys); }
  SledgeScene& scene;
  std::vector<ContactKey> keys;
  ErrorNorm norm;
  PhasePoint p;
  EventResult result;
  PhaseRequest request;
  OngoingEvent at;
};

}  // namespace dynamy::fixture
