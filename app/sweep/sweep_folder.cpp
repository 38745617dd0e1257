#include "sweep/sweep_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <dynamy/core/hash.hpp>
#include <dynamy/core/version.hpp>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <set>
#include <utility>
#include <vector>

#include "numbers.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFormat = "dynamy-sweep";

void texts(JsonWriter& j, const char* name, const std::vector<std::string>& list) {
  j.key(name).beginArray();
  for (const std::string& text : list) j.value(text);
  j.endArray();
}

std::string factsText(const Sweep& s) {
  std::string out;
  JsonWriter j(out, 2);
  j.beginObject().member("format", kFormat).member("version", 1).member("dynamy", versionString());
  j.member("title", s.title).member("model", s.choice.model).member("fingerprint", s.fingerprint);
  j.member("until", s.choice.until).member("step", s.choice.step);
  j.member("tolerance", s.choice.tolerance);
  j.member("integrator", s.choice.integrator).member("solver", s.choice.solver);
  j.key("set").beginObject();
  for (const auto& [name, value] : s.choice.set) j.member(name, value);
  j.endObject();
  j.key("plugins").beginArray();
  for (const Fingerprint& m : s.choice.loaded)
    j.beginObject().member("name", m.name).member("fingerprint", m.fingerprint).endObject();
  j.endArray();
  texts(j, "measures", s.measures);
  j.member("keep", s.keep).key("columns").beginArray();
  for (const Column& c : s.columns)
    j.beginObject().member("name", c.name).member("unit", c.unit).endObject();
  j.endArray().member("runs", s.runs()).endObject();
  return out + '\n';
}

/// Describes the first member in which two texts of sweep.json differ.
std::string difference(const std::string& before, const std::string& now) {
  const JsonValue a = readJson(before, "sweep.json"), b = readJson(now, "sweep.json");
  const auto text = [](const JsonValue& v) {
    return v.type == JsonValue::Type::text ? v.text : fmt::format("{:.12g}", v.value);
  };
  for (std::size_t i = 0; i < b.names.size(); ++i) {
    const JsonValue &x = a[b.names[i]], &y = b.items[i];
    std::string listed[2];
    for (const JsonValue* v : {&x, &y})
      for (std::size_t k = 0; k < v->items.size(); ++k)
        listed[v == &y] += (k < v->names.size() ? v->names[k] + '=' : std::string()) +
                           text(v->items[k]["name"] ? v->items[k]["name"] : v->items[k]) + ' ';
    if (x.flag != y.flag) return '"' + b.names[i] + "\" differs";
    if (text(x) != text(y))
      return b.names[i] == "fingerprint"
                 ? "the model has changed since it began"
                 : '"' + b.names[i] + "\" was " + text(x) + ", is " + text(y);
    if (listed[0] != listed[1])
      return '"' + b.names[i] + "\" was [" + listed[0] + "], is [" + listed[1] + ']';
  }
  return "sweep.json differs";
}

std::vector<std::string> textsOf(const JsonValue& array) {
  std::vector<std::string> out;
  for (const JsonValue& v : array.items) out.push_back(v.text);
  return out;
}

bool isSweep(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "sweep.json", error)) return false;
  return readWholeFile(folder / "sweep.json").find(kFormat) != std::string::npos;
}

/// True: the folder is empty, or a sweep was killed in it while writing its first file.
bool isFree(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().filename() != "sweep.json.part") return false;
  return fs::is_directory(folder, error);
}

FileError failed(const fs::path& path, const char* what) {
  return {path.string(), std::string(what) + ": " + std::strerror(errno)};
}

double tolerance(std::string text) {
  if (const std::string fault = positiveNumber()(text); !fault.empty())
    throw CLI::ValidationError("--tolerance", fault);
  return std::stod(text);
}

}  // namespace

void choose(RunChoice& choice, const std::string& name, const std::string& value) {
  if (name == "--step")
    choice.step = seconds(value, name);
  else if (name == "--tolerance")
    choice.tolerance = tolerance(value);
  else if (name == "--until")
    choice.until = seconds(value, name);
  else if (name == "--integrator")
    choice.integrator = value;
  else if (name == "--solver")
    choice.solver = value;
  else
    choice.set.emplace_back(name, value);
}

RunChoice Sweep::choiceOf(std::size_t id) const {
  RunChoice out = choice;
  for (std::size_t k = 0; k < plan.names.size(); ++k)
    choose(out, plan.names[k], plan.rows.at(id - 1).at(k));
  return out;
}

Claim::Claim(Claim&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
Claim::~Claim() {
  if (file_ >= 0) ::close(file_);
}

SweepFolder::SweepFolder(const fs::path& path, const Sweep& sweep) : path_(path) {
  std::error_code error;
  const std::string facts = factsText(sweep), manifest = manifestText(sweep.plan);
  if (isSweep(path)) {
    const std::string before = readWholeFile(this->facts());
    const bool begun = fs::exists(this->manifest(), error);
    std::string what;
    if (begun && before != facts)
      what = difference(before, facts);
    else if (begun && readWholeFile(this->manifest()) != manifest)
      what = "other values are asked for";
    if (!what.empty())
      throw FileError(path.string(), "holds another sweep: " + what +
                                         "; choose another --out, or --restart to throw its "
                                         "results away");
    fs::create_directory(path / "results", error);
    if (begun) return;
  } else if (fs::exists(path, error) && !isFree(path)) {
    throw FileError(path.string(),
                    "is not empty and holds no sweep; nothing in it was touched: choose another "
                    "--out");
  }
  // sweep.json comes first: it marks the folder as that of a sweep, even if the process is killed
  // later.
  fs::create_directories(path, error);
  if (error) throw FileError(path.string(), "cannot create the folder: " + error.message());
  writeWholeFile(this->facts(), facts);
  fs::create_directory(path / "results", error);
  writeWholeFile(this->manifest(), manifest);
}

SweepFolder::SweepFolder(const fs::path& path) : path_(path) {
  if (!isSweep(path) || !fs::exists(manifest()))
    throw FileError(path.string(), "holds no sweep (a sweep.json and a manifest.csv)");
}

Sweep SweepFolder::read() const {
  const JsonValue f = readJson(readWholeFile(facts()), facts().string());
  Sweep s;
  s.title = f["title"].text, s.fingerprint = f["fingerprint"].text, s.keep = f["keep"].flag;
  s.choice.model = f["model"].text;
  s.choice.until = f["until"].value, s.choice.step = f["step"].value;
  s.choice.tolerance = f["tolerance"].value;  // 0 in those of earlier programs
  s.choice.integrator = f["integrator"].text, s.choice.solver = f["solver"].text;
  for (std::size_t i = 0; i < f["set"].names.size(); ++i)
    s.choice.set.emplace_back(f["set"].names[i], f["set"].items[i].text);
  for (const JsonValue& p : f["plugins"].items)
    s.choice.loaded.push_back({p["name"].text, p["fingerprint"].text});
  s.measures = textsOf(f["measures"]);
  for (const JsonValue& c : f["columns"].items)
    s.columns.push_back({c["name"].text, c["unit"].text});
  s.plan = readTable(manifest().string());
  return s;
}

void SweepFolder::clear(const fs::path& path) {
  if (!isSweep(path)) return;
  const auto remove = [](const fs::path& old) {
    std::error_code error;
    fs::remove_all(old, error);
    if (error) throw FileError(old.string(), "cannot remove: " + error.message());
  };
  // Runs and their results are numbered; what has another name there is not of the sweep.
  for (const char* name : {"results", "runs"}) {
    std::error_code error;
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(path / name, error))
      if (const std::string stem = entry.path().stem().string();
          stem.find_first_not_of("0123456789") == std::string::npos)
        old.push_back(entry.path());
    for (const fs::path& entry : old) remove(entry);
    fs::remove(path / name, error);  // if it is empty
  }
  // sweep.json stays: without a manifest it says that a sweep may begin in this folder.
  for (const char* name : {"manifest.csv", "results.csv", "sweep.html", "parallel.sh", "slurm.sh"})
    remove(path / name);
}

fs::path SweepFolder::result(std::size_t id) const {
  return path_ / "results" / (std::to_string(id) + ".csv");
}

fs::path SweepFolder::run(std::size_t id) const { return path_ / "runs" / std::to_string(id); }

std::optional<Claim> SweepFolder::claim(std::size_t id) const {
  if (has(id)) return std::nullopt;
  const fs::path part = fs::path(result(id)).replace_extension(".part");
  Claim claim(::open(part.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (claim.file_ < 0) throw failed(part, "cannot write");
  if (::flock(claim.file_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return std::nullopt;
    throw failed(part, "cannot lock");
  }
  // Another process may have finished this run between the first test and the lock.
  if (has(id)) {
    std::error_code none;
    fs::remove(part, none);
    return std::nullopt;
  }
  return claim;
}

void SweepFolder::finish(std::size_t id, const Claim& claim, const std::string& line) const {
  const fs::path part = fs::path(result(id)).replace_extension(".part");
  const auto size = static_cast<ssize_t>(line.size());
  if (::ftruncate(claim.file_, 0) != 0 || ::write(claim.file_, line.data(), line.size()) != size ||
      ::fsync(claim.file_) != 0 || std::rename(part.c_str(), result(id).c_str()) != 0)
    throw failed(result(id), "cannot write");
}

std::string fingerprintOf(const std::vector<fs::path>& files) {
  Hash hash;
  std::set<fs::path> seen;
  for (const fs::path& file : files) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || !seen.insert(fs::canonical(file)).second) continue;
    for (const char c : readWholeFile(file)) hash.add(std::uint64_t{static_cast<unsigned char>(c)});
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace dynamy::app
