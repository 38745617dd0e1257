#include <dynamy/simulation/report/turning_frames.hpp>
#include <map>

namespace dynamy {
namespace {

/// True: a sphere about the origin of its frame.
bool isBall(const Shape& s) {
  return s.geometry().type == ShapeType::sphere && s.r_SB_K().isZero();
}

}  // namespace

std::vector<FrameHandle> turningFrames(const Model& model) {
  std::map<std::pair<int, int>, bool> balls;  // per frame with shapes: all are balls
  for (std::size_t i = 0; i < model.systems().size(); ++i)
    for (const PlacedShape& p : model.description(static_cast<int>(i)).shapes) {
      const auto at = balls.emplace(std::pair(static_cast<int>(i), p.frame), true).first;
      at->second = at->second && isBall(*p.shape);
    }
  const std::vector<std::pair<int, int>>& frames = model.topology().requestedFrames();
  std::vector<FrameHandle> out;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto at = balls.find(frames[i]);
    if (at == balls.end() || !at->second) out.push_back({static_cast<int>(i)});
  }
  return out;
}

}  // namespace dynamy
