#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/travel_watch.hpp>
#include <dynamy/simulation/report/turning_frames.hpp>
#include <limits>
#include <map>

namespace dynamy {
namespace {

/// Smallest extent along an axis [m]; infinite for flat shapes: nothing passes the ground.
double extent(const std::vector<Vec3>& points) {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double least = (high - low).minCoeff();
  return least > 0.0 ? least : std::numeric_limits<double>::infinity();
}

/// Smallest extent of a shape [m]; infinite for a half space and a bore, which nothing passes.
double smallestSize(const ShapeGeometry& g) {
  switch (g.type) {
    case ShapeType::halfSpace:
    case ShapeType::bore:
      return std::numeric_limits<double>::infinity();
    case ShapeType::box:
      return std::min({g.size[0], g.size[1], g.size[2]});
    case ShapeType::cylinder:
    case ShapeType::cone:
      return std::min(2.0 * g.size[0], g.size[1]);
    case ShapeType::ellipsoid:
      return 2.0 * std::min({g.size[0], g.size[1], g.size[2]});
    case ShapeType::torus:
      return 2.0 * g.size[1];
    case ShapeType::mesh:
    case ShapeType::polyhedron:
      return extent(g.points);
    case ShapeType::point:
      return 0.0;
    default:
      return 2.0 * g.size[0];
  }
}

}  // namespace

TravelWatch::TravelWatch(const Model& model, RunReport& report)
    : model_(model), trust_(report.trust), turning_(turningFrames(model)) {
  collectShapes();
}

void TravelWatch::collectShapes() {
  struct Sized {
    int system, frame;
    double size;
  };
  std::vector<Sized> shapes;
  for (std::size_t i = 0; i < model_.systems().size(); ++i)
    for (const PlacedShape& p : model_.description(static_cast<int>(i)).shapes)
      if (!p.shape->material().empty())
        shapes.push_back({static_cast<int>(i), p.frame, smallestSize(p.shape->geometry())});
  // Two points never touch. For all other shapes the smallest shape of another system decides.
  std::sort(shapes.begin(), shapes.end(),
            [](const Sized& a, const Sized& b) { return a.size < b.size; });
  const auto extended =
      std::find_if(shapes.begin(), shapes.end(), [](const Sized& s) { return s.size > 0.0; });
  const std::vector<std::pair<int, int>>& asked = model_.topology().requestedFrames();
  std::map<std::pair<int, int>, int> frames;
  for (std::size_t i = 0; i < asked.size(); ++i) frames.emplace(asked[i], static_cast<int>(i));
  for (const Sized& a : shapes) {
    const auto from = a.size > 0.0 ? shapes.begin() : extended;
    const auto partner = std::find_if(from, shapes.end(), [&](const Sized& b) {
      const bool many = model_.topology().system(b.system).blocks > 1;
      return b.system != a.system || (many && b.frame != a.frame);
    });
    const auto at = frames.find({a.system, a.frame});
    if (partner == shapes.end() || at == frames.end()) continue;
    const double size = a.size + partner->size;
    if (std::isfinite(size)) movers_.push_back({{at->second}, size});
  }
}

void TravelWatch::step(const StepView& view) {
  const Kinematics& k = view.system.slot(0).kinematics;
  const double dt = view.report.dt;
  const std::size_t frames = model_.topology().requestedFrames().size();
  for (std::size_t i = 0; i < frames; ++i) {
    const Frame& f = k.frame({static_cast<int>(i)});
    trust_.way = std::max(trust_.way, f.v_S_I.norm() * dt);
  }
  for (const FrameHandle f : turning_)
    trust_.turn = std::max(trust_.turn, k.frame(f).Omega_I.norm() * dt);
  for (const Mover& m : movers_)
    trust_.leap = std::max(trust_.leap, k.frame(m.frame).v_S_I.norm() * dt / m.size);
}

void TravelWatch::contacts(const StepView& view) {
  // The speed of systems without frames is that of their contacts.
  const double dt = view.report.dt;
  const ContactSet& c = view.system.slot(0).contacts;
  const std::vector<double>& gammaA = view.system.problem().gammaA;
  if (gammaA.size() != static_cast<std::size_t>(c.rows())) return;
  for (int i = 0; i < c.size(); ++i) {
    const auto row = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)]);
    if (-gammaA[row] * dt > trust_.way && c.law[static_cast<std::size_t>(i)]->unilateral())
      trust_.way = -gammaA[row] * dt;
  }
}

}  // namespace dynamy
