#include <cmath>
#include <dynamy/core/number_archive.hpp>

namespace dynamy {
namespace {

constexpr int kNumberBits = 40;  ///< of a key: the number of the contact within its element
constexpr double kMostElements = 16777216.0, kMostNumbers = 1099511627776.0;  ///< 2²⁴, 2⁴⁰

}  // namespace

void NumberArchive::operator()(double& x) {
  if (!reading()) {
    numbers_.push_back(x);
    return;
  }
  good_ = good_ && at_ < from_->size();
  x = good_ ? (*from_)[at_++] : 0.0;
}

void NumberArchive::whole(double& x, double least, double most) {
  (*this)(x);
  if (!reading()) return;
  good_ = good_ && x >= least && x <= most && x == std::floor(x);
  if (!good_) x = 0.0;
}

std::size_t NumberArchive::count(std::size_t n) {
  auto number = static_cast<double>(n);
  // Every entry takes at least one number.
  whole(number, 0.0, reading() ? static_cast<double>(from_->size() - at_) : 0.0);
  return static_cast<std::size_t>(number);
}

void NumberArchive::operator()(ContactKey& key) {
  auto element = static_cast<double>(key.value >> kNumberBits);
  auto number = static_cast<double>(key.value & ((std::uint64_t{1} << kNumberBits) - 1));
  whole(element, 0.0, kMostElements - 1.0);
  whole(number, 0.0, kMostNumbers - 1.0);
  if (reading())
    key.value =
        static_cast<std::uint64_t>(element) << kNumberBits | static_cast<std::uint64_t>(number);
}

void NumberArchive::operator()(Eigen::VectorXd& v) {
  const std::size_t n = count(static_cast<std::size_t>(v.size()));
  if (!reading()) {
    numbers_.insert(numbers_.end(), v.begin(), v.end());
    return;
  }
  v.resize(static_cast<Eigen::Index>(n));
  for (Eigen::Index i = 0; i < v.size(); ++i) (*this)(v[i]);
}

}  // namespace dynamy
