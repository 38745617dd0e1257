/// The one include of a plug-in.
#pragma once
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/law/bilateral_rate.hpp>
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <dynamy/stages/one_step.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/smooth_shape.hpp>
