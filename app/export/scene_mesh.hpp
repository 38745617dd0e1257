/// SceneMesh: the shapes of a scene as polygons and lines. Each point is fixed to a frame of the scene, so that
/// the mesh is made once and moves with the poses of the frames.
#pragma once
#include <array>
#include <cstdint>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <vector>

namespace dynamy::app {

/// Points, polygons and lines of all shapes; those of one shape follow each other.
struct SceneMesh {
  using Cell = std::vector<std::int32_t>;  ///< indices of points
  /// What is drawn alike: the number of the shape in the scene, its frame, and its colour.
  struct Part {
    std::int32_t shape = 0, frame = -1;  ///< −1: it stands still
    std::array<std::uint8_t, 3> colour{};
  };
  std::vector<Eigen::Vector3d> points;  ///< in the axes of their frames [m]
  std::vector<int> frame;               ///< of each point
  std::vector<Cell> lines, polygons;
  std::vector<Part> lineParts, polygonParts;  ///< of each line and polygon
};

/// The mesh of a scene, the JSON of frames.bin. Round shapes have `sides` sides; a half-space is a square whose
/// sides are 2 `reach` [m]. Throws std::runtime_error where a shape moves with a frame beyond `frames`.
SceneMesh sceneMesh(const JsonValue& scene, std::size_t frames, int sides, double reach);

/// Points of the mesh in frame f of the film [m].
std::vector<Eigen::Vector3d> placed(const SceneMesh& mesh, const Frames& frames, std::size_t f);

}  // namespace dynamy::app
