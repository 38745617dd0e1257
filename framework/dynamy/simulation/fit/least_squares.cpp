#include <dlfcn.h>

#include <dynamy/core/error.hpp>
#include <dynamy/simulation/fit/least_squares.hpp>

namespace dynamy {
namespace {

/// It stands beside this library. It is never unloaded.
Minimiser* loadedMinimiser() {
  void* library = ::dlopen("libdynamy_optimiser.so", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw ModelError(std::string("the optimiser cannot be loaded: ") + ::dlerror(),
                     "install Ceres (libceres-dev) and build again");
  if (void* found = ::dlsym(library, "dynamyMinimise")) return reinterpret_cast<Minimiser*>(found);
  throw ModelError("the optimiser is that of another version");
}

}  // namespace

LeastSquaresEnd minimise(const LeastSquares& problem, Eigen::VectorXd& x) {
  static Minimiser* const minimiser = loadedMinimiser();
  LeastSquaresEnd end;
  minimiser(problem, x, end);
  return end;
}

}  // namespace dynamy
