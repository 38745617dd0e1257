#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <dynamy/core/version.hpp>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <fstream>
#include <functional>
#include <system_error>

namespace dynamy {
namespace fs = std::filesystem;
namespace {

constexpr int kPackedVersion = 1;
constexpr const char* kPackedFormat = "dynamy-signals";
constexpr std::size_t kBlockBytes = std::size_t{1} << 23;  // of signals.csv, read at once
constexpr std::size_t kNumbersInMemory = 4'000'000;        // of all columns, between two chunks
constexpr std::size_t kFewestRows = 256, kMostRowsOfChunk = 8192;
constexpr unsigned kDeflateLevel = 4;
/// Most that deflate can shrink data by, and room for small files: a file that promises more numbers
/// is broken.
constexpr double kMostShrink = 1032.0, kSmallFile = 1e6;

/// Prevents the library from printing its error stack.
class QuietHdf5 {
 public:
  QuietHdf5() {
    H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// An identifier of the library, closed at the end; `fail` is called if it is invalid.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::function<void()>& fail)
      : id_(id), close_(close) {
    if (id_ < 0) fail();
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t operator*() const { return id_; }
  /// Closes it now; false: what was written is not on the disk.
  bool close() { return close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// What writing and reading share: the path, and what to do where the library refuses.
class PackedFile {
 public:
  PackedFile(const fs::path& path, bool create)
      : path_(path.string()),
        writes_(create),
        file_(create ? H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
                     : H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
              H5Fclose, failing(create ? "cannot be created" : "is no HDF5 file")) {}
  hid_t id() const { return *file_; }
  bool close() { return file_.close(); }
  [[noreturn]] void fail(const std::string& reason) const {
    if (writes_) throw WriteError(path_, reason);
    throw FileError(path_, reason);
  }
  std::function<void()> failing(const std::string& reason) const {
    return [this, reason] { fail(reason); };
  }
  void must(herr_t result, const std::string& what) const {
    if (result < 0) fail(what);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool writes_;
  Handle file_;
};

std::string placeOf(const std::string& signal) { return "/signals/" + signal; }

// --- writing

/// How datasets are made: without the time, so that the same run gives the same bytes.
class Untimed final : public Handle {
 public:
  explicit Untimed(const std::function<void()>& fail)
      : Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, fail) {
    if (H5Pset_obj_track_times(**this, false) < 0) fail();
  }
};

/// A text of fixed length as attribute of an object, or as a dataset of its own.
void writeText(const PackedFile& file, hid_t object, const char* name, const std::string& text,
               bool attribute) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, file.failing("cannot hold a text"));
  file.must(H5Tset_size(*type, std::max<std::size_t>(text.size(), 1)), "cannot hold a text");
  file.must(H5Tset_cset(*type, H5T_CSET_UTF8), "cannot hold a text");
  file.must(H5Tset_strpad(*type, H5T_STR_NULLPAD), "cannot hold a text");
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, file.failing("cannot hold a text"));
  const std::string whole = text.empty() ? std::string(1, '\0') : text;
  const auto failing = file.failing(fmt::format("cannot write {}", name));
  if (attribute) {
    const Handle made(H5Acreate2(object, name, *type, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                      failing);
    file.must(H5Awrite(*made, *type, whole.data()), fmt::format("cannot write {}", name));
    return;
  }
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, failing);
  H5Pset_create_intermediate_group(*links, 1);
  const Untimed how(failing);
  const Handle made(H5Dcreate2(object, name, *type, *space, *links, *how, H5P_DEFAULT), H5Dclose,
                    failing);
  file.must(H5Dwrite(*made, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, whole.data()),
            fmt::format("cannot write {}", name));
}

void writeNames(const PackedFile& file, std::span<const SignalName> signals) {
  std::size_t longest = 1;
  for (const SignalName& s : signals) longest = std::max(longest, s.name.size());
  std::string names(longest * signals.size(), '\0');
  for (std::size_t i = 0; i < signals.size(); ++i)
    std::memcpy(&names[i * longest], signals[i].name.data(), signals[i].name.size());
  const auto failing = file.failing("cannot write the names of the signals");
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, failing);
  H5Tset_size(*type, longest), H5Tset_cset(*type, H5T_CSET_UTF8);
  H5Tset_strpad(*type, H5T_STR_NULLPAD);
  const hsize_t count = signals.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, failing);
  const Untimed how(failing);
  const Handle made(H5Dcreate2(file.id(), "/names", *type, *space, H5P_DEFAULT, *how, H5P_DEFAULT),
                    H5Dclose, failing);
  if (count > 0 && H5Dwrite(*made, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, names.data()) < 0)
    failing();
}

/// An empty column that grows by chunks.
void makeColumn(const PackedFile& file, const std::string& place, const std::string& unit,
                hsize_t chunk) {
  const auto failing = file.failing("cannot hold " + place);
  const hsize_t none = 0, endless = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &endless), H5Sclose, failing);
  const Untimed how(failing);
  if (H5Pset_chunk(*how, 1, &chunk) < 0 || H5Pset_shuffle(*how) < 0 ||
      H5Pset_deflate(*how, kDeflateLevel) < 0 || H5Pset_fletcher32(*how) < 0)
    failing();
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, failing);
  H5Pset_create_intermediate_group(*links, 1);
  const Handle made(
      H5Dcreate2(file.id(), place.c_str(), H5T_IEEE_F64LE, *space, *links, *how, H5P_DEFAULT),
      H5Dclose, failing);
  writeText(file, *made, "unit", unit, true);
}

void append(const PackedFile& file, const std::string& place, hsize_t at, hsize_t count,
            const double* values) {
  const auto failing = file.failing("cannot write " + place);
  const Handle set(H5Dopen2(file.id(), place.c_str(), H5P_DEFAULT), H5Dclose, failing);
  const hsize_t whole = at + count;
  file.must(H5Dset_extent(*set, &whole), "cannot write " + place);
  const Handle to(H5Dget_space(*set), H5Sclose, failing);
  const Handle from(H5Screate_simple(1, &count, nullptr), H5Sclose, failing);
  H5Sselect_hyperslab(*to, H5S_SELECT_SET, &at, nullptr, &count, nullptr);
  file.must(H5Dwrite(*set, H5T_NATIVE_DOUBLE, *from, *to, H5P_DEFAULT, values),
            "cannot write " + place + ": the disk may be full");
}

/// Rows of signals.csv, block by block.
class TableBlocks {
 public:
  explicit TableBlocks(const fs::path& path) : path_(path.string()), in_(path, std::ios::binary) {
    if (!std::getline(in_, head_)) throw FileError(path_, "cannot be read");
    head_ += '\n';
  }
  /// The next rows; false: there are none.
  bool next(SignalTable& table) {
    std::string block(kBlockBytes, '\0');
    in_.read(block.data(), static_cast<std::streamsize>(block.size()));
    block.resize(static_cast<std::size_t>(in_.gcount()));
    rest_ += block;
    const std::size_t end = rest_.rfind('\n');
    if (end == std::string::npos) return !block.empty() && next(table);
    table = signalsIn(head_ + rest_.substr(0, end + 1), path_);
    rest_.erase(0, end + 1);
    return true;
  }

 private:
  std::string path_, head_, rest_;
  std::ifstream in_;
};

/// Writes the columns of `rows` from its beginning, in whole chunks unless it is the last part.
class ColumnWriter {
 public:
  ColumnWriter(const PackedFile& file, std::span<const SignalName> signals)
      : file_(file),
        signals_(signals),
        chunk_(std::clamp(kNumbersInMemory / (signals.size() + 1), kFewestRows, kMostRowsOfChunk)) {
    makeColumn(file, "/t", "s", chunk_);
    for (const SignalName& s : signals) makeColumn(file, placeOf(s.name), s.unit, chunk_);
    waiting_.columns.resize(signals.size());
  }
  void add(const SignalTable& rows) {
    const auto join = [](std::vector<double>& to, const std::vector<double>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    join(waiting_.t, rows.t);
    for (std::size_t k = 0; k < waiting_.columns.size(); ++k)
      join(waiting_.columns[k], rows.columns[k]);
    write(waiting_.t.size() / chunk_ * chunk_);
  }
  void finish() { write(waiting_.t.size()); }

 private:
  void write(std::size_t count) {
    if (count == 0) return;
    const auto part = [&](const std::string& place, std::vector<double>& column) {
      append(file_, place, rows_, count, column.data());
      column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(count));
    };
    part("/t", waiting_.t);
    for (std::size_t k = 0; k < waiting_.columns.size(); ++k)
      part(placeOf(signals_[k].name), waiting_.columns[k]);
    rows_ += count;
  }
  const PackedFile& file_;
  std::span<const SignalName> signals_;
  std::size_t chunk_;
  SignalTable waiting_;
  hsize_t rows_ = 0;
};

void writePacked(const RunFolder& folder, const fs::path& path, std::span<const SignalName> signals,
                 const std::string& title) {
  const QuietHdf5 quiet;
  PackedFile file(path, true);
  writeText(file, file.id(), "format", kPackedFormat, true);
  writeText(file, file.id(), "version", std::to_string(kPackedVersion), true);
  writeText(file, file.id(), "dynamy", versionString(), true);
  writeText(file, file.id(), "title", title, true);
  for (const fs::path& source : {folder.facts(), folder.model()})
    writeText(file, file.id(), ("/provenance/" + source.filename().string()).c_str(),
              readWholeFile(source), false);
  writeNames(file, signals);
  ColumnWriter columns(file, signals);
  TableBlocks blocks(folder.signals());
  for (SignalTable rows; blocks.next(rows);) {
    if (rows.columns.size() != signals.size())
      throw FileError(folder.signals().string(), "has other columns than the run records");
    columns.add(rows);
  }
  columns.finish();
  if (!file.close()) file.fail("cannot be written: the disk may be full");
}

// --- reading

std::string textAttribute(const PackedFile& file, hid_t object, const char* name) {
  const auto failing = file.failing(fmt::format("has no readable attribute {}", name));
  const Handle made(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, failing);
  const Handle type(H5Aget_type(*made), H5Tclose, failing);
  const Handle space(H5Aget_space(*made), H5Sclose, failing);
  if (H5Tget_class(*type) != H5T_STRING || H5Tis_variable_str(*type) != 0 ||
      H5Sget_simple_extent_npoints(*space) != 1)
    failing();
  std::string text(H5Tget_size(*type), '\0');
  if (H5Aread(*made, *type, text.data()) < 0) failing();
  return text.substr(0, text.find('\0'));
}

/// Number of entries of a dataset of one dimension.
hsize_t entries(const PackedFile& file, hid_t set, const std::string& place, std::size_t bytes) {
  const auto failing = file.failing(place + " is no column");
  const Handle space(H5Dget_space(set), H5Sclose, failing);
  hsize_t count = 0;
  if (H5Sget_simple_extent_ndims(*space) != 1 ||
      H5Sget_simple_extent_dims(*space, &count, nullptr) < 0)
    failing();
  const double most = kMostShrink * static_cast<double>(fs::file_size(file.path())) + kSmallFile;
  if (static_cast<double>(count) * static_cast<double>(bytes) > most)
    file.fail(place + " promises more numbers than the file can hold");
  return count;
}

std::vector<double> column(const PackedFile& file, const std::string& place) {
  const auto failing = file.failing(place + " is missing or damaged");
  const Handle set(H5Dopen2(file.id(), place.c_str(), H5P_DEFAULT), H5Dclose, failing);
  const Handle type(H5Dget_type(*set), H5Tclose, failing);
  if (H5Tget_class(*type) != H5T_FLOAT) failing();
  std::vector<double> out(entries(file, *set, place, sizeof(double)));
  if (!out.empty() &&
      H5Dread(*set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data()) < 0)
    failing();
  return out;
}

std::vector<std::string> packedNames(const PackedFile& file) {
  const auto failing = file.failing("/names is missing or damaged");
  const Handle set(H5Dopen2(file.id(), "/names", H5P_DEFAULT), H5Dclose, failing);
  const Handle type(H5Dget_type(*set), H5Tclose, failing);
  if (H5Tget_class(*type) != H5T_STRING || H5Tis_variable_str(*type) != 0) failing();
  const std::size_t length = H5Tget_size(*type);
  std::string all(entries(file, *set, "/names", length) * length, '\0');
  if (!all.empty() && H5Dread(*set, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0)
    failing();
  std::vector<std::string> out;
  for (std::size_t at = 0; at < all.size(); at += length) {
    const std::string name = all.substr(at, length);
    out.push_back(name.substr(0, name.find('\0')));
  }
  return out;
}

std::string unitOf(const PackedFile& file, const std::string& place) {
  const auto failing = file.failing(place + " is missing");
  const Handle set(H5Dopen2(file.id(), place.c_str(), H5P_DEFAULT), H5Dclose, failing);
  return textAttribute(file, *set, "unit");
}

}  // namespace

fs::path packedSignals(const RunFolder& folder) { return folder.path() / "signals.h5"; }

RecordedFile packSignals(const RunFolder& folder, std::span<const SignalName> signals,
                         const std::string& title) {
  fs::path part = packedSignals(folder);
  part += ".part";
  try {
    writePacked(folder, part, signals, title);
  } catch (...) {
    std::error_code none;
    fs::remove(part, none);
    throw;
  }
  RecordedFile out;
  out.name = packedSignals(folder).filename().string();
  std::ifstream in(part, std::ios::binary);
  for (std::string block(kBlockBytes, '\0'); in.good();) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    out.place.crc = crc32(std::string_view(block).substr(0, count), out.place.crc);
    out.place.bytes += count;
  }
  fs::rename(part, packedSignals(folder));
  fs::remove(folder.signals());
  return out;
}

SignalTable readPackedSignals(const fs::path& path) {
  const QuietHdf5 quiet;
  const PackedFile file(path, false);
  if (textAttribute(file, file.id(), "format") != kPackedFormat)
    file.fail("holds no signals of dynamy");
  if (textAttribute(file, file.id(), "version") != std::to_string(kPackedVersion))
    file.fail("has another version of the format than " + std::to_string(kPackedVersion));
  SignalTable out;
  out.t = column(file, "/t");
  for (const std::string& name : packedNames(file)) {
    out.signals.push_back({name, unitOf(file, placeOf(name))});
    out.columns.push_back(column(file, placeOf(name)));
    if (out.columns.back().size() != out.t.size())
      file.fail(placeOf(name) + " has another length than /t");
  }
  return out;
}

void unpackSignals(const RunFolder& folder) {
  std::error_code error;
  if (!fs::exists(packedSignals(folder), error) || fs::exists(folder.signals(), error)) return;
  const SignalTable table = readPackedSignals(packedSignals(folder));
  fs::path part = folder.signals();
  part += ".part";
  {
    SignalsFile csv(part, table.signals);
    std::vector<double> values(table.columns.size());
    for (std::size_t i = 0; i < table.t.size(); ++i) {
      for (std::size_t k = 0; k < values.size(); ++k) values[k] = table.columns[k][i];
      csv.row(table.t[i], values);
    }
    csv.flush();
  }
  fs::rename(part, folder.signals());
}

SignalTable signalsOf(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder / "signals.csv", error)) return readSignals(folder / "signals.csv");
  if (fs::exists(folder / "signals.h5", error)) return readPackedSignals(folder / "signals.h5");
  return {};
}

}  // namespace dynamy
