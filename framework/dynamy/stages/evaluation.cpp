#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/stages/evaluation.hpp>

namespace dynamy {

ContactRequest contactRequest(const EvaluationRequest& request, double gTol) {
  ContactRequest out;
  out.gTol = gTol + request.reach, out.bias = request.bias;
  if (!request.held) return out;
  out.refresh = true, out.frozen = request.held->keys;
  out.follow = request.held->follow, out.alone = request.held->alone;
  out.near = request.held->near;
  return out;
}

void reportContacts(const SystemParts& parts, const Kinematics& k, ContactSink& sink,
                    std::span<const char> only) {
  parts.forContacts([&](std::size_t i) {
    if (!only.empty() && only[i] == 0) return;
    const NonSmoothElement& element = *parts.contacts[i];
    sink.element(static_cast<int>(i));
    named(element, [&] { element.contacts(k, sink); });
  });
}

}  // namespace dynamy
