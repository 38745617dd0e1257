#pragma once
/// \file
/// HDF5 files of named vectors of integers, numbers and texts. No type of the HDF5 library appears
/// here.
///
/// Every failure is a ModelError with the file and the place inside of it:
///
///     problem.hdf5: error: /fclib_local/W/x: not there
///
/// Rejected: the C++ interface of HDF5, because it is a second library, and its errors do not name
/// the place either.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dynamy {

class Hdf5File {
 public:
  enum class Mode { read, create };
  /// \throws ModelError the file is missing, is no HDF5 file, or cannot be written
  Hdf5File(const std::filesystem::path& file, Mode mode);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// `place`: path inside of the file, e.g. "/fclib_local/W/x".
  bool has(const std::string& place) const;
  std::vector<int> integers(const std::string& place) const;
  /// `finite`: numbers that are not finite are refused.
  Eigen::VectorXd numbers(const std::string& place, bool finite = true) const;
  /// The first number of a dataset.
  int integer(const std::string& place) const;
  /// A scalar text of fixed or variable length; "" if it is not there.
  std::string text(const std::string& place) const;
  /// Texts of fixed length.
  std::vector<std::string> texts(const std::string& place) const;
  /// A text of fixed length that is an attribute of an object, "/" for the file; "" if it is not
  /// there.
  std::string attribute(const std::string& place, const std::string& name) const;

  // Missing groups of the path are created.
  void write(const std::string& place, const std::vector<int>& values);
  void write(const std::string& place, const Eigen::VectorXd& values);
  void write(const std::string& place, const std::string& text);
  /// Writes everything to disk. \throws ModelError the disk is full
  void flush();

  [[noreturn]] void fail(const std::string& place, const std::string& reason) const;

 private:
  std::int64_t dataset(const std::string& place) const;
  /// Refuses sizes of corrupt files that would need all memory. \throws ModelError more than the
  /// file can hold
  void expectRoom(const std::string& place, double bytes) const;
  /// Number of entries of a dataset. \throws ModelError more than the file can hold
  std::size_t count(std::int64_t dataset, const std::string& place) const;
  void expectKind(std::int64_t dataset, const std::string& place, bool integers) const;
  std::string path_;
  std::int64_t file_ = -1;
};

}  // namespace dynamy
