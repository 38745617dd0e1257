#include <algorithm>
#include <cctype>
#include <dynamy/io/file_error.hpp>
#include <dynamy/io/output_file.hpp>
#include <dynamy/io/run_folder.hpp>
#include <system_error>

namespace dynamy {
namespace fs = std::filesystem;
namespace {

constexpr const char* kMarker = "dynamy-run";
constexpr int kVersion = 1;

void prepare(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error)) {
    throw FileError(path.string(), "is a file, a folder is needed for the results of a run");
  }
  fs::create_directories(path, error);
  if (error) throw FileError(path.string(), "cannot create the folder: " + error.message());
  const bool empty = fs::is_empty(path, error);
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

fs::path RunFolder::defaultPath(const fs::path& model) { return fs::path("runs") / model.stem(); }

RunFolder::RunFolder(const fs::path& path) : path_(path) {
  prepare(path);
  // first the new run.json, so that the folder is one of ours at every moment
  writeFacts([](JsonWriter& json) { json.member("state", "running"); });
  std::error_code error;
  for (const fs::path& file : {model(), signals(), signalsPlot(), events(), ledger(), frames(),
                               replay(), report(), checkpoint()}) {
    fs::remove(file, error);
    if (error) throw FileError(file.string(), "cannot replace: " + error.message());
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(problems(), error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("step_") && name.ends_with(".hdf5")) fs::remove(entry.path(), error);
  }
}

RunFolder RunFolder::existing(const fs::path& path) {
  if (!holdsRun(path))
    throw FileError(path.string(), "holds no run of dynamy (a run.json with \"format\": \"" +
                                       std::string(kMarker) + "\")");
  RunFolder out;
  out.path_ = path;
  return out;
}

void RunFolder::writeFacts(const std::function<void(JsonWriter&)>& write) const {
  std::string text;
  JsonWriter json(text, 2);
  json.beginObject().member("format", kMarker).member("version", kVersion);
  write(json);
  json.endObject();
  text += '\n';
  writeWholeFile(facts(), text);
}

}  // namespace dynamy
