#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <dynamy/core/error.hpp>
#include <dynamy/core/version.hpp>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/hdf5/hdf5_file.hpp>
#include <dynamy/io/hdf5/hdf5_handle.hpp>
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

/// The file that is written; failures are WriteErrors with its path.
class PackedFile {
 public:
  explicit PackedFile(const fs::path& path)
      : path_(path.string()),
        file_(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
              failing("cannot be created")) {}
  hid_t id() const { return *file_; }
  bool close() { return file_.close(); }
  [[noreturn]] void fail(const std::string& reason) const { throw WriteError(path_, reason); }
  std::function<void()> failing(const std::string& reason) const {
    return [this, reason] { fail(reason); };
  }
  void must(herr_t result, const std::string& what) const {
    if (result < 0) fail(what);
  }

 private:
  std::string path_;
  Hdf5Handle file_;
};

std::string placeOf(const std::string& signal) { return "/signals/" + signal; }

/// How datasets are made: without the time, so that the same run gives the same bytes.
class Untimed final : public Hdf5Handle {
 public:
  explicit Untimed(const std::function<void()>& fail)
      : Hdf5Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, fail) {
    if (H5Pset_obj_track_times(**this, false) < 0) fail();
  }
};

/// A text of fixed length as attribute of an object, or as a dataset of its own.
void writeText(const PackedFile& file, hid_t object, const char* name, const std::string& text,
               bool attribute) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, file.failing("cannot hold a text"));
  file.must(H5Tset_size(*type, std::max<std::size_t>(text.size(), 1)), "cannot hold a text");
  file.must(H5Tset_cset(*type, H5T_CSET_UTF8), "cannot hold a text");
  file.must(H5Tset_strpad(*type, H5T_STR_NULLPAD), "cannot hold a text");
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, file.failing("cannot hold a text"));
  const std::string whole = text.empty() ? std::string(1, '\0') : text;
  const auto failing = file.failing(fmt::format("cannot write {}", name));
  if (attribute) {
    const Hdf5Handle made(H5Acreate2(object, name, *type, *space, H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose, failing);
    file.must(H5Awrite(*made, *type, whole.data()), fmt::format("cannot write {}", name));
    return;
  }
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, failing);
  H5Pset_create_intermediate_group(*links, 1);
  const Untimed how(failing);
  const Hdf5Handle made(H5Dcreate2(object, name, *type, *space, *links, *how, H5P_DEFAULT),
                        H5Dclose, failing);
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
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, failing);
  H5Tset_size(*type, longest), H5Tset_cset(*type, H5T_CSET_UTF8);
  H5Tset_strpad(*type, H5T_STR_NULLPAD);
  const hsize_t count = signals.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, failing);
  const Untimed how(failing);
  const Hdf5Handle made(
      H5Dcreate2(file.id(), "/names", *type, *space, H5P_DEFAULT, *how, H5P_DEFAULT), H5Dclose,
      failing);
  if (count > 0 && H5Dwrite(*made, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, names.data()) < 0)
    failing();
}

/// An empty column that grows by chunks.
void makeColumn(const PackedFile& file, const std::string& place, const std::string& unit,
                hsize_t chunk) {
  const auto failing = file.failing("cannot hold " + place);
  const hsize_t none = 0, endless = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &none, &endless), H5Sclose, failing);
  const Untimed how(failing);
  if (H5Pset_chunk(*how, 1, &chunk) < 0 || H5Pset_shuffle(*how) < 0 ||
      H5Pset_deflate(*how, kDeflateLevel) < 0 || H5Pset_fletcher32(*how) < 0)
    failing();
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, failing);
  H5Pset_create_intermediate_group(*links, 1);
  const Hdf5Handle made(
      H5Dcreate2(file.id(), place.c_str(), H5T_IEEE_F64LE, *space, *links, *how, H5P_DEFAULT),
      H5Dclose, failing);
  writeText(file, *made, "unit", unit, true);
}

void append(const PackedFile& file, const std::string& place, hsize_t at, hsize_t count,
            const double* values) {
  const auto failing = file.failing("cannot write " + place);
  const Hdf5Handle set(H5Dopen2(file.id(), place.c_str(), H5P_DEFAULT), H5Dclose, failing);
  const hsize_t whole = at + count;
  file.must(H5Dset_extent(*set, &whole), "cannot write " + place);
  const Hdf5Handle to(H5Dget_space(*set), H5Sclose, failing);
  const Hdf5Handle from(H5Screate_simple(1, &count, nullptr), H5Sclose, failing);
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
  PackedFile file(path);
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
  if (!in.eof()) throw WriteError(part.string(), "cannot be read back");
  std::error_code error;
  fs::rename(part, packedSignals(folder), error);
  if (!error) fs::remove(folder.signals(), error);
  if (error) throw WriteError(packedSignals(folder).string(), error.message());
  return out;
}

SignalTable readPackedSignals(const fs::path& path) {
  try {
    const Hdf5File file(path, Hdf5File::Mode::read);
    if (file.attribute("/", "format") != kPackedFormat) file.fail("", "holds no signals of dynamy");
    if (file.attribute("/", "version") != std::to_string(kPackedVersion))
      file.fail("", "has another version of the format than " + std::to_string(kPackedVersion));
    const auto column = [&](const std::string& place) {
      const Eigen::VectorXd numbers = file.numbers(place, false);
      return std::vector<double>(numbers.begin(), numbers.end());
    };
    SignalTable out;
    out.t = column("/t");
    for (const std::string& name : file.texts("/names")) {
      const std::string place = placeOf(name);
      out.columns.push_back(column(place));
      out.signals.push_back({name, file.attribute(place, "unit")});
      if (out.columns.back().size() != out.t.size()) file.fail(place, "has another length than /t");
    }
    return out;
  } catch (const ModelError& e) {
    throw FileError(path.string(), e.diagnostics().front().text);
  }
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
