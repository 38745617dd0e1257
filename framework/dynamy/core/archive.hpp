/// Archive: numbers to bytes and back, for checkpoints. One function `archive(Archive&)` of a class
/// serves both directions, so that reading cannot get out of step with writing.
///
/// Doubles are stored bit by bit as little-endian words of 8 bytes. Rejected: text, which is either
/// not exact or slow, and pairs of save/load functions, which drift apart.
#pragma once
#include <bit>
#include <cstdint>
#include <dynamy/core/types.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace dynamy {

class Archive {
 public:
  /// An archive to write to.
  Archive() = default;
  /// An archive that reads from `bytes`.
  explicit Archive(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  bool reading() const { return reading_; }
  /// True: all bytes have been read.
  bool atEnd() const { return at_ == bytes_.size(); }
  const std::string& bytes() const { return bytes_; }

  /// A number, flag or enumerator. Throws ModelError when the bytes are used up.
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void operator()(T& x) {
    if constexpr (std::is_floating_point_v<T>) {
      std::uint64_t bits = std::bit_cast<std::uint64_t>(static_cast<double>(x));
      word(bits);
      if (reading_) x = static_cast<T>(std::bit_cast<double>(bits));
    } else {
      auto bits = static_cast<std::uint64_t>(x);
      word(bits);
      if (reading_) x = static_cast<T>(bits);
    }
  }
  void operator()(std::string& text);
  void operator()(Eigen::VectorXd& v);
  void operator()(ContactKey& key) { word(key.value); }
  /// A vector of anything that can be archived.
  template <class T>
  void operator()(std::vector<T>& v) {
    std::uint64_t n = v.size();
    word(n);
    if (reading_) v.resize(checkedSize(n));
    for (T& x : v) (*this)(x);
  }
  /// Anything with `archive(Archive&)`.
  template <class T>
  requires requires(T& x, Archive& a) { x.archive(a); }
  void operator()(T& x) { x.archive(*this); }
  /// A name between two parts of the archive. Reading a different name is an error that names both.
  void section(const char* name);

 private:
  void word(std::uint64_t& bits);
  std::size_t checkedSize(std::uint64_t n) const;
  std::string bytes_;
  std::size_t at_ = 0;
  bool reading_ = false;
};

}  // namespace dynamy
