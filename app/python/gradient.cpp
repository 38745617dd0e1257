/// Derivatives of runs with respect to parameters, as arrays.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <dynamy/io/model/file_gradient.hpp>

#include "library.hpp"

namespace py = pybind11;

namespace dynamy::python {
namespace {

py::dict gradientOf(const std::string& file, const std::vector<std::string>& of,
                    const std::vector<std::string>& by, bool checks, double tolerance,
                    const py::kwargs& set) {
  FileGradient wanted{.file = file, .of = of, .by = by, .checks = checks, .tolerance = tolerance};
  for (const GivenValue& v : givenValues(set)) wanted.set.emplace_back(v.name, v.text);
  const Gradient g = gradient(wanted, library().registry, library().plugins);
  const auto n = static_cast<py::ssize_t>(g.values.size());
  const auto m = static_cast<py::ssize_t>(g.by.size());
  py::list names;
  py::array_t<double> at(n), value(n), error(n), d({n, m}), dError({n, m});
  for (py::ssize_t k = 0; k < n; ++k) {
    const GradientValue& v = g.values[static_cast<std::size_t>(k)];
    names.append(v.measure.empty() ? v.of : v.of + " " + v.measure);
    at.mutable_at(k) = v.at, value.mutable_at(k) = v.value, error.mutable_at(k) = v.error;
    for (py::ssize_t i = 0; i < m; ++i) {
      d.mutable_at(k, i) = v.d[static_cast<std::size_t>(i)];
      dError.mutable_at(k, i) = v.dError[static_cast<std::size_t>(i)];
    }
  }
  py::dict out, refused;
  for (std::size_t i = 0; i < g.by.size(); ++i)
    if (!g.refused[i].empty()) refused[py::str(g.by[i])] = g.refused[i];
  out["of"] = names, out["at"] = at, out["value"] = value, out["error"] = error;
  out["by"] = g.by, out["d"] = d, out["dError"] = dError, out["refused"] = refused;
  return out;
}

}  // namespace

void bindGradient(py::module_& m) {
  m.def("gradient", &gradientOf, py::arg("file"), py::arg("of") = std::vector<std::string>(),
        py::arg("by") = std::vector<std::string>(), py::arg("checks") = false,
        py::arg("tolerance") = 0.0,
        "Derivatives of signals (\"ball.z@0.6\") of a model file by parameters, as a dict: value "
        "and\n"
        "error of each signal, d[signal, parameter] and dError; refused: name -> why there is no\n"
        "derivative. Keywords replace parameters.");
}

}  // namespace dynamy::python
