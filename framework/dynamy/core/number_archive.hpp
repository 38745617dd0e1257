/// NumberArchive: values to the numbers of State::scheme and back, for schemes that carry data from
/// step to step. As with Archive, one function `archive(NumberArchive&)` of a class serves both
/// directions.
///
/// Steps do not throw. Reading therefore notes numbers that cannot have been written, such as 1.5
/// for an index, and good() is false from then on. Counts and keys are whole numbers below 2⁵³,
/// which a double holds exactly.
#pragma once
#include <array>
#include <dynamy/core/types.hpp>
#include <limits>
#include <type_traits>
#include <vector>

namespace dynamy {

class NumberArchive {
 public:
  /// An archive to write to.
  NumberArchive() = default;
  /// An archive that reads `from`, borrowed.
  explicit NumberArchive(const Eigen::VectorXd& from) : from_(&from) {}

  bool reading() const { return from_ != nullptr; }
  /// Reading: all numbers so far can have been written, and none was missing.
  bool good() const { return good_; }
  /// Reading: no number is left.
  bool atEnd() const { return !reading() || at_ == from_->size(); }
  /// Writing: forgets all numbers, and keeps the memory.
  void clear() { numbers_.clear(); }
  /// Writing: copies the numbers to `out`.
  void copyTo(Eigen::VectorXd& out) const {
    out = Eigen::Map<const Eigen::VectorXd>(numbers_.data(),
                                            static_cast<Eigen::Index>(numbers_.size()));
  }

  void operator()(double& x);
  /// A whole number or flag. Reading accepts only values of its type.
  template <class T>
  requires(std::is_integral_v<T>) void operator()(T& x) {
    constexpr bool flag = std::is_same_v<T, bool>;
    constexpr double most = flag ? 1.0 : static_cast<double>(std::numeric_limits<T>::max());
    constexpr double least = flag ? 0.0 : static_cast<double>(std::numeric_limits<T>::min());
    auto number = static_cast<double>(x);
    whole(number, least, most);
    if (reading()) x = static_cast<T>(number);
  }
  /// An enumerator, one of the first `count` of its type.
  template <class T>
  requires(std::is_enum_v<T>) void choice(T& x, int count) {
    auto number = static_cast<double>(x);
    whole(number, 0.0, count - 1.0);
    if (reading()) x = static_cast<T>(static_cast<int>(number));
  }
  void operator()(ContactKey& key);
  void operator()(Eigen::VectorXd& v);
  template <class T, std::size_t n>
  void operator()(std::array<T, n>& v) {
    for (T& x : v) (*this)(x);
  }
  /// A vector of anything that can be archived.
  template <class T>
  void operator()(std::vector<T>& v) {
    const std::size_t n = count(v.size());
    if (reading()) v.resize(n);
    for (T& x : v) (*this)(x);
  }
  /// Anything with `archive(NumberArchive&)`.
  template <class T>
  requires requires(T& x, NumberArchive& a) { x.archive(a); }
  void operator()(T& x) { x.archive(*this); }

 private:
  void whole(double& x, double least, double most);
  std::size_t count(std::size_t n);
  std::vector<double> numbers_;
  const Eigen::VectorXd* from_ = nullptr;
  Eigen::Index at_ = 0;
  bool good_ = true;
};

}  // namespace dynamy
