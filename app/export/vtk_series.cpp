#include "export/vtk_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/run_files/run_folder.hpp>

#include "export/scene_mesh.hpp"

namespace dynamy::app {
namespace {

namespace fs = std::filesystem;

/// A file of one piece of polygons, lines and points: the XML, and behind it the arrays that it names.
class Polydata {
 public:
  Polydata(std::size_t points, std::size_t verts, std::size_t lines, std::size_t polys, double t) {
    xml_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" "
        "Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">{}</DataArray>\n</FieldData>\n<Piece "
        "NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n",
        t, points, verts, lines, polys);
  }
  void begin(const char* group) { xml_ += fmt::format("<{}>\n", group); }
  void end(const char* group) { xml_ += fmt::format("</{}>\n", group); }
  /// An array of `Number`s, `components` of them a tuple.
  template <class Number>
  void array(const char* name, int components, const std::vector<Number>& values) {
    xml_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        typeOf(Number{}), name, components, data_.size());
    appendBytes(data_, static_cast<std::uint64_t>(values.size() * sizeof(Number)));
    for (const Number& x : values) appendBytes(data_, x);
  }
  void cells(const char* group, const std::vector<SceneMesh::Cell>& cells) {
    std::vector<std::int32_t> points, ends;
    for (const SceneMesh::Cell& cell : cells) {
      points.insert(points.end(), cell.begin(), cell.end());
      ends.push_back(static_cast<std::int32_t>(points.size()));
    }
    begin(group);
    array("connectivity", 1, points), array("offsets", 1, ends);
    end(group);
  }
  std::string text() const {
    return xml_ + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + data_ +
           "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  static const char* typeOf(float) { return "Float32"; }
  static const char* typeOf(std::int32_t) { return "Int32"; }
  static const char* typeOf(std::uint8_t) { return "UInt8"; }
  std::string xml_, data_;
};

std::vector<float> numbersOf(const std::vector<Eigen::Vector3d>& points) {
  std::vector<float> out;
  for (const Eigen::Vector3d& p : points)
    for (const double x : p) out.push_back(static_cast<float>(x));
  return out;
}

/// The mesh without the cells of bodies that take no part in frame f, whose quaternions are 0.
SceneMesh present(SceneMesh mesh, const Frames& frames, std::size_t f) {
  std::vector<bool> absent(frames.poses);
  for (std::size_t i = 0; i < frames.poses; ++i) {
    const float* pose = frames.pose.data() + (f * frames.poses + i) * Frames::kPoseNumbers;
    absent[i] = std::all_of(pose + 3, pose + 7, [](float x) { return x == 0.0F; });
  }
  if (std::find(absent.begin(), absent.end(), true) == absent.end()) return mesh;
  const auto keep = [&](std::vector<SceneMesh::Cell>& cells, std::vector<SceneMesh::Part>& parts) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool gone = std::any_of(cells[i].begin(), cells[i].end(), [&](std::int32_t point) {
        const int frame = mesh.frame[static_cast<std::size_t>(point)];
        return frame >= 0 && absent[static_cast<std::size_t>(frame)];
      });
      if (gone) continue;
      if (kept != i) cells[kept] = std::move(cells[i]), parts[kept] = parts[i];
      ++kept;
    }
    cells.resize(kept), parts.resize(kept);
  };
  keep(mesh.lines, mesh.lineParts), keep(mesh.polygons, mesh.polygonParts);
  return mesh;
}

std::string bodies(const SceneMesh& all, const Frames& frames, std::size_t f) {
  const SceneMesh mesh = present(all, frames, f);
  Polydata out(mesh.points.size(), 0, mesh.lines.size(), mesh.polygons.size(), frames.t[f]);
  std::vector<std::int32_t> shape, frame;
  std::vector<std::uint8_t> colour;
  for (const auto* parts : {&mesh.lineParts, &mesh.polygonParts})
    for (const SceneMesh::Part& p : *parts) {
      shape.push_back(p.shape), frame.push_back(p.frame);
      colour.insert(colour.end(), p.colour.begin(), p.colour.end());
    }
  out.begin("CellData");
  out.array("frame", 1, frame), out.array("shape", 1, shape), out.array("colour", 3, colour);
  out.end("CellData");
  out.begin("Points");
  out.array("Points", 3, numbersOf(placed(mesh, frames, f)));
  out.end("Points");
  out.cells("Lines", mesh.lines), out.cells("Polys", mesh.polygons);
  return out.text();
}

std::string contacts(const Frames& frames, std::size_t f) {
  const std::size_t first = frames.firstContact[f], n = frames.firstContact[f + 1] - first;
  std::vector<float> point, normal, force, limit, impulse;
  std::vector<std::int32_t> state;
  std::vector<SceneMesh::Cell> cells;
  for (std::size_t i = 0; i < n; ++i) {
    const float* c = frames.contact.data() + (first + i) * Frames::kContactNumbers;
    point.insert(point.end(), c, c + 3), normal.insert(normal.end(), c + 3, c + 6);
    force.insert(force.end(), c + 6, c + 9);
    const bool impact = static_cast<int>(c[9]) == static_cast<int>(ContactState::impact);
    for (int k = 6; k < 9; ++k) impulse.push_back(impact ? c[k] * frames.step[f] : 0.0F);
    state.push_back(static_cast<std::int32_t>(c[9])), limit.push_back(c[10]);
    cells.push_back({static_cast<std::int32_t>(i)});
  }
  Polydata out(n, n, 0, 0, frames.t[f]);
  out.begin("PointData");
  out.array("force", 3, force), out.array("impulse", 3, impulse);
  out.array("normal", 3, normal);
  out.array("state", 1, state), out.array("limit", 1, limit);
  out.end("PointData");
  out.begin("Points");
  out.array("Points", 3, point);
  out.end("Points");
  out.cells("Verts", cells);
  return out.text();
}

/// How far the bodies get from the origin [m].
double reachOf(const Frames& frames) {
  float out = 0.0F;
  for (std::size_t i = 0; i + Frames::kPoseNumbers <= frames.pose.size(); i += Frames::kPoseNumbers)
    for (std::size_t k = 0; k < 3; ++k) out = std::max(out, std::abs(frames.pose[i + k]));
  return out > 0.0F ? 1.5 * static_cast<double>(out) : 1.0;
}

}  // namespace

VtkResult writeVtkSeries(const VtkTask& task) {
  const RunFolder run = RunFolder::existing(task.run);
  const Frames frames = readFrames(run.frames());
  const SceneMesh mesh = sceneMesh(readJson(frames.scene, run.frames().string()), frames.poses,
                                   task.sides, reachOf(frames));
  VtkResult out{task.out.empty() ? run.path() / "vtk" : fs::path(task.out), frames.t.size()};
  fs::create_directories(out.folder);
  for (const char* what : {"bodies", "contacts"}) {
    std::string list =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (std::size_t f = 0; f < frames.t.size(); ++f) {
      const std::string name = fmt::format("{}_{:05}.vtp", what, f);
      writeWholeFile(out.folder / name,
                     *what == 'b' ? bodies(mesh, frames, f) : contacts(frames, f));
      list += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frames.t[f], name);
    }
    writeWholeFile(out.folder / fmt::format("{}.pvd", what), list + "</Collection>\n</VTKFile>\n");
  }
  return out;
}

}  // namespace dynamy::app
