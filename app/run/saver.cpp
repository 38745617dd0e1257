#include "run/saver.hpp"

#include <dynamy/io/files/file_error.hpp>

#include "build_text.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

/// A run of at most this time [s] is not synchronised to the disk, because to repeat it takes no
/// longer than the synchronisation.
constexpr double kShort = 1.0;
/// Data that tables and frames collect before they are written [byte]. On a full disk these data
/// are stored in the checkpoint.
constexpr std::uint64_t kRows = std::uint64_t{1} << 19;

}  // namespace

Saver::Saver(const RunFolder& folder, const RunChoice& choice, const Model& model,
             RunRecording& recording)
    : folder_(folder), recording_(recording) {
  next_.program = buildText();
  next_.choice = choice, next_.modelText = model.file.text;
}

Saver::~Saver() { release(); }

void Saver::release() {
  std::error_code error;
  fs::remove(folder_.spareRoom(), error);
}

void Saver::save(const std::string& simulation, double t, bool lasting) {
  next_.simulation = simulation, next_.t = t, next_.files = recording_.archived();
  fault_.clear();
  // The first checkpoint need not survive a loss of power: a run that has just begun loses nothing.
  const bool safe = lasting && any_;
  try {
    if (safe) recording_.sync();
    writeCheckpoint(folder_, next_, safe);
    std::error_code error;
    const auto size = fs::file_size(folder_.checkpoint(), error);
    if (!any_ && !error) reserveRoom(folder_, 2 * size + kRows);
    any_ = true;
  } catch (const WriteError& e) {
    fault_ = std::string("no checkpoint could be written: ") + e.what();
  }
}

void Saver::saveLast(const Simulation& simulation) {
  save(simulation.checkpoint(), simulation.state().t, simulation.report().cost.wall > kShort);
  release();  // the last files of the run may need this room
}

}  // namespace dynamy::app
