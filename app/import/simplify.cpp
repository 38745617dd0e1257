#include "import/simplify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>

namespace dynamy::app {
namespace {

void say(Machine& m, const Link& link, const std::string& text) {
  m.notes.push_back({link.place, "link " + link.name, text});
}

Skin movedBy(Skin skin, const Pose& pose) {
  skin.pose = pose * skin.pose;
  return skin;
}

/// Gives a link what another one has that is rigidly connected with it at `pose`.
void take(Link& link, const Link& other, const Pose& pose) {
  link.inertia.add(other.inertia, pose);
  for (const Skin& skin : other.skins) link.skins.push_back(movedBy(skin, pose));
  link.frames.emplace_back(other.name, pose);
  for (const auto& [name, own] : other.frames) link.frames.emplace_back(name, pose * own);
}

/// Removes link `gone`, which is rigidly connected with link `into`, at `pose` in its frame.
void merge(Machine& m, int gone, int into, const Pose& pose) {
  take(m.links[at(into)], m.links[at(gone)], pose);
  const auto renumbered = [&](int i) { return i == gone ? into : i; };
  for (Link& link : m.links)
    if (link.parent == gone) link.parent = into, link.pose = pose * link.pose;
  for (LoopJoint& loop : m.loops) {
    if (loop.B == gone) loop.at = pose.point(loop.at), loop.axis = pose.A * loop.axis;
    loop.A = renumbered(loop.A), loop.B = renumbered(loop.B);
  }
  for (auto& [a, b] : m.apart) a = renumbered(a), b = renumbered(b);
  m.links.erase(m.links.begin() + gone);
  const auto after = [&](int& i) { i -= i > gone ? 1 : 0; };
  for (Link& link : m.links) after(link.parent);
  for (LoopJoint& loop : m.loops) after(loop.A), after(loop.B);
  for (auto& [a, b] : m.apart) after(a), after(b);
}

/// Links without mass that are rigidly connected with their parent become parts of it.
void joinMassless(Machine& m) {
  for (int i = static_cast<int>(m.links.size()); i-- > 0;) {
    const Link& link = m.links[at(i)];
    if (!link.rigid() || !link.inertia.none()) continue;
    if (link.parent < 0) continue;  // stands still: it stays as a ground
    const std::string& parent = m.links[at(link.parent)].name;
    say(m, link, "has no mass: is a part of \"" + parent + '"');
    merge(m, i, link.parent, Pose(link.pose));
  }
}

/// A link without mass that moves takes over a link that is rigidly connected with it.
void fillMassless(Machine& m) {
  for (int i = 0; i < static_cast<int>(m.links.size()); ++i) {
    if (m.links[at(i)].rigid()) continue;
    for (int k = i + 1; k < static_cast<int>(m.links.size()) && m.links[at(i)].inertia.none();
         ++k) {
      const Link& child = m.links[at(k)];
      if (child.parent != i || !child.rigid()) continue;
      say(m, child, "is a part of \"" + m.links[at(i)].name + "\", which has no mass of its own");
      merge(m, k, i, Pose(child.pose));
      --k;
    }
  }
}

double totalMass(const Machine& m) {
  double all = 0.0;
  for (const Link& link : m.links) all += std::max(link.inertia.mass, 0.0);
  return all > 0.0 ? all : 1.0;
}

/// What moves without mass gets kTinyShare of the machine's mass and a radius of inertia of 0.1 m.
Inertia tiny(double all) {
  constexpr double kRadius = 0.1;  // [m]
  Inertia out;
  out.mass = kTinyShare * all;
  out.J = out.mass * kRadius * kRadius * Mat3::Identity();
  return out;
}

/// The principal moments of a real body fulfil A + B >= C. What lacks is added to all three.
void makeReal(Machine& m, Link& link) {
  Mat3& J = link.inertia.J;
  const Vec3 p = symmetricEigenPairs(J).values;
  const double least = kTinyShare * link.inertia.mass * link.inertia.mass / totalMass(m);
  const double lack = std::max({p[2] - p[1] - p[0], least - p[0], 0.0});
  constexpr double kRounding = 1e-12;
  if (!(lack > kRounding * p[2])) return;
  J += lack * Mat3::Identity();
  say(m, link,
      fmt::format("no mass distribution has its inertia: {:.3g} kg m^2 is added to all moments",
                  lack));
}

/// Puts bodies between the joints of links that have several.
void oneJointEach(Machine& m, double all) {
  for (int i = 0; i < static_cast<int>(m.links.size()); ++i) {
    if (m.links[at(i)].joints.size() < 2) continue;
    Link between;
    {
      Link& link = m.links[at(i)];
      between.name = link.name + "_" + link.joints.front().name;
      between.parent = link.parent, between.pose = link.pose, between.place = link.place;
      between.joints = {link.joints.front()}, between.between = true;
      link.joints.erase(link.joints.begin());
      link.pose = Pose();
    }
    between.inertia = tiny(all);
    say(m, m.links[at(i)],
        fmt::format("has several joints: the body \"{}\" of {:.2g} kg stands between them",
                    between.name, between.inertia.mass));
    m.links.insert(m.links.begin() + i, between);
    const auto after = [&](int& k) { k += k >= i ? 1 : 0; };
    for (std::size_t k = 0; k < m.links.size(); ++k)
      if (k != at(i)) after(m.links[k].parent);
    for (LoopJoint& loop : m.loops) after(loop.A), after(loop.B);
    for (auto& [a, b] : m.apart) after(a), after(b);
    m.links[at(i + 1)].parent = i;
  }
}

/// A value inside of the limits, as near to the file's pose as the middle of the limits allows.
void chooseStart(Machine& m, MachineJoint& joint) {
  if (!joint.startGiven) joint.start = joint.reference;
  const double low = joint.lower.value_or(-HUGE_VAL), high = joint.upper.value_or(HUGE_VAL);
  if (low <= joint.start && joint.start <= high) return;
  if (joint.startGiven) {
    m.notes.push_back({joint.place, "joint " + joint.name,
                       fmt::format("its limits exclude {:g}, where it starts", joint.start)});
    return;
  }
  joint.start = joint.lower && joint.upper ? 0.5 * (low + high) : (joint.lower ? low : high);
  m.notes.push_back(
      {joint.place, "joint " + joint.name,
       fmt::format("its limits exclude {:g}: it starts at {:.6g}", joint.reference, joint.start)});
}

}  // namespace

void simplify(Machine& m) {
  joinMassless(m);
  fillMassless(m);
  joinMassless(m);
  const double all = totalMass(m);
  for (Link& link : m.links) {
    if (!link.inertia.none()) makeReal(m, link);
    if (link.rigid() || !link.inertia.none()) continue;
    link.inertia = tiny(all);
    say(m, link, fmt::format("moves without mass: gets {:.2g} kg", link.inertia.mass));
  }
  oneJointEach(m, all);
  for (std::size_t i = 0; i < m.links.size(); ++i)
    for (MachineJoint& joint : m.links[i].joints) chooseStart(m, joint);
}

Pose moved(const MachineJoint& joint, double value) {
  const double q = value - joint.reference;
  if (joint.kind == MachineJoint::Kind::slide) return {q * joint.axis, Mat3::Identity()};
  if (joint.kind == MachineJoint::Kind::ball) return {};
  const Mat3 A = turned(joint.axis, q);
  return {joint.at - A * joint.at, A};
}

std::vector<Pose> startPoses(const Machine& m) {
  std::vector<Pose> out;
  for (const Link& link : m.links) {
    Pose pose = link.parent < 0 ? link.pose : out[at(link.parent)] * link.pose;
    for (const MachineJoint& joint : link.joints) pose = pose * moved(joint, joint.start);
    out.push_back(pose);
  }
  return out;
}

}  // namespace dynamy::app
