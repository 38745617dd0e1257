#include <algorithm>
#include <cctype>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <system_error>

namespace dynamy {
namespace fs = std::filesystem;
namespace {

constexpr const char* kMarker = "dynamy-run";
constexpr int kVersion = 1;

/// True if the folder holds nothing but the lock of a run that was killed at its start.
bool isEmpty(const fs::path& path, std::error_code& error) {
  for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error))
    if (it->path().filename() != "run.lock") return false;
  return true;
}

void prepare(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error)) {
    throw FileError(path.string(), "is a file, a folder is needed for the results of a run");
  }
  fs::create_directories(path, error);
  if (error) throw WriteError(path.string(), "cannot create the folder: " + error.message());
  const bool empty = isEmpty(path, error);
  if (error) throw FileError(path.string(), "cannot look into the folder: " + error.message());
  if (!empty && !holdsRun(path)) {
    throw FileError(
        path.string(),
        "the folder is not empty and holds no run of dynamy (a run.json with \"format\": "
        "\"dynamy-run\"); nothing in it was touched: choose another --out or empty it");
  }
}

}  // namespace

bool holdsRun(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "run.json", error)) return false;
  std::string text = readWholeFile(folder / "run.json");
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text.find("\"format\":\"" + std::string(kMarker) + '"') != std::string::npos;
}

fs::path defaultRunFolder(const fs::path& model) { return fs::path("runs") / model.stem(); }

RunFolder::RunFolder(const fs::path& path) : path_(path) {
  prepare(path);
  lock_ = FolderLock(path);
  // first the new run.json, so that the folder carries the marker at every moment
  writeFacts([](JsonWriter& json) { json.member("state", "running"); });
  std::error_code error;
  for (const fs::path& file :
       {model(), signals(), path_ / "signals.h5", signalsPlot(), events(), ledger(), frames(),
        replay(), report(), path_ / "inputs.csv", checkpoint(), olderCheckpoint(), spareRoom()}) {
    fs::remove(file, error);
    if (error) throw WriteError(file.string(), "cannot replace: " + error.message());
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(problems(), error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("step_") && name.ends_with(".hdf5")) fs::remove(entry.path(), error);
  }
}

RunFolder RunFolder::existing(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error))
    throw FileError(
        path.string(),
        "there is no such folder; dynamy run MODEL makes the folder of a run, runs/MODEL");
  if (!fs::is_directory(path, error))
    throw FileError(path.string(), path.extension() == ".xml"
                                       ? "is a model; dynamy run " + path.string() +
                                             " makes the folder of its run, " +
                                             defaultRunFolder(path).string()
                                       : "is a file; name the folder of a run, such as runs/ball");
  if (!holdsRun(path))
    throw FileError(path.string(), "holds no run of dynamy (a run.json with \"format\": \"" +
                                       std::string(kMarker) +
                                       "\"); dynamy run MODEL makes one, runs/MODEL");
  RunFolder out;
  out.path_ = path;
  return out;
}

RunFolder RunFolder::resumed(const fs::path& path) {
  RunFolder out = existing(path);
  out.lock_ = FolderLock(path);
  return out;
}

namespace {

std::string factsText(const std::function<void(JsonWriter&)>& write) {
  std::string text;
  JsonWriter json(text, 2);
  json.beginObject().member("format", kMarker).member("version", kVersion);
  write(json);
  json.endObject();
  return text + '\n';
}

}  // namespace

void RunFolder::writeFacts(const std::function<void(JsonWriter&)>& write) const {
  writeWholeFile(facts(), factsText(write));
}

void RunFolder::writeLastFacts(const std::function<void(JsonWriter&)>& write,
                               const std::function<void(JsonWriter&)>& brief) const {
  const std::string text = factsText(write);
  for (const bool last : {false, true}) {
    try {
      writeWholeFile(facts(), text);
      return;
    } catch (const WriteError&) {
      std::error_code error;
      const bool another = fs::exists(checkpoint(), error);
      if (last || !another || !fs::remove(olderCheckpoint(), error)) break;
    }
  }
  overwriteFile(facts(), factsText(brief));
}

}  // namespace dynamy
