/// Basic number, vector and view types.
///
/// Views (`Vec`, `ConstVec`) are used in every virtual signature: they never copy and never
/// allocate. `Eigen::Ref<const …>` was rejected because it copies silently when strides do not
/// match.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace dynamy {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Vec = Eigen::Map<Eigen::VectorXd>;             ///< view of a vector that may be written
using ConstVec = Eigen::Map<const Eigen::VectorXd>;  ///< view of a vector that is only read
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Block = Eigen::Map<RowMatrix>;             ///< view of a small dense matrix, row after row
using ConstBlock = Eigen::Map<const RowMatrix>;  ///< view of such a matrix that is only read
using Mat3X = Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic>>;  ///< view, 3 × nu
using ConstMat3X =
    Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>>;  ///< view, 3 × nu, only read

/// View of `n` numbers of a vector from index `first`.
inline Vec slice(Eigen::VectorXd& v, Eigen::Index first, Eigen::Index n) {
  return {v.data() + first, n};
}
inline ConstVec slice(const Eigen::VectorXd& v, Eigen::Index first, Eigen::Index n) {
  return {v.data() + first, n};
}
inline ConstVec view(const Vec& v) { return {v.data(), v.size()}; }
inline ConstVec view(const Eigen::VectorXd& v) { return {v.data(), v.size()}; }
inline Vec view(Eigen::VectorXd& v) { return {v.data(), v.size()}; }

/// Identity of a contact over time: element, pair and feature. Warm starts and the order of
/// contacts are based on it (doc/architecture.md, 3).
struct ContactKey {
  std::uint64_t value = 0;
  auto operator<=>(const ContactKey&) const = default;
};

/// Stands for a contact where there is none.
inline constexpr ContactKey kNoContact{~std::uint64_t{0}};

}  // namespace dynamy
