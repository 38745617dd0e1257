#pragma once
/// \file
/// What every use of the HDF5 library needs: identifiers that are closed, and silence.

#include <hdf5.h>

#include <utility>

namespace dynamy {

/// Prevents the HDF5 library from printing its error stack while an object of this class exists.
class QuietHdf5 {
 public:
  QuietHdf5() {
    // Objects of a corrupt file that stay open in the library would cause the message "infinite loop
    // closing library" at the end of the program. Files are closed by their owners, so that the exit
    // handler is not needed.
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

/// An identifier of the library, closed at the end.
class Hdf5Handle {
 public:
  /// `id`: may be invalid, < 0.
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  /// As above; `fail` is called if the identifier is invalid.
  template <class Fail>
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const Fail& fail) : Hdf5Handle(id, close) {
    if (id_ < 0) fail();
  }
  ~Hdf5Handle() { close(); }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  hid_t operator*() const { return id_; }
  /// Closes it now; false: what was written is not on the disk.
  bool close() {
    const hid_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

}  // namespace dynamy
