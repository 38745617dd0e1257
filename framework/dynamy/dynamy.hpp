/// The one include of a plug-in with systems, contacts, laws, forces or shapes. Those of other plug-ins, which
/// pull in more of the framework: a scheme dynamy/stages/one_step.hpp, an impact law
/// dynamy/solver/impact/impact_law.hpp, a solver dynamy/solver/problem/inclusion_solver.hpp, an observer
/// dynamy/simulation/model/observer.hpp.
#pragma once
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/law/bilateral_rate.hpp>
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/shape_pair.hpp>
#include <dynamy/system/smooth_shape.hpp>
