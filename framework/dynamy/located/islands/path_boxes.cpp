#include <algorithm>
#include <cmath>
#include <dynamy/located/islands/path_boxes.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kBetween = 1.2;  ///< factor on what a path does between two places
constexpr double kMargin = 1e-3;  ///< of the bound of a shape, on all sides
constexpr double kTurn =
    1.0;  ///< from this angle in a part on, a shape may be anywhere about its frame

}  // namespace

PathBoxes::Place PathBoxes::at(const MovingShape& shape, const Kinematics& k) {
  const Frame& f = k.frame(shape.frame);
  const Vec3 arm_I = f.A_IK * shape.arm_K;
  return {f.r_OS_I + arm_I, f.velocity(arm_I), f.Omega_I.norm()};
}

void PathBoxes::begin(std::span<const MovingShape> shapes, const Kinematics& k) {
  shapes_ = shapes;
  times_.assign(1, k.t());
  last_.clear(), boxes_.clear(), whole_.clear(), all_.setEmpty();
  for (const MovingShape& shape : shapes_) last_.push_back(at(shape, k));
}

double PathBoxes::stretch(std::span<const MovingShape> shapes, const Kinematics& k, double dt) {
  double most = 0.0;
  for (const MovingShape& shape : shapes) {
    const Place place = at(shape, k);
    most = std::max({most, dt * place.v.norm() / shape.bound, dt * place.Omega});
  }
  return most;
}

/// Appends the box of a shape in a part from a to b.
void PathBoxes::add(std::size_t shape, const Place& a, const Place& b, double dt, double arm) {
  const Vec3 near = a.r + dt / 3.0 * a.v, far = b.r - dt / 3.0 * b.v;
  Box hull(a.r.cwiseMin(b.r), a.r.cwiseMax(b.r));
  hull.extend(near).extend(far);
  const double bound = shapes_[shape].bound;
  // A shape far from the axis about which it turns leaves the cubic through its two places.
  const bool turns = dt * std::max(a.Omega, b.Omega) > kTurn;
  const Vec3 beyond = 0.5 * (kBetween - 1.0) * hull.sizes() +
                      Vec3::Constant((1.0 + kMargin) * bound + (turns ? 2.0 * arm : 0.0));
  boxes_.emplace_back(hull.min() - beyond, hull.max() + beyond);
  whole_.back().extend(boxes_.back());
}

void PathBoxes::pass(const Kinematics& k) {
  const double dt = k.t() - times_.back();
  times_.push_back(k.t());
  whole_.emplace_back();
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Place place = at(shapes_[i], k);
    add(i, last_[i], place, dt, shapes_[i].arm_K.norm());
    last_[i] = place;
  }
  all_.extend(whole_.back());
}

void PathBoxes::expect(std::span<const MovingShape> shapes, const Kinematics& k, double h) {
  begin(shapes, k);
  times_.push_back(k.t() + h);
  whole_.emplace_back();
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Place a = last_[i];
    const Place b{a.r + h * a.v, a.v, a.Omega};
    add(i, a, b, h, shapes_[i].arm_K.norm());
  }
  all_ = whole_.back();
}

bool PathBoxes::partsMeet(std::size_t k, const PathBoxes& other, std::size_t l) const {
  if (!whole_[k].intersects(other.whole_[l])) return false;
  const std::size_t n = shapes_.size(), m = other.shapes_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Box& box = boxes_[k * n + i];
    if (!box.intersects(other.whole_[l])) continue;
    for (std::size_t j = 0; j < m; ++j)
      if (box.intersects(other.boxes_[l * m + j])) return true;
  }
  return false;
}

double PathBoxes::meets(const PathBoxes& other, double from) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (!all_.intersects(other.all_)) return never;
  double first = never;
  for (std::size_t k = 0; k < parts(); ++k) {
    if (times_[k] >= first) break;
    if (times_[k + 1] <= from) continue;
    for (std::size_t l = 0; l < other.parts(); ++l) {
      const double begin = std::max({times_[k], other.times_[l], from});
      const double end = std::min(times_[k + 1], other.times_[l + 1]);
      if (begin >= end || begin >= first) continue;
      if (partsMeet(k, other, l)) first = begin;
    }
  }
  return first;
}

bool PathBoxes::meets(const PathBoxes& other) const {
  if (!all_.intersects(other.all_)) return false;
  for (std::size_t k = 0; k < parts(); ++k)
    for (std::size_t l = 0; l < other.parts(); ++l)
      if (partsMeet(k, other, l)) return true;
  return false;
}

}  // namespace dynamy
