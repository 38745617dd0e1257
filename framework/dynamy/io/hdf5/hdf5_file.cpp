#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <dynamy/core/error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/hdf5/hdf5_file.hpp>
#include <dynamy/io/hdf5/hdf5_handle.hpp>
#include <dynamy/io/hdf5/hdf5_heaps.hpp>

namespace dynamy {
namespace {

hssize_t points(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  return H5Sget_simple_extent_npoints(*space);
}

}  // namespace

Hdf5File::Hdf5File(const std::filesystem::path& file, Mode mode) : path_(file.string()) {
  const QuietHdf5 quiet;
  if (mode == Mode::read) {
    if (!std::filesystem::exists(file)) fail("", "no such file");
    if (std::filesystem::is_regular_file(file) && !freeBlocksEnd(readWholeFile(file)))
      fail("", "is corrupt: a list of free blocks in it has no end");
    file_ = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file_ < 0) fail("", "not an HDF5 file");
  } else {
    file_ = H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    if (file_ < 0) fail("", "cannot be written");
  }
}

Hdf5File::~Hdf5File() {
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5File::fail(const std::string& place, const std::string& reason) const {
  Diagnostic d;
  d.place.file = path_;
  d.text = place.empty() ? reason : place + ": " + reason;
  throw ModelError(d);
}

bool Hdf5File::has(const std::string& place) const {
  const QuietHdf5 quiet;
  for (std::size_t end = place.find('/', 1);; end = place.find('/', end + 1)) {
    if (H5Lexists(file_, place.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::int64_t Hdf5File::dataset(const std::string& place) const {
  if (!has(place)) fail(place, "not there");
  const hid_t id = H5Dopen2(file_, place.c_str(), H5P_DEFAULT);
  if (id < 0) fail(place, "not a dataset");
  return id;
}

void Hdf5File::expectRoom(const std::string& place, double bytes) const {
  // Compression reduces data by a factor of at most 1032.
  constexpr double kSmallest = 1100.0;
  constexpr double kAlways = 64e6;  // a chunk may be larger than its content
  std::error_code ignored;
  const auto size = static_cast<double>(std::filesystem::file_size(path_, ignored));
  if (ignored || bytes > std::max(kAlways, kSmallest * size))
    fail(place, fmt::format("needs {:.2g} bytes, more than the file can hold", bytes));
}

std::size_t Hdf5File::count(std::int64_t dataset, const std::string& place) const {
  const hssize_t n = points(dataset);
  if (n < 0) fail(place, "has no size");
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  expectRoom(place, static_cast<double>(n) * static_cast<double>(H5Tget_size(*type)));
  // The library allocates a whole chunk, however little of it is used.
  const Hdf5Handle layout(H5Dget_create_plist(dataset), H5Pclose);
  std::array<hsize_t, H5S_MAX_RANK> edges{};
  const int rank = H5Pget_layout(*layout) == H5D_CHUNKED
                       ? H5Pget_chunk(*layout, static_cast<int>(edges.size()), edges.data())
                       : 0;
  double chunk = static_cast<double>(H5Tget_size(*type));
  for (int k = 0; k < rank; ++k) chunk *= static_cast<double>(edges[static_cast<std::size_t>(k)]);
  expectRoom(place, chunk);
  return static_cast<std::size_t>(n);
}

void Hdf5File::expectKind(std::int64_t dataset, const std::string& place, bool integers) const {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const H5T_class_t kind = H5Tget_class(*type);
  if (kind != H5T_INTEGER && (kind != H5T_FLOAT || integers))
    fail(place, integers ? "holds no integers" : "holds no numbers");
  // The library allocates some thousand numbers at once, with the width given in the file.
  constexpr std::size_t kWidest = 16;
  const std::size_t width = H5Tget_size(*type);
  if (width > kWidest)
    fail(place, fmt::format("holds numbers of {} bytes; at most {} are read", width, kWidest));
}

std::vector<int> Hdf5File::integers(const std::string& place) const {
  const QuietHdf5 quiet;
  const Hdf5Handle id(dataset(place), H5Dclose);
  expectKind(*id, place, true);
  std::vector<int> out(count(*id, place));
  if (!out.empty() && H5Dread(*id, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data()) < 0)
    fail(place, "cannot be read as integers");
  return out;
}

Eigen::VectorXd Hdf5File::numbers(const std::string& place, bool finite) const {
  const QuietHdf5 quiet;
  const Hdf5Handle id(dataset(place), H5Dclose);
  expectKind(*id, place, false);
  Eigen::VectorXd out(static_cast<Eigen::Index>(count(*id, place)));
  if (out.size() > 0 &&
      H5Dread(*id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data()) < 0)
    fail(place, "cannot be read as numbers");
  if (finite && !out.allFinite()) fail(place, "holds a number that is not finite");
  return out;
}

int Hdf5File::integer(const std::string& place) const {
  const std::vector<int> all = integers(place);
  if (all.empty()) fail(place, "holds no number");
  return all.front();
}

std::string Hdf5File::text(const std::string& place) const {
  const QuietHdf5 quiet;
  if (!has(place)) return {};
  const Hdf5Handle id(dataset(place), H5Dclose), type(H5Dget_type(*id), H5Tclose);
  if (H5Tget_class(*type) != H5T_STRING || points(*id) != 1) return {};
  if (H5Tis_variable_str(*type) > 0) {
    const Hdf5Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(*memory, H5T_VARIABLE);
    H5Tset_cset(*memory, H5Tget_cset(*type));
    char* value = nullptr;
    if (H5Dread(*id, *memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value) < 0 || !value) return {};
    std::string out(value);
    H5free_memory(value);
    return out;
  }
  count(*id, place);
  std::string out(H5Tget_size(*type), '\0');
  if (H5Dread(*id, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data()) < 0) return {};
  return out.substr(0, out.find('\0'));
}

std::string Hdf5File::attribute(const std::string& place, const std::string& name) const {
  const QuietHdf5 quiet;
  const Hdf5Handle made(
      H5Aopen_by_name(file_, place.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (*made < 0) return {};
  const Hdf5Handle type(H5Aget_type(*made), H5Tclose), space(H5Aget_space(*made), H5Sclose);
  if (H5Tget_class(*type) != H5T_STRING || H5Tis_variable_str(*type) != 0 ||
      H5Sget_simple_extent_npoints(*space) != 1)
    return {};
  expectRoom(place, static_cast<double>(H5Tget_size(*type)));
  std::string out(H5Tget_size(*type), '\0');
  if (H5Aread(*made, *type, out.data()) < 0) return {};
  return out.substr(0, out.find('\0'));
}

std::vector<std::string> Hdf5File::texts(const std::string& place) const {
  const QuietHdf5 quiet;
  const Hdf5Handle id(dataset(place), H5Dclose), type(H5Dget_type(*id), H5Tclose);
  if (H5Tget_class(*type) != H5T_STRING || H5Tis_variable_str(*type) != 0)
    fail(place, "holds no texts of fixed length");
  const std::size_t length = H5Tget_size(*type);
  std::string all(count(*id, place) * length, '\0');
  if (!all.empty() && H5Dread(*id, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0)
    fail(place, "cannot be read as texts");
  std::vector<std::string> out;
  for (std::size_t at = 0; at < all.size(); at += length)
    out.push_back(all.substr(at, std::min(length, all.find('\0', at) - at)));
  return out;
}

namespace {

hid_t createDataset(hid_t file, const std::string& place, hid_t type, hid_t space) {
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(*links, 1);
  return H5Dcreate2(file, place.c_str(), type, space, *links, H5P_DEFAULT, H5P_DEFAULT);
}

bool writeDataset(hid_t file, const std::string& place, hid_t stored, hid_t memory, hsize_t n,
                  const void* values) {
  const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  const Hdf5Handle id(createDataset(file, place, stored, *space), H5Dclose);
  return *id >= 0 && (n == 0 || H5Dwrite(*id, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
}

}  // namespace

void Hdf5File::write(const std::string& place, const std::vector<int>& values) {
  const QuietHdf5 quiet;
  if (!writeDataset(file_, place, H5T_STD_I32LE, H5T_NATIVE_INT, values.size(), values.data()))
    fail(place, "cannot be written");
}

void Hdf5File::write(const std::string& place, const Eigen::VectorXd& values) {
  const QuietHdf5 quiet;
  if (!writeDataset(file_, place, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
                    static_cast<hsize_t>(values.size()), values.data()))
    fail(place, "cannot be written");
}

void Hdf5File::write(const std::string& place, const std::string& text) {
  const QuietHdf5 quiet;
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(*type, text.size() + 1);
  H5Tset_cset(*type, H5T_CSET_UTF8);
  const Hdf5Handle id(createDataset(file_, place, *type, *space), H5Dclose);
  if (*id < 0 || H5Dwrite(*id, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) < 0)
    fail(place, "cannot be written");
}

void Hdf5File::flush() {
  const QuietHdf5 quiet;
  if (H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0) fail("", "cannot be written to the end");
}

}  // namespace dynamy
