/// The numbers that a value is written as.
#pragma once
#include <dynamy/core/number_archive.hpp>

namespace dynamy {

template <class T>
Eigen::VectorXd numbersOf(T value) {
  NumberArchive a;
  a(value);
  Eigen::VectorXd out;
  a.copyTo(out);
  return out;
}

}  // namespace dynamy
