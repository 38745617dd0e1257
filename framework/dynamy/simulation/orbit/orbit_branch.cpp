#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/simulation/orbit/branch_tracer.hpp>
#include <dynamy/simulation/orbit/orbit_multipliers.hpp>
#include <utility>

namespace dynamy {
namespace {

constexpr double kBranchTolerance = 1e-12;  ///< of runs

constexpr int kWaypoints = 20;  ///< about as many orbits on the way to a value

/// The orbit at p, by Newton's method.
Orbit firstOrbit(const OrbitMaker& make, double p, double tolerance, const State* start) {
  OrbitRequest wanted;
  Model model = make(p, wanted.section);
  wanted.tolerance = tolerance;
  return orbit(model, wanted, start);
}

/// What was found of half orbits, as that of whole ones.
void makeWhole(OrbitBranch& branch) {
  for (BranchPoint& p : branch.points) {
    p.period *= 2.0, p.multipliers = ofOrbit(p.multipliers, 2);
    if (p.kind != "flip") continue;
    p.kind = "symmetry";
    p.text =
        "a multiplier of half an orbit passes -1: two orbits without the symmetry branch off, "
        "each the mirror image of the other";
  }
}

}  // namespace

const State& OrbitBranch::near(double p) const {
  const auto found = std::min_element(
      points.begin(), points.end(),
      [&](const auto& a, const auto& b) { return std::abs(a.p - p) < std::abs(b.p - p); });
  return found->at;
}

State followedOrbit(const OrbitMaker& make, double from, double to, double tolerance,
                    const State* start) {
  OrbitCurve curve(make, std::min(from, to), std::max(from, to),
                   tolerance > 0.0 ? tolerance : kBranchTolerance, BranchRequest().residual);
  BranchTracer tracer(curve, kWaypoints);
  const std::vector<BranchPoint> points = tracer.follow(
      curve.start(from, firstOrbit(make, from, tolerance, start).at), to > from ? 1.0 : -1.0);
  if (tracer.last().p != to)
    throw ModelError(fmt::format("the orbit at {:g} cannot be followed to {:g}: at {:.9g} {}", from,
                                 to, points.back().p, points.back().text),
                     "follow it over a range (--over) to see where it ends");
  return tracer.last().orbit.start;
}

OrbitBranch orbitBranch(const OrbitMaker& make, const BranchRequest& wanted, const State* start) {
  BranchRequest request = wanted;
  if (request.from > request.to) std::swap(request.from, request.to);
  if (!(request.from < request.to))
    throw ModelError(fmt::format("there is nothing between {} and {}", request.from, request.to));
  if (request.tolerance <= 0.0) request.tolerance = kBranchTolerance;
  State begin;
  const double inside = std::clamp(request.at, request.from, request.to);
  if (inside != request.at) {
    begin = followedOrbit(make, request.at, inside, request.tolerance, start);
    request.at = inside, start = &begin;
  }
  const Orbit orbit = firstOrbit(make, request.at, request.tolerance, start);
  OrbitBranch out;
  out.section = orbit.section;
  for (const auto& [name, value] : orbit.state) out.signals.push_back(name);
  for (const auto& [name, value] : orbit.shift) out.ignorable.push_back(name);
  OrbitCurve curve(make, request.from, request.to, request.tolerance, request.residual);
  OrbitPoint first = curve.start(request.at, orbit.at);
  BranchTracer tracer(curve, request.points);
  out.points = tracer.follow(first, -1.0);
  std::reverse(out.points.begin(), out.points.end());
  out.start = out.points.size();
  out.points.push_back(tracer.result(first));
  for (BranchPoint& p : tracer.follow(first, 1.0)) out.points.push_back(std::move(p));
  for (BranchPoint* p : {&out.points.front(), &out.points.back()})
    if (p->kind.empty()) p->kind = "end", p->text = "the range of the parameter ends";
  if (!out.section.mirror.empty()) makeWhole(out);
  out.cycles = curve.cycles();
  return out;
}

}  // namespace dynamy
