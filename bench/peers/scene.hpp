/// A scene of many bodies as bench/scenes/random_scenes.py writes it, and the answer of a peer.
///
///   scene_NAME FILE     cpu S of all steps but the first; pose x y z qw qx qy qz v Ω (body axes)
///
/// One pose line a body and sample; samples are evenly spread over the steps.
#pragma once
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "peer.hpp"

namespace peer {

struct SceneBody {
  std::string kind;
  std::vector<double> size;
  double mass = 0.0;
  std::array<double, 3> inertia{}, at{};
  std::array<double, 4> turn{};    ///< w x y z
  std::array<double, 3> v{}, w{};  ///< w in the body's axes
};
struct SceneJoint {
  std::string kind;
  std::size_t a = 0, b = 0;
  std::array<double, 3> at{}, axis{};
};
struct Scene {
  double h = 0.0, g = 0.0, mu = 0.0, e = 0.0;
  long steps = 0, samples = 0;
  std::vector<std::array<double, 6>> planes;  ///< point and normal
  std::vector<std::array<double, 10>> slabs;  ///< size, place, quaternion w x y z
  std::vector<SceneBody> bodies;
  std::vector<SceneJoint> joints;
};

template <std::size_t N>
std::istream& operator>>(std::istream& in, std::array<double, N>& out) {
  for (double& x : out) in >> x;
  return in;
}

inline Scene readScene(const char* file) {
  Scene s;
  std::ifstream in(file);
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream row(line);
    row >> word;
    if (word == "run") row >> s.h >> s.steps >> s.samples;
    if (word == "law") row >> s.g >> s.mu >> s.e;
    if (word == "plane") row >> s.planes.emplace_back();
    if (word == "slab") row >> s.slabs.emplace_back();
    if (word == "body") {
      SceneBody& b = s.bodies.emplace_back();
      std::size_t n = 0;
      row >> b.kind >> n;
      b.size.resize(n);
      for (double& x : b.size) row >> x;
      row >> b.mass >> b.inertia >> b.at >> b.turn >> b.v >> b.w;
    }
    if (word == "joint") {
      SceneJoint& j = s.joints.emplace_back();
      row >> j.kind >> j.a >> j.b >> j.at >> j.axis;
    }
  }
  return s;
}

/// Steps through the scene; `pose(i)` gives the 13 numbers of a body.
template <class Step, class Pose>
void runScene(const Scene& s, Step&& step, Pose&& pose) {
  double cpu = 0.0;
  std::string out;
  long next = 1;
  for (long i = 1; i <= s.steps; ++i) {
    const double begin = processTime();
    step();
    if (i > 1) cpu += processTime() - begin;
    if (i < next * s.steps / s.samples) continue;
    ++next;
    for (std::size_t k = 0; k < s.bodies.size(); ++k) {
      out += "pose";
      for (const double x : pose(k)) {
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), " %.17g", x);
        out += text.data();
      }
      out += '\n';
    }
  }
  std::printf("cpu %.9g\n%s", cpu, out.c_str());
}

}  // namespace peer
