/// What one closed contact did in one step: its discrete status and whether it was an impact.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/record_sink.hpp>
#include <dynamy/simulation/report/step_impacts.hpp>
#include <string>

namespace dynamy {

/// Status from the prox argument Λ − ξ (r = 1; at a solution any r > 0 gives the same status),
/// ξ = γ^E + ε γ^A.
Status contactStatus(const StepView& view, int contact);

/// What a picture of one closed contact shows. Its friction limit is the projection of a tangential
/// force far outside the law's set, which works for every law.
ContactRecord contactRecord(const StepView& view, StepImpacts& impacts, int contact);
/// The same at an instant of the step; `instant.lambda` holds its forces then times Δt [N s].
ContactRecord contactRecord(const StepView& view, const ContactInstant& instant, int contact);

/// "floor", "Contact#2" for elements without a name, "floor/17" for one contact of many.
std::string contactName(const Model& model, ContactKey key);

/// Name of a contact with the place of its element: "floor (ball.xml:12)".
std::string contactText(const Model& model, ContactKey key);

/// `<RigidBody name="ball"> (ball.xml:12)`: how messages name an element.
std::string elementText(const Element& e);

/// The same of a system.
std::string systemName(const Model& model, int system);

}  // namespace dynamy
