/// The one include of a plug-in.
#pragma once
#include <dynamy/contact/bilateral_rate.hpp>
#include <dynamy/contact/convex_sets.hpp>
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/contact/standard_laws.hpp>
#include <dynamy/integrator/one_step.hpp>
#include <dynamy/io/plugin.hpp>
#include <dynamy/solver/inclusion_solver.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
