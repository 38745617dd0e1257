/// Periodic orbits of model files.
#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <dynamy/io/model/file_orbit.hpp>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

py::dict orbitOf(const std::string& file, const std::string& section, double period, int returns,
                 const std::map<std::string, double>& start, double tolerance,
                 const py::kwargs& set) {
  FileOrbit wanted{.file = file,
                   .section = section,
                   .period = period,
                   .returns = returns,
                   .tolerance = tolerance};
  for (const GivenValue& v : givenValues(set)) wanted.set.emplace_back(v.name, v.text);
  for (const auto& [name, value] : start)
    wanted.start.emplace_back(name, py::str(py::float_(value)).cast<std::string>());
  const Orbit o = orbit(wanted, library().registry, library().plugins);
  py::array_t<std::complex<double>> multipliers(o.multipliers.size());
  for (py::ssize_t i = 0; i < o.multipliers.size(); ++i)
    multipliers.mutable_at(i) = o.multipliers[i];
  py::dict out, state, shift;
  for (const auto& [name, value] : o.state) state[py::str(name)] = value;
  for (const auto& [name, value] : o.shift) shift[py::str(name)] = value;
  out["period"] = o.period, out["period_error"] = o.periodError;
  out["section"] = o.section.text(), out["state"] = state, out["shift"] = shift;
  out["multipliers"] = multipliers, out["multiplier_error"] = o.multiplierError;
  out["zeros"] = o.zeros, out["residual"] = o.residual, out["newton"] = o.newton;
  return out;
}

}  // namespace

void bindOrbit(py::module_& m) {
  m.def(
      "orbit", &orbitOf, py::arg("file"), py::arg("section") = "", py::arg("period") = 0.0,
      py::arg("returns") = 0, py::arg("start") = std::map<std::string, double>(),
      py::arg("tolerance") = 0.0,
      "A periodic orbit of a model file, stable or not, as a dict: period, state at the section,\n"
      "shift of coordinates on which nothing depends, multipliers, number of zeros. section:\n"
      "\"toy.phiM=0-\"; period: of a forcing in place of a section; default: <orbit> of the "
      "model.\n"
      "Keywords replace parameters.");
}

}  // namespace dynamy::python
