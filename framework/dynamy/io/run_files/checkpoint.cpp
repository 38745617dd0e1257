#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <dynamy/core/error.hpp>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/checkpoint.hpp>
#include <system_error>

namespace dynamy {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kCheckpointMagic = "DYNCHECK";
constexpr std::uint32_t kCheckpointByteOrder = 0x01020304u;
constexpr std::size_t kHead = 40;  // magic, layout, byte order, bytes, hash, CRC, 0
constexpr std::size_t kHashAt = 24, kCheckpointCrcAt = 32;

/// Hash of the bytes. It works word by word, so that a checkpoint of many megabytes takes
/// milliseconds; each step is one to one, so that one changed word always changes the hash.
std::uint64_t hashOf(std::string_view bytes) {
  std::uint64_t h = bytes.size();
  const auto add = [&h](std::uint64_t word) {
    h = (h ^ word) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32u;
  };
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) add(readBytes<std::uint64_t>(&bytes[at]));
  for (; at < bytes.size(); ++at) add(static_cast<unsigned char>(bytes[at]));
  return h;
}

/// Why these bytes are no complete checkpoint; empty: they are one.
std::string fault(std::string_view bytes) {
  if (bytes.size() < kHead || bytes.substr(0, kCheckpointMagic.size()) != kCheckpointMagic)
    return "is no checkpoint of dynamY, or its begin is damaged";
  const auto layout = readBytes<std::uint32_t>(&bytes[8]);
  const std::string_view payload = bytes.substr(kHead);
  const auto length = readBytes<std::uint64_t>(&bytes[16]);
  const bool whole = length == payload.size();
  const auto crc = crc32(payload, crc32(bytes.substr(0, kCheckpointCrcAt)));
  const bool good = whole && crc == readBytes<std::uint32_t>(&bytes[kCheckpointCrcAt]) &&
                    hashOf(payload) == readBytes<std::uint64_t>(&bytes[kHashAt]) &&
                    readBytes<std::uint32_t>(&bytes[kCheckpointCrcAt + 4]) == 0 &&
                    readBytes<std::uint32_t>(&bytes[12]) == kCheckpointByteOrder;
  if (good && layout != kCheckpointLayout)
    return fmt::format(
        "has layout {}, this program reads layout {}: it goes on with the version "
        "of dynamY that began it",
        layout, kCheckpointLayout);
  if (payload.size() < length)
    return fmt::format("is cut off: {} of {} bytes are left", payload.size(), length);
  return good ? "" : "is damaged: its checksum is wrong";
}

/// The fault of the checkpoint `file` or of the recorded files that belong to it; empty: none.
std::string read(const RunFolder& folder, const fs::path& file, Checkpoint& out) {
  std::error_code error;
  if (!fs::exists(file, error)) return file.filename().string() + " is missing";
  try {
    out = readCheckpoint(readWholeFile(file), file.filename().string());
  } catch (const FileError& e) {  // "checkpoint: is damaged …" becomes a part of a sentence
    std::string why = e.what();
    const std::string name = file.filename().string() + ": ";
    return why.starts_with(name) ? why.replace(name.size() - 2, 1, "") : why;
  }
  for (const RecordedFile& f : out.files) {
    const fs::path name(f.name);
    if (name.has_parent_path() || name.filename() == "..")  // no file outside of the folder
      return file.filename().string() + " names a file outside of the folder, \"" + f.name + '"';
    if (std::string why = placeFault(folder.path() / name, f.place); !why.empty())
      return f.name + ' ' + why;
  }
  return {};
}

/// Writes a checkpoint into the space reserved for it, or into the space of the older one.
void writeWithoutRoom(const RunFolder& folder, const fs::path& file, const std::string& bytes) {
  std::error_code error;
  if (fs::file_size(folder.spareRoom(), error) >= bytes.size() && !error) {
    overwriteFile(folder.spareRoom(), bytes);
    fs::rename(folder.spareRoom(), file, error);
    if (!error) return;
  }
  fs::remove(folder.spareRoom(), error);
  if (fs::exists(folder.checkpoint(), error)) fs::remove(folder.olderCheckpoint(), error);
  writeWholeFile(file, bytes);
}

}  // namespace

void RunChoice::archive(Archive& a) {
  std::vector<std::string> names, values, asked;
  for (const auto& [name, value] : set) names.push_back(name), values.push_back(value);
  for (const std::string& library : libraries) asked.push_back(nameOfLibrary(library));
  a(model), a(names), a(values), a(until), a(step), a(tolerance), a(every), a(integrator),
      a(solver);
  a(asked), a(sources), a(loaded);
  if (!a.reading()) return;
  if (names.size() != values.size())
    throw ModelError("the checkpoint names parameters without a value");
  for (const double x : {until, step, tolerance, every})
    if (!(x >= 0.0) || !std::isfinite(x))
      throw ModelError("the checkpoint holds a step, a tolerance or a time that is none");
  libraries.clear();
  for (const std::string& name : asked) libraries.push_back(nameOfLibrary(name));
  set.clear();
  for (std::size_t i = 0; i < names.size(); ++i) set.emplace_back(names[i], values[i]);
}

void Checkpoint::archive(Archive& a) {
  a.section("dynamy run 2");  // the number counts changes of the layout
  a(program), a(t), a(choice), a(modelText), a(files), a(simulation);
}

std::string bytesOf(Checkpoint& checkpoint) {
  Archive a;
  checkpoint.archive(a);
  std::string out(kCheckpointMagic);
  appendBytes(out, kCheckpointLayout);
  appendBytes(out, kCheckpointByteOrder);
  appendBytes(out, static_cast<std::uint64_t>(a.bytes().size()));
  appendBytes(out, hashOf(a.bytes()));
  appendBytes(out, crc32(a.bytes(), crc32(out)));
  appendBytes(out, std::uint32_t{0});
  return out + a.bytes();
}

Checkpoint readCheckpoint(std::string_view bytes, const std::string& file) {
  if (const std::string why = fault(bytes); !why.empty()) throw FileError(file, why);
  Checkpoint out;
  try {
    Archive a{std::string(bytes.substr(kHead))};
    out.archive(a);
    if (!a.atEnd()) throw ModelError("there is more in it than a checkpoint holds");
  } catch (const ModelError& e) {
    throw FileError(file, e.diagnostics().front().text);
  }
  return out;
}

void reserveRoom(const RunFolder& folder, std::uint64_t bytes) {
  const int file = ::open(folder.spareRoom().c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) return;
  const bool reserved = ::fallocate(file, 0, 0, static_cast<off_t>(bytes)) == 0;
  ::close(file);
  std::error_code error;
  if (!reserved) fs::remove(folder.spareRoom(), error);
}

void writeCheckpoint(const RunFolder& folder, Checkpoint& checkpoint, bool lasting) {
  const std::string bytes = bytesOf(checkpoint);
  const fs::path last = folder.checkpoint(), older = folder.olderCheckpoint(),
                 next = folder.path() / "checkpoint.next";
  std::error_code error;
  try {
    writeWholeFile(next, bytes, lasting);
  } catch (const WriteError&) {
    writeWithoutRoom(folder, next, bytes);
  }
  // The last checkpoint first gets its second name, so that a checkpoint has the name `last` at
  // every moment.
  fs::remove(older, error);
  fs::create_hard_link(last, older, error);
  if (error && fs::exists(last)) fs::rename(last, older, error);  // file systems without hard links
  fs::rename(next, last, error);
  if (error) throw WriteError(last.string(), "cannot replace: " + error.message());
}

FoundCheckpoint findCheckpoint(const RunFolder& folder) {
  FoundCheckpoint out;
  const std::string last = read(folder, folder.checkpoint(), out.checkpoint);
  if (last.empty()) return out;
  std::error_code error;
  if (!fs::exists(folder.checkpoint(), error) && !fs::exists(folder.olderCheckpoint(), error))
    throw FileError(folder.path().string(),
                    "holds no checkpoint: the run was killed before it wrote the first one, or it "
                    "ran with --no-checkpoint or in Python, which writes none; run the model "
                    "again");
  out.checkpoint = {};
  const std::string older = read(folder, folder.olderCheckpoint(), out.checkpoint);
  if (!older.empty())
    throw FileError(folder.path().string(),
                    "cannot be resumed: " + last + "; " + older + "; run the model again");
  out.note = last;
  return out;
}

void keepOnly(const RunFolder& folder, const FoundCheckpoint& found) {
  if (found.note.empty()) return;
  std::error_code error;
  fs::rename(folder.olderCheckpoint(), folder.checkpoint(), error);
  if (error) throw WriteError(folder.checkpoint().string(), "cannot replace: " + error.message());
}

}  // namespace dynamy
