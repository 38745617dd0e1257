#include <fmt/format.h>
#include <hdf5.h>
#include <zlib.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <dynamy/io/reference/libraries.hpp>
#include <dynamy/io/xml/xml.hpp>

namespace dynamy {

std::string libraryVersions() {
  return fmt::format("Eigen {}.{}.{}, Boost {}.{}.{}, HDF5 {}.{}.{}, zlib {}, {}, fmt {}.{}.{}",
                     EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
                     BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100,
                     H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE, ZLIB_VERSION, xmlParserText(),
                     FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100);
}

}  // namespace dynamy
